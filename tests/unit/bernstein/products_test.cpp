// SPDX-License-Identifier: MIT
// Bernstein pieces: products, halves, and the search for the largest quotient.
#include "bernstein/products.h"
#include "pieces/largest_quotient.h"

#include "support/generators.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace products_test {

using namespace nrb;
using support::Random;

namespace {

// At one parameter for each axis, straight from the definition.
double value(const BernsteinShape &shape, const double *coefficients, const double *t, int component) {
    double sum = 0;
    for (int i = 0; i <= shape.degrees[0]; ++i) {
        for (int j = 0; j <= shape.degrees[1]; ++j) {
            for (int k = 0; k <= shape.degrees[2]; ++k) {
                const int index[] = {i, j, k};
                double basis = 1;
                for (size_t a = 0; a < 3; ++a) {
                    const int n = shape.degrees[a];
                    basis *=
                        binomial(n, index[a]) * std::pow(t[a], index[a]) * std::pow(1 - t[a], n - index[a]);
                }
                sum += basis * coefficients[component];
                coefficients += shape.width;
            }
        }
    }
    return sum;
}

std::vector<double> random_values(Random &random, int64_t n, double low, double high) {
    std::vector<double> values(static_cast<size_t>(n));
    for (double &x : values) {
        x = random.between(low, high);
    }
    return values;
}

BernsteinShape random_shape(Random &random, int width) {
    return {{random.whole(0, 2), random.whole(0, 3), random.whole(0, 4)}, width};
}

std::vector<double> scaled(std::vector<double> values, const BernsteinShape &shape) {
    const std::vector<double> factors = binomial_factors(shape);
    std::transform(values.begin(), values.end(), factors.begin(), values.begin(), std::multiplies<>());
    return values;
}

TEST(Bernstein, binomials_are_exact_and_rounded) {
    EXPECT_EQ(binomial(0, 0), 1);
    EXPECT_EQ(binomial(31, 15), 300540195);
    EXPECT_EQ(binomial(62, 31), 465428353255261088.0);
}

TEST(Bernstein, a_product_is_the_product_of_values) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const BernsteinShape a = random_shape(random, 2), b = random_shape(random, 1);
        const auto x = random_values(random, a.values(), -1, 1), y = random_values(random, b.values(), -1, 1);
        std::vector<double> product(static_cast<size_t>(product_shape(a, b).values()));
        add_convolution(a, scaled(x, a).data(), b, scaled(y, b).data(), product.data());
        const std::vector<double> factors = binomial_factors(product_shape(a, b));
        std::transform(product.begin(), product.end(), factors.begin(), product.begin(), std::divides<>());
        const auto t = random_values(random, 3, 0, 1);
        for (int c = 0; c < 2; ++c) {
            EXPECT_NEAR(value(product_shape(a, b), product.data(), t.data(), c),
                        value(a, x.data(), t.data(), c) * value(b, y.data(), t.data(), 0), 1e-13);
        }
    }
}

TEST(Bernstein, halves_are_the_whole) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const BernsteinShape shape = random_shape(random, 3);
        const auto whole = random_values(random, shape.values(), -1, 1);
        auto upper = whole, lower = whole;
        const int axis = random.whole(0, 2);
        halve(shape, axis, upper.data(), lower.data());
        const auto t = random_values(random, 3, 0, 1);
        for (int c = 0; c < 3; ++c) {
            auto below = t, above = t;
            below[static_cast<size_t>(axis)] = t[static_cast<size_t>(axis)] / 2;
            above[static_cast<size_t>(axis)] = 0.5 + t[static_cast<size_t>(axis)] / 2;
            EXPECT_NEAR(value(shape, lower.data(), t.data(), c), value(shape, whole.data(), below.data(), c),
                        1e-13);
            EXPECT_NEAR(value(shape, upper.data(), t.data(), c), value(shape, whole.data(), above.data(), c),
                        1e-13);
        }
    }
}

// 4 x (1 - x) / (1 + x) has its maximum 12 - 8 sqrt(2) at sqrt(2) - 1.
TEST(LargestQuotient, is_enclosed_as_closely_as_asked_for) {
    const pieces::PieceSource source = [](int64_t, pieces::QuotientPiece &piece) {
        piece.shape = {{0, 0, 2}, 1};
        piece.numerators = {0, 2, 0};
        piece.denominators = {1, 1.5, 2};
    };
    const double largest = 12 - 8 * std::sqrt(2.0);
    const auto uppers = pieces::quotient_uppers(3, source);
    EXPECT_EQ(uppers.size(), 3U);
    for (const double ratio : {0.25, 1e-3, 1e-9}) {
        const pieces::Enclosure found = pieces::largest_quotient(uppers, source, {ratio, 10000});
        EXPECT_LE(found.lower, largest);
        EXPECT_GE(found.upper, largest);
        EXPECT_LE(found.upper, (1 + ratio) * found.lower);
    }
}

TEST(LargestQuotient, a_denominator_with_a_zero_has_no_bound) {
    const pieces::PieceSource source = [](int64_t, pieces::QuotientPiece &piece) {
        piece.shape = {{0, 0, 1}, 1};
        piece.numerators = {1, 1};
        piece.denominators = {1, -1};
    };
    EXPECT_TRUE(std::isinf(largest_quotient(quotient_uppers(1, source), source).upper));
}

TEST(LargestQuotient, a_negative_denominator_is_one) {
    const pieces::PieceSource source = [](int64_t, pieces::QuotientPiece &piece) {
        piece.shape = {{0, 0, 1}, 2};
        piece.numerators = {3, 4, 3, 4};
        piece.denominators = {-1, -2};
    };
    const pieces::Enclosure found = pieces::largest_quotient(pieces::quotient_uppers(1, source), source);
    EXPECT_GE(found.upper, 5);
    EXPECT_LE(found.upper, 5 * (1 + 1e-14));
}

} // namespace

} // namespace products_test
