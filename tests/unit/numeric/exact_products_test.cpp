// SPDX-License-Identifier: MIT
#include "numeric/exact_products.h"

#include "reference/number.h"
#include "support/generators.h"

#include <cmath>
#include <gtest/gtest.h>

namespace exact_products_test {

using reference::exact;
using reference::Rational;

namespace {

int sign(const Rational &x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}

// Four numbers of which the two products agree, nearly agree, or have nothing in common.
struct Factors {
    double a, b, c, d;
};
Factors random_factors(support::Random &random) {
    Factors f{random.magnitude(1e-5, 1e5), random.magnitude(1e-5, 1e5), random.magnitude(1e-5, 1e5), 0};
    f.d = f.a * f.b / f.c;
    if (random.chance(40)) {
        const double k = random.whole(1, 1 << 26), l = random.whole(1, 1 << 26), m = random.whole(1, 1 << 26);
        f = {k * l, m, k * m, l};
    }
    for (int i = random.whole(0, 2); i > 0; --i) {
        double *const all[] = {&f.a, &f.b, &f.c, &f.d};
        double &x = *all[random.whole(0, 3)];
        x = random.chance(20) ? -x : std::nextafter(x, random.chance(50) ? 0 : INFINITY);
    }
    return f;
}

TEST(ExactProducts, are_compared_without_rounding) {
    support::Random random(560000);
    int ties = 0;
    for (int i = 0; i < 200000; ++i) {
        const auto [a, b, c, d] = random_factors(random);
        const Rational difference = exact(a) * exact(b) - exact(c) * exact(d);
        ASSERT_EQ(nrb::compare_products(a, b, c, d), sign(difference))
            << a << ' ' << b << ' ' << c << ' ' << d;
        ASSERT_LE(abs(exact(nrb::difference_of_products(a, b, c, d)) - difference),
                  abs(difference) * exact(1.5 * 0x1p-52));
        ties += difference == 0 ? 1 : 0;
    }
    EXPECT_GE(ties, 10000);
}

TEST(ExactProducts, are_compared_at_any_size) {
    EXPECT_EQ(nrb::compare_products(1e300, 1e300, 1e300, std::nextafter(1e300, INFINITY)), -1);
    EXPECT_EQ(nrb::compare_products(1e-320, 1e-320, 1e-320, 1e-320), 0);
    EXPECT_EQ(nrb::compare_products(0x1p-1074, 0x1p-1074, 0, 1e300), 1);
    EXPECT_EQ(nrb::compare_products(-1e200, 1e200, 1e-200, 1e-200), -1);
    EXPECT_EQ(nrb::compare_products(0.0, 5, -0.0, 7), 0);
}

} // namespace

} // namespace exact_products_test
