// SPDX-License-Identifier: MIT
// Polynomials with bounds of their rounding errors against exact arithmetic.
#include "bernstein/rounded_polynomial.h"
#include "pieces/derivative_pieces.h"
#include "reference/quotients.h"
#include "support/cases.h"

#include <cmath>
#include <gtest/gtest.h>

namespace rounded_polynomial_test {

namespace {

using nrb::RoundedPolynomial;
using reference::exact;
using reference::Polynomial;
using reference::Rational;

RoundedPolynomial random_polynomial(support::Random &random, int degree) {
    RoundedPolynomial a;
    a.shape.degrees = {0, 0, degree};
    for (int i = 0; i <= degree; ++i) {
        a.values.push_back(random.between(-1, 1) * random.magnitude(1e-3, 1e3));
        a.errors.push_back(0);
    }
    return a;
}

Polynomial exactly(const RoundedPolynomial &a) {
    Polynomial result;
    for (const double x : a.values) {
        result.push_back(exact(x));
    }
    return result;
}

// The largest error over its bound.
long double worst_error(const RoundedPolynomial &a, const Polynomial &expected) {
    EXPECT_EQ(a.values.size(), expected.size());
    long double worst = 0;
    for (size_t i = 0; i < a.values.size(); ++i) {
        const Rational off = abs(exact(a.values[i]) - expected[i]);
        const long double error = reference::quotient(numerator(off), denominator(off));
        worst = std::max(worst, error == 0 ? 0 : error / a.error(i));
    }
    return worst;
}

Rational choose(size_t n, size_t k) {
    reference::Integer result = 1;
    for (size_t i = 1; i <= k; ++i) {
        result = result * (n + 1 - i) / i;
    }
    return result;
}

// Of any degrees.
Polynomial times(const Polynomial &a, const Polynomial &b) {
    const size_t p = a.size() - 1, q = b.size() - 1;
    Polynomial result(p + q + 1);
    for (size_t i = 0; i <= p; ++i) {
        for (size_t j = 0; j <= q; ++j) {
            result[i + j] += choose(p, i) * choose(q, j) / choose(p + q, i + j) * a[i] * b[j];
        }
    }
    return result;
}

Polynomial minus(Polynomial a, const Polynomial &b) {
    const Polynomial raised = times(b, Polynomial(a.size() - b.size() + 1, Rational(1)));
    for (size_t i = 0; i < a.size(); ++i) {
        a[i] -= raised[i];
    }
    return a;
}

Polynomial derived(const Polynomial &a) {
    Polynomial result;
    for (size_t i = 0; i + 1 < a.size(); ++i) {
        result.push_back(Rational(a.size() - 1) * (a[i + 1] - a[i]));
    }
    return result;
}

} // namespace

// Sums, differences, products and derivatives, nested as the numerators of curvatures are, up to degrees for
// which no table of binomials exists.
TEST(RoundedPolynomial, errors_are_within_their_bounds) {
    long double worst = 0;
    support::for_each_case(6700, 60, [&](support::Random &random, uint64_t) {
        const RoundedPolynomial a = random_polynomial(random, random.whole(0, 20)),
                                b = random_polynomial(random, random.whole(0, 20));
        const Polynomial x = exactly(a), y = exactly(b);
        const RoundedPolynomial product = a * b, square = product * product;
        const Polynomial xy = times(x, y), fourth = times(xy, xy);
        worst = std::max(worst, worst_error(product, xy));
        worst = std::max(worst, worst_error(square, fourth));
        worst = std::max(worst, worst_error(square * a - product, minus(times(fourth, x), xy)));
        if (xy.size() > 1) {
            worst = std::max(worst, worst_error(nrb::derivative(product, 2), derived(xy)));
        }
    });
    EXPECT_LE(worst, 1);
    EXPECT_GT(worst, 1e-3L); // the bounds are not idle
}

TEST(RoundedPolynomial, parts_are_within_their_bounds) {
    support::for_each_case(6800, 60, [&](support::Random &random, uint64_t) {
        RoundedPolynomial upper = random_polynomial(random, random.whole(1, 20));
        Polynomial high = exactly(upper), low;
        const double place = random.unit();
        const RoundedPolynomial lower = nrb::split(upper, 2, place);
        const size_t n = high.size();
        for (size_t r = 0; r < n; ++r) {
            low.push_back(high[0]);
            for (size_t j = 0; j + 1 < n - r; ++j) {
                high[j] = (1 - exact(place)) * high[j] + exact(place) * high[j + 1];
            }
        }
        EXPECT_LE(worst_error(lower, low), 1);
        EXPECT_LE(worst_error(upper, high), 1);
    });
}

// x^2 (1 - x) q over x^2 (1 - x) is q.
TEST(RoundedPolynomial, values_are_where_parts_meet) {
    const RoundedPolynomial whole{
        {{2, 0, 1}, 2}, {1, 2, 3, 5, 8, 13, -1, 0, 2, 7, 1, 4}, std::vector<double>(12, 1e-9)};
    for (const int axis : {0, 2}) {
        RoundedPolynomial upper = whole;
        split(upper, axis, 0.375);
        const RoundedPolynomial want = end_value(upper, axis, false), found = value_at(whole, axis, 0.375);
        EXPECT_EQ(found.shape.degrees, want.shape.degrees);
        EXPECT_EQ(found.values, want.values);
        EXPECT_EQ(found.errors, want.errors);
    }
}

TEST(RoundedPolynomial, zeros_at_ends_are_divided_out) {
    support::for_each_case(6900, 40, [&](support::Random &random, uint64_t) {
        RoundedPolynomial q = random_polynomial(random, random.whole(0, 12));
        const auto side = [](double a, double b) {
            return RoundedPolynomial{{{0, 0, 1}, 1}, {a, b}, {0, 0}};
        };
        RoundedPolynomial a = q * side(0, 1) * side(0, 1) * side(1, 0);
        EXPECT_EQ(nrb::divide_end(a, 2, false), 2);
        EXPECT_EQ(nrb::divide_end(a, 2, true), 1);
        EXPECT_LE(worst_error(a, exactly(q)), 1);
    });
    RoundedPolynomial zero{{{0, 0, 3}, 1}, {0, 0, 0, 0}, {1, 1, 1, 1}};
    EXPECT_EQ(nrb::divide_end(zero, 2, false), -1);
}

TEST(RoundedPolynomial, signs_that_rounding_hides_are_none) {
    RoundedPolynomial a{{{0, 0, 1}, 1}, {1, 1e-15}, {1e-16, 1e-16}};
    EXPECT_EQ(nrb::certain_sign(a), 1);
    a.errors[1] = 1e-15;
    EXPECT_EQ(nrb::certain_sign(a), 0);
    EXPECT_EQ(a.sign(0), 1);
    EXPECT_EQ(a.sign(1), 0);
}

} // namespace rounded_polynomial_test
