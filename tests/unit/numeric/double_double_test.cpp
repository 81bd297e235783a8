// SPDX-License-Identifier: MIT
// Values of twice the precision against exact arithmetic.
#include "numeric/double_double.h"
#include "reference/number.h"
#include "support/generators.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace double_double_test {

using nrb::DoubleDouble;
using reference::exact;
using reference::Rational;
using support::Random;

namespace {

Rational value_of(const DoubleDouble &x) {
    return exact(x.high) + exact(x.low);
}

// A double and a rest of at most half a unit of its rounding.
DoubleDouble random_wide(Random &random) {
    const double high = random.magnitude(1e-9, 1e9) * (random.chance(50) ? 1 : -1);
    return DoubleDouble::sum(high, random.chance(20) ? 0 : high * 0x1p-53 * random.between(-0.9, 0.9));
}

// |x - want| in units of 2^-102 of a size.
long double error(const DoubleDouble &x, const Rational &want, const Rational &size) {
    const Rational part = abs(Rational(value_of(x) - want)) / size;
    return std::ldexp(reference::quotient(numerator(part), denominator(part)), 102);
}

void expect_normal(const DoubleDouble &x) {
    EXPECT_EQ(x.high, x.high + x.low);
}

TEST(DoubleDouble, operations_are_within_their_bound) {
    Random random(741000);
    for (int i = 0; i < 20000; ++i) {
        const DoubleDouble a = random_wide(random);
        const DoubleDouble b = random.chance(30) ? DoubleDouble(-a.high, random.chance(50) ? a.low : -a.low)
                                                 : random_wide(random);
        const Rational x = value_of(a), y = value_of(b);
        EXPECT_LE(error(a + b, x + y, abs(x) + abs(y)), 1);
        EXPECT_LE(error(a - b, x - y, abs(x) + abs(y)), 1);
        EXPECT_LE(error(a * b, x * y, abs(Rational(x * y))), 1);
        EXPECT_LE(error(a / b, x / y, abs(Rational(x / y))), 1);
        for (const DoubleDouble &made : {a + b, a - b, a * b, a / b}) {
            expect_normal(made);
        }
    }
}

TEST(DoubleDouble, sums_and_products_of_doubles_are_exact) {
    Random random(742000);
    for (int i = 0; i < 20000; ++i) {
        const double a = random_wide(random).high, b = random_wide(random).high;
        EXPECT_EQ(value_of(DoubleDouble::sum(a, b)), exact(a) + exact(b));
        EXPECT_EQ(value_of(DoubleDouble::product(a, b)), exact(a) * exact(b));
        const double low = std::min(std::fabs(a), std::fabs(b)), high = std::max(std::fabs(a), std::fabs(b));
        EXPECT_EQ(value_of(DoubleDouble::ordered_sum(high, low)), exact(high) + exact(low));
    }
}

// r^2 is within twice the bound of x.
TEST(DoubleDouble, square_roots) {
    Random random(743000);
    for (int i = 0; i < 20000; ++i) {
        const DoubleDouble a = random_wide(random), square = a * a, root = square_root(square);
        const Rational r = value_of(root), x = value_of(square);
        EXPECT_LE(error(DoubleDouble(), Rational(r * r - x), x), 2);
        expect_normal(root);
    }
    EXPECT_EQ(square_root(DoubleDouble()).value(), 0);
    EXPECT_EQ(square_root(DoubleDouble(4)).value(), 2);
}

} // namespace

} // namespace double_double_test
