// SPDX-License-Identifier: MIT
// de Casteljau's algorithm and the Bernstein functions, against their definition.
#include "bernstein/de_casteljau.h"

#include "base/numbers.h"
#include "numeric/binomial.h"
#include "support/generators.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace de_casteljau_test {

using namespace nrb;
using support::Random;

namespace {

double function_at(int degree, int i, double t) {
    return i < 0 || i > degree ? 0 : binomial(degree, i) * std::pow(t, i) * std::pow(1 - t, degree - i);
}

// Of order k: differences of functions of degree - k.
double derivative_at(int degree, int i, int order, double t) {
    return order == 0 ? function_at(degree, i, t)
                      : degree * (derivative_at(degree - 1, i - 1, order - 1, t) -
                                  derivative_at(degree - 1, i, order - 1, t));
}

std::vector<double> random_values(Random &random, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        values.push_back(random.between(-1, 1));
    }
    return values;
}

double value_at(const std::vector<double> &coefficients, int degree, double t) {
    double sum = 0;
    for (int i = 0; i <= degree; ++i) {
        sum += coefficients[static_cast<size_t>(i)] * function_at(degree, i, t);
    }
    return sum;
}

TEST(DeCasteljau, values_and_parts_are_those_of_the_polynomial) {
    Random random(3);
    for (int degree = 0; degree <= 9; ++degree) {
        const std::vector<double> whole = random_values(random, degree + 1);
        for (const double t : {0.0, 0.25, 0.5, 0.9, 1.0}) {
            std::vector<double> at = whole, upper = whole, lower(whole.size());
            evaluate(degree, 1, t, at.data());
            EXPECT_NEAR(at[0], value_at(whole, degree, t), 50 * eps);
            subdivide(degree, 1, t, upper.data(), lower.data());
            EXPECT_EQ(upper.front(), at[0]);
            EXPECT_EQ(lower.back(), at[0]);
            for (const double x : {0.0, 0.3, 1.0}) {
                EXPECT_NEAR(value_at(lower, degree, x), value_at(whole, degree, x * t), 50 * eps);
                EXPECT_NEAR(value_at(upper, degree, x), value_at(whole, degree, t + x * (1 - t)), 50 * eps);
            }
        }
    }
}

TEST(DeCasteljau, values_side_by_side_are_combined_alike) {
    Random random(4);
    const std::vector<double> first = random_values(random, 4), second = random_values(random, 4);
    std::vector<double> both, one = first, lower(4), lowers(8);
    for (size_t i = 0; i < 4; ++i) {
        both.insert(both.end(), {first[i], second[i]});
    }
    subdivide(3, 1, 0.375, one.data(), lower.data());
    subdivide(3, 2, 0.375, both.data(), lowers.data());
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(both[2 * i], one[i]);
        EXPECT_EQ(lowers[2 * i], lower[i]);
    }
}

TEST(DeCasteljau, restriction_keeps_the_polynomial) {
    Random random(5);
    for (int degree = 0; degree <= 9; ++degree) {
        const std::vector<double> whole = random_values(random, degree + 1);
        for (const auto &[lower, upper] : {std::pair{0.0, 1.0}, {0.0, 0.5}, {0.25, 1.0}, {0.125, 0.75}}) {
            std::vector<double> part = whole;
            restrict_to(degree, lower, upper, part.data());
            for (const double x : {0.0, 0.3, 1.0}) {
                const double t = lower + x * (upper - lower);
                EXPECT_NEAR(value_at(part, degree, x), value_at(whole, degree, t), 50 * eps);
            }
        }
    }
}

TEST(DeCasteljau, functions_and_derivatives_are_those_of_the_definition) {
    constexpr int stride = 16;
    for (int degree = 0; degree <= 12; ++degree) {
        for (const double t : {0.0, 0.1, 0.5, 0.8, 1.0}) {
            for (int order = 0; order <= 2; ++order) {
                double rows[3 * stride], values[stride];
                std::fill(std::begin(rows), std::end(rows), 99.0);
                bernstein_functions(degree, t, order, stride, rows);
                bernstein_functions(degree, t, values);
                for (int i = 0; i <= degree; ++i) {
                    EXPECT_EQ(rows[i], values[i]);
                    for (int k = 0; k <= order; ++k) {
                        EXPECT_NEAR(rows[k * stride + i], derivative_at(degree, i, k, t),
                                    100 * eps * std::pow(degree, k) + 1e-300)
                            << degree << " " << i << " " << k << " " << t;
                    }
                }
            }
        }
    }
}

} // namespace

} // namespace de_casteljau_test
