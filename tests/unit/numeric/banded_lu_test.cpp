// Banded systems: solutions, widths, and matrices that are refused.
#include "numeric/solvers/banded/banded_lu.h"

#include "support/generators.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace banded_lu_test {

using nrb::BandedLu;

namespace {

// 1 4 1 in every row, whose factors are far from 0.
BandedLu spline_matrix(int64_t rows) {
    BandedLu matrix(rows, 1, 1);
    for (int64_t i = 0; i < rows; ++i) {
        double *const row = matrix.row(i);
        row[0] = i == 0 ? 0 : 1;
        row[1] = 4;
        row[2] = i + 1 == rows ? 0 : 1;
    }
    return matrix;
}

bool factor(BandedLu &matrix, int64_t rows) {
    bool all = true;
    for (int64_t i = 0; i < rows && all; ++i) {
        all = matrix.factor_row(i);
    }
    return all;
}

// Of every width, and of fewer rows than that.
TEST(BandedLu, solves_bands_of_every_width) {
    support::Random random(930400);
    for (int i = 0; i < 300; ++i) {
        const int below = random.whole(0, 4), above = random.whole(0, 4), rows = random.whole(1, 12);
        BandedLu matrix(rows, below, above);
        std::vector<double> x(static_cast<size_t>(rows)), y(x.size(), 0.0);
        std::ranges::generate(x, [&] { return random.between(-1, 1); });
        for (int r = 0; r < rows; ++r) {
            for (int c = std::max(0, r - below); c <= std::min(rows - 1, r + above); ++c) {
                const double value = random.between(0, 1) + (r == c ? 10 : 0);
                matrix.row(r)[c - r + below] = value;
                y[static_cast<size_t>(r)] += value * x[static_cast<size_t>(c)];
            }
        }
        ASSERT_TRUE(factor(matrix, rows));
        matrix.solve(y.data(), 1);
        for (size_t r = 0; r < x.size(); ++r) {
            ASSERT_NEAR(y[r], x[r], 1e-14) << below << ' ' << above << ' ' << rows;
        }
    }
}

TEST(BandedLu, solves_and_treats_every_column_alike) {
    constexpr int64_t rows = 40;
    BandedLu matrix = spline_matrix(rows);
    ASSERT_TRUE(factor(matrix, rows));
    const auto solution = [](int64_t i, int64_t c) { return static_cast<double>((i * 7 + c * 3) % 11) - 5; };
    std::vector<double> narrow;
    for (const int64_t width : {1, 2, 3, 4, 5, 300}) {
        std::vector<double> values;
        for (int64_t i = 0; i < rows; ++i) {
            for (int64_t c = 0; c < width; ++c) {
                const double before = i > 0 ? solution(i - 1, c) : 0,
                             after = i + 1 < rows ? solution(i + 1, c) : 0;
                values.push_back(before + 4 * solution(i, c) + after);
            }
        }
        matrix.solve(values.data(), width);
        for (int64_t i = 0; i < rows; ++i) {
            for (int64_t c = 0; c < width; ++c) {
                ASSERT_NEAR(values[static_cast<size_t>(i * width + c)], solution(i, c), 1e-14) << width;
            }
            if (width == 1) {
                narrow.push_back(values[static_cast<size_t>(i)]);
            }
            ASSERT_EQ(values[static_cast<size_t>(i * width)], narrow[static_cast<size_t>(i)]) << width;
        }
    }
}

// Entry (i, j) of a matrix that is not symmetric, 2 below and 1 above its diagonal.
double entry(int64_t i, int64_t j) {
    return j < i - 2 || j > i + 1 ? 0 : i == j ? 5 : static_cast<double>((3 * i + 5 * j) % 7) / 4;
}

TEST(BandedLu, solves_the_transposed_equations) {
    constexpr int64_t rows = 30, width = 3;
    BandedLu matrix(rows, 2, 1);
    for (int64_t i = 0; i < rows; ++i) {
        for (int64_t j = std::max<int64_t>(0, i - 2); j <= std::min<int64_t>(rows - 1, i + 1); ++j) {
            matrix.row(i)[j - i + 2] = entry(i, j);
        }
    }
    ASSERT_TRUE(factor(matrix, rows));
    const auto solution = [](int64_t i, int64_t c) { return static_cast<double>((i * 7 + c * 3) % 11) - 5; };
    std::vector<double> values;
    for (int64_t j = 0; j < rows; ++j) {
        for (int64_t c = 0; c < width; ++c) {
            double sum = 0;
            for (int64_t i = 0; i < rows; ++i) {
                sum += entry(i, j) * solution(i, c);
            }
            values.push_back(sum);
        }
    }
    matrix.solve_transposed(values.data(), width);
    for (int64_t i = 0; i < rows * width; ++i) {
        ASSERT_NEAR(values[static_cast<size_t>(i)], solution(i / width, i % width), 1e-13) << i;
    }
}

TEST(BandedLu, refuses_what_it_cannot_solve) {
    BandedLu zero(2, 1, 1);
    zero.row(0)[1] = 0;
    EXPECT_FALSE(factor(zero, 2));
    BandedLu dependent(2, 1, 1); // 1 1, 1 1
    dependent.row(0)[1] = dependent.row(0)[2] = dependent.row(1)[0] = dependent.row(1)[1] = 1;
    EXPECT_FALSE(factor(dependent, 2));
}

// 2^-40 1, 1 1: without an exchange of rows nothing is left of the second one.
TEST(BandedLu, sees_a_growth_that_loses_digits) {
    const auto make = [] {
        BandedLu matrix(2, 1, 1);
        matrix.row(0)[1] = 0x1p-40;
        matrix.row(0)[2] = matrix.row(1)[0] = matrix.row(1)[1] = 1;
        return matrix;
    };
    BandedLu matrix = make();
    EXPECT_TRUE(factor(matrix, 2));
    EXPECT_FALSE(make().factor_checked(16));
    EXPECT_TRUE(spline_matrix(9).factor_checked(16));
}

} // namespace

} // namespace banded_lu_test
