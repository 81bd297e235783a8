// SPDX-License-Identifier: MIT
#include "numeric/solvers/small_svd.h"

#include "support/generators.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace small_svd_test {

namespace {

std::vector<double> random_values(support::Random &random, size_t n) {
    std::vector<double> values(n);
    for (double &x : values) {
        x = random.between(-1, 1);
    }
    return values;
}

// Columns of sizes from 1 to 1e-8: each unknown comes out to rounding of its own size.
TEST(SmallSvd, solves_equations_with_columns_of_any_size) {
    support::Random random(561000);
    for (int i = 0; i < 200; ++i) {
        const size_t n = static_cast<size_t>(random.whole(1, 7)),
                     m = n + static_cast<size_t>(random.whole(8, 40));
        std::vector<double> rows = random_values(random, m * n), right(m, 0.0);
        const std::vector<double> x = random_values(random, n);
        for (size_t k = 0; k < m * n; ++k) {
            rows[k] *= std::pow(0.1, static_cast<double>(k % n));
            right[k / n] += rows[k] * x[k % n];
        }
        const std::vector<double> found = nrb::SmallSvd(rows, static_cast<int>(n), right).solution(1e-15);
        for (size_t k = 0; k < n; ++k) {
            ASSERT_NEAR(found[k], x[k], 1e-13 * std::pow(10, static_cast<double>(k))) << "case " << i;
        }
    }
}

TEST(SmallSvd, finds_the_direction_that_vanishes) {
    support::Random random(562000);
    for (int i = 0; i < 200; ++i) {
        const size_t n = static_cast<size_t>(random.whole(2, 7)),
                     m = static_cast<size_t>(random.whole(1, 40));
        const std::vector<double> normal = random_values(random, n);
        std::vector<double> rows = random_values(random, m * n);
        double square = 0;
        for (const double x : normal) {
            square += x * x;
        }
        for (size_t r = 0; r < m; ++r) { // across the normal
            double part = 0;
            for (size_t k = 0; k < n; ++k) {
                part += rows[r * n + k] * normal[k] / square;
            }
            for (size_t k = 0; k < n; ++k) {
                rows[r * n + k] -= part * normal[k];
            }
        }
        const std::vector<double> found = nrb::SmallSvd(rows, static_cast<int>(n)).direction(0);
        double length = 0;
        for (const double x : found) {
            length += x * x;
        }
        ASSERT_NEAR(length, 1, 1e-14);
        for (size_t r = 0; r < m; ++r) {
            double part = 0;
            for (size_t k = 0; k < n; ++k) {
                part += rows[r * n + k] * found[k];
            }
            ASSERT_NEAR(part, 0, 1e-14) << "case " << i;
        }
    }
}

// Dependent equations: the shortest solution.
TEST(SmallSvd, takes_the_shortest_solution) {
    const std::vector<double> x = nrb::SmallSvd({1, 1, 2, 2}, 2, {2, 4}).solution(1e-12);
    EXPECT_NEAR(x[0], 1, 1e-15);
    EXPECT_NEAR(x[1], 1, 1e-15);
    EXPECT_EQ(nrb::SmallSvd({0, 0}, 2, {1}).solution(1e-12), (std::vector<double>{0, 0}));
}

TEST(SmallSvd, what_is_not_finite_stays_so) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_TRUE(std::isnan(nrb::SmallSvd({1, 2, bad, 4}, 2, {1, 2}).solution(0)[1]));
        EXPECT_TRUE(std::isnan(nrb::SmallSvd({1, 2, 3, 4}, 2, {bad, 2}).solution(0)[0]));
        EXPECT_TRUE(std::isnan(nrb::SmallSvd({1, 2, bad, 4}, 2).direction(0)[0]));
    }
}

TEST(SmallSvd, squares_that_overflow_are_not_finite) {
    EXPECT_TRUE(std::isnan(nrb::SmallSvd({1e300, 2e300, 3e300, 1e300}, 2, {1, 2}).solution(1e-12)[0]));
    EXPECT_TRUE(std::isnan(nrb::SmallSvd({1e300, 2e300, 3e300, 1e300}, 2).direction(0)[0]));
}

} // namespace

} // namespace small_svd_test
