// SPDX-License-Identifier: MIT
#include "numeric/nested_rule.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <vector>

namespace nested_rule_test {

using namespace nrb;

namespace {

constexpr double eps = 0x1p-52;

double rule_sum(int level, const std::vector<double> &values) {
    long double sum = 0;
    for (int i = 0; i < rule_size(level); ++i) {
        sum += static_cast<long double>(rule_weights(level)[i]) * values[static_cast<size_t>(i)];
    }
    return static_cast<double>(sum);
}

std::vector<double> values_of(double (*f)(double)) {
    std::vector<double> values;
    for (int i = 0; i < rule_capacity; ++i) {
        values.push_back(f(rule_places()[i]));
    }
    return values;
}

RuleDecay rule_decay(int level, const double *values) {
    std::array<double, decay_sums> sums{};
    for (size_t row = 0; row < sums.size(); ++row) {
        sums[row] = std::inner_product(values, values + rule_size(level),
                                       decay_rows[static_cast<size_t>(level)][row], 0.0);
    }
    return decay_of(sums);
}

} // namespace

TEST(NestedRule, integrates_polynomials_up_to_its_exactness) {
    for (int level = 0; level < rule_levels; ++level) {
        for (int power = 0; power <= rule_exactness(level); ++power) {
            std::vector<double> low, high;
            for (int i = 0; i < rule_capacity; ++i) {
                low.push_back(std::pow(rule_rests()[i], power));
                high.push_back(std::pow(rule_places()[i], power));
            }
            EXPECT_NEAR(rule_sum(level, high) * (power + 1), 1, 16 * eps) << level << ' ' << power;
            EXPECT_NEAR(rule_sum(level, low) * (power + 1), 1, 16 * eps) << level << ' ' << power;
        }
        std::vector<double> beyond; // (2 x - 1)^(2 n) is not integrated any more
        for (int i = 0; i < rule_capacity; ++i) {
            beyond.push_back(std::pow(2 * rule_places()[i] - 1, rule_exactness(level) + 1));
        }
        const double exact = 1.0 / (rule_exactness(level) + 2);
        EXPECT_GT(std::fabs(rule_sum(level, beyond) - exact), level < 3 ? 1e-9 : 0.0);
    }
}

TEST(NestedRule, weights_are_positive_or_of_other_levels) {
    for (int level = 0; level < rule_levels; ++level) {
        int nodes = 0;
        for (int i = 0; i < rule_size(level); ++i) {
            EXPECT_GE(rule_weights(level)[i], 0);
            nodes += rule_weights(level)[i] > 0 ? 1 : 0;
            EXPECT_NEAR(rule_places()[i] + rule_rests()[i], 1, eps);
        }
        EXPECT_EQ(nodes, (4 << level) - 1);
    }
}

TEST(NestedRule, basis_is_a_partition_of_unity) {
    for (const int degree : {0, 1, 2, 5, 31, 60}) {
        std::vector<double> values(static_cast<size_t>((degree + 1) * rule_capacity)), slopes = values;
        rule_basis(degree, values.data());
        rule_basis_derivatives(degree, slopes.data());
        for (int i = 0; i < rule_capacity; ++i) {
            double sum = 0, slope = 0, mean = 0;
            for (int j = 0; j <= degree; ++j) {
                const auto at = static_cast<size_t>(j * rule_capacity + i);
                sum += values[at];
                slope += slopes[at];
                mean += j * slopes[at];
            }
            EXPECT_NEAR(sum, 1, (degree + 4) * eps);
            EXPECT_NEAR(slope, 0, 8 * (degree + 1) * eps * degree);
            EXPECT_NEAR(mean, degree,
                        8 * (degree + 1) * (degree + 1) * eps * degree); // t has the points j / degree
        }
    }
}

// Errors are neither missed nor far overestimated, where functions are analytic and where they are not.
TEST(NestedRule, errors_of_analytic_functions_and_of_kinks) {
    const auto near_pole = values_of([](double x) { return 1 / (x + 0.3); });
    const auto kink = values_of([](double x) { return std::fabs(x - 0.37); });
    const double smooth = std::log(1.3 / 0.3), bent = (0.37 * 0.37 + 0.63 * 0.63) / 2;
    for (int level = 2; level < rule_levels; ++level) {
        const RuleDecay a = rule_decay(level, near_pole.data()), b = rule_decay(level, kink.data());
        EXPECT_NEAR(a.integral, rule_sum(level, near_pole), 8 * eps);
        EXPECT_GE(a.error(a.integral) + 16 * eps, std::fabs(a.integral - smooth)) << level;
        EXPECT_GE(20 * b.error(b.integral), std::fabs(b.integral - bent)) << level;
        EXPECT_LE(b.error(b.integral), 100 * std::fabs(b.integral - bent)) << level;
    }
    EXPECT_EQ(rule_decay(4, near_pole.data()).error(smooth), 0);
    EXPECT_GT(rule_decay(2, near_pole.data()).error(smooth), 0);
}

} // namespace nested_rule_test
