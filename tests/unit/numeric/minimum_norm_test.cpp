// SPDX-License-Identifier: MIT
#include "numeric/solvers/sparse/minimum_norm.h"

#include "base/error.h"
#include "base/numbers.h"
#include "support/generators.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace minimum_norm_test {

using namespace nrb;

namespace {

// Rows of a few neighbouring elements, some of them of far apart ones.
SparseRows random_rows(support::Random &random, int64_t count, int64_t unknowns, int width) {
    SparseRows rows;
    for (int64_t i = 0; i < count; ++i) {
        const bool wide = random.chance(10);
        const int64_t first = random.whole(0, static_cast<int>(unknowns) - width);
        for (int j = 0; j < width; ++j) {
            rows.add(wide ? random.whole(0, static_cast<int>(unknowns) - 1) : first + j,
                     random.between(-1, 1));
        }
        EXPECT_GT(rows.end_row(), 0);
    }
    return rows;
}

double row_times(const SparseRows &rows, int64_t row, const std::vector<double> &x, int64_t width,
                 int64_t c) {
    double sum = 0;
    for (size_t i = 0; i < rows.columns(row).size(); ++i) {
        sum += rows.values(row)[i] * x[static_cast<size_t>(rows.columns(row)[i] * width + c)];
    }
    return sum;
}

double largest(const std::vector<double> &x) {
    return std::accumulate(x.begin(), x.end(), 0.0,
                           [](double a, double b) { return std::max(a, std::abs(b)); });
}

std::vector<double> random_vector(support::Random &random, int64_t size) {
    std::vector<double> x(static_cast<size_t>(size));
    std::ranges::generate(x, [&] { return random.between(-1, 1); });
    return x;
}

} // namespace

TEST(SparseRows, elements_are_sorted_and_added_and_rows_scaled) {
    SparseRows rows;
    rows.add(7, 1);
    rows.add(2, 4);
    rows.add(7, 2);
    EXPECT_EQ(rows.end_row(), 5);
    EXPECT_EQ(rows.end_row(), 0); // an empty one
    ASSERT_EQ(rows.size(), 2);
    EXPECT_TRUE(std::ranges::equal(rows.columns(0), std::vector<int64_t>{2, 7}));
    EXPECT_TRUE(std::ranges::equal(rows.values(0), std::vector<double>{0.8, 0.6}));
    EXPECT_TRUE(rows.columns(1).empty());
}

// The equations hold, and the solution is a combination of the rows: so it is the shortest.
TEST(MinimumNorm, solutions_are_combinations_of_the_rows_that_fulfil_the_equations) {
    support::Random random(1);
    for (const auto &[count, unknowns, width] : std::vector<std::array<int, 3>>{
             {1, 1, 1}, {1, 9, 4}, {5, 40, 4}, {12, 30, 4}, {60, 100, 6}, {20, 200, 1}}) {
        const SparseRows rows = random_rows(random, count, unknowns, width);
        const MinimumNorm solver(rows, unknowns, 1e-12);
        const bool full = solver.rank() == count;
        const std::vector<double> wanted = random_vector(random, unknowns * 2);
        std::vector<double> right;
        for (int64_t i = 0; i < count; ++i) {
            right.push_back(row_times(rows, i, wanted, 2, 0));
            right.push_back(row_times(rows, i, wanted, 2, 1));
        }
        const std::vector<double> x = solver.solve(right, 2);
        std::vector<double> first(static_cast<size_t>(unknowns));
        for (int64_t i = 0; i < unknowns; ++i) {
            first[static_cast<size_t>(i)] = x[static_cast<size_t>(2 * i)];
        }
        const double bound = 1e4 * eps * std::max(1.0, largest(x)); // conditions are random
        for (int64_t i = 0; i < count; ++i) {
            EXPECT_NEAR(row_times(rows, i, x, 2, 0), right[static_cast<size_t>(2 * i)], bound);
            EXPECT_NEAR(row_times(rows, i, x, 2, 1), right[static_cast<size_t>(2 * i + 1)], bound);
        }
        const MinimumNorm::Multipliers multipliers = solver.multipliers(first);
        EXPECT_LE(multipliers.rest, bound * unknowns);
        std::vector<double> sum(first.size());
        for (int64_t i = 0; full && i < count; ++i) {
            for (size_t j = 0; j < rows.columns(i).size(); ++j) {
                sum[static_cast<size_t>(rows.columns(i)[j])] +=
                    rows.values(i)[j] * multipliers.values[static_cast<size_t>(i)];
            }
        }
        for (size_t i = 0; full && i < sum.size(); ++i) {
            EXPECT_NEAR(sum[i], first[i], 1e3 * bound * std::max(1.0, largest(multipliers.values)));
        }
    }
}

TEST(MinimumNorm, rows_that_follow_from_others_do_not_count) {
    support::Random random(2);
    SparseRows rows;
    for (int64_t i = 0; i < 20; ++i) { // each twice, and their sums
        const double a = random.between(1, 2), b = random.between(1, 2);
        for (int copy = 0; copy < 2; ++copy) {
            rows.add(2 * i, a);
            rows.add(2 * i + 1, b);
            rows.end_row();
        }
        if (i > 0) {
            for (size_t j = 0; j < 2; ++j) {
                rows.add(rows.columns(0)[j] + 2 * i, rows.values(rows.size() - 1)[j]);
                rows.add(rows.columns(0)[j], rows.values(0)[j]);
            }
            rows.end_row();
        }
    }
    const MinimumNorm solver(rows, 40, 1e-13);
    EXPECT_EQ(solver.rank(), 20);
    const std::vector<double> wanted = random_vector(random, 40);
    std::vector<double> right;
    for (int64_t i = 0; i < rows.size(); ++i) {
        right.push_back(row_times(rows, i, wanted, 1, 0));
    }
    const std::vector<double> x = solver.solve(right, 1);
    for (int64_t i = 0; i < rows.size(); ++i) {
        EXPECT_NEAR(row_times(rows, i, x, 1, 0), right[static_cast<size_t>(i)], 64 * eps);
    }
}

TEST(MinimumNorm, what_is_left_of_a_vector_is_perpendicular_to_the_rows) {
    support::Random random(3);
    const SparseRows rows = random_rows(random, 30, 80, 5);
    const MinimumNorm solver(rows, 80, 1e-12);
    const std::vector<double> x = random_vector(random, 80), rest = solver.kernel_part(x);
    for (int64_t i = 0; i < rows.size(); ++i) {
        EXPECT_NEAR(row_times(rows, i, rest, 1, 0), 0, 1e3 * eps);
    }
    const std::vector<double> again = solver.kernel_part(rest);
    for (size_t i = 0; i < rest.size(); ++i) {
        EXPECT_NEAR(again[i], rest[i], 100 * eps);
    }
}

TEST(MinimumNorm, elements_have_to_be_finite) {
    SparseRows rows;
    rows.add(0, infinity);
    rows.end_row();
    EXPECT_THROW(MinimumNorm(rows, 3, 1e-12), Error);
}

} // namespace minimum_norm_test
