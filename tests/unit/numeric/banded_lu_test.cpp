// Banded systems: solutions, widths, and matrices that are refused.
#include "numeric/solvers/banded/banded_lu.h"

#include "support/generators.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace banded_lu_test {

using nrb::BandedLu;

namespace {

// Fills and factors a matrix whose row i has entries from column first(i) on, those that are inside the matrix.
template <class First, class Entry>
bool factor(BandedLu &matrix, int64_t rows, int width, First &&first, Entry &&entry) {
    for (int64_t i = 0; i < rows; ++i) {
        double *const row = matrix.next_row(i, first(i));
        if (row == nullptr) {
            return false;
        }
        for (int64_t c = first(i); c < first(i) + width; ++c) {
            row[c - first(i)] = c < 0 || c >= rows ? 0 : entry(i, c);
        }
        if (!matrix.factor_row(i)) {
            return false;
        }
    }
    return true;
}

// 1 4 1 in every row, whose factors are far from 0.
bool factor_spline_matrix(BandedLu &matrix, int64_t rows) {
    return factor(
        matrix, rows, 3, [](int64_t i) { return i - 1; },
        [](int64_t i, int64_t j) { return i == j ? 4.0 : 1.0; });
}

// Of every width, and of fewer rows than that; rows begin at columns that do not fall, and may begin and end with zeros.
TEST(BandedLu, solves_rows_of_every_reach) {
    support::Random random(930400);
    for (int trial = 0; trial < 600; ++trial) {
        const int width = random.whole(1, 6), rows = random.whole(1, 12);
        std::vector<int64_t> firsts;
        std::vector<double> x(static_cast<size_t>(rows)), y(x.size(), 0.0), all(x.size() * x.size(), 0.0);
        std::ranges::generate(x, [&] { return random.between(-1, 1); });
        for (int64_t r = 0; r < rows; ++r) {
            const int64_t least = std::max(r - width + 1, firsts.empty() ? -width : firsts.back());
            firsts.push_back(random.whole(static_cast<int>(least), static_cast<int>(r)));
            const auto own = static_cast<size_t>(r * rows);
            for (int64_t c = std::max<int64_t>(0, firsts.back());
                 c < std::min<int64_t>(rows, firsts.back() + width); ++c) {
                const double value = r == c ? 10 : random.whole(0, 2) == 0 ? 0 : random.between(0, 1);
                all[own + static_cast<size_t>(c)] = value;
                y[static_cast<size_t>(r)] += value * x[static_cast<size_t>(c)];
            }
        }
        BandedLu matrix(rows, width);
        ASSERT_TRUE(factor(
            matrix, rows, width, [&](int64_t i) { return firsts[static_cast<size_t>(i)]; },
            [&](int64_t i, int64_t j) { return all[static_cast<size_t>(i * rows + j)]; }));
        matrix.solve(y.data(), 1);
        for (size_t r = 0; r < x.size(); ++r) {
            ASSERT_NEAR(y[r], x[r], 1e-14) << "rows of " << width << ", " << rows;
        }
    }
}

TEST(BandedLu, solves_and_treats_every_column_alike) {
    constexpr int64_t rows = 40;
    BandedLu matrix(rows, 3);
    ASSERT_TRUE(factor_spline_matrix(matrix, rows));
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
    BandedLu matrix(rows, 4);
    ASSERT_TRUE(factor(
        matrix, rows, 4, [](int64_t i) { return i - 2; }, entry));
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

// Factors of a matrix of two rows and columns.
bool factor_two(BandedLu &matrix, const double (&entries)[2][2]) {
    return factor(
        matrix, 2, 2, [](int64_t) { return 0; }, [&](int64_t i, int64_t j) { return entries[i][j]; });
}

TEST(BandedLu, refuses_what_it_cannot_solve) {
    BandedLu zero(2, 2), dependent(2, 2), apart(3, 2);
    EXPECT_FALSE(factor_two(zero, {{0, 1}, {1, 0}}));
    EXPECT_FALSE(factor_two(dependent, {{1, 1}, {1, 1}}));
    EXPECT_EQ(apart.next_row(0, 1), nullptr);
    EXPECT_EQ(apart.next_row(2, 0), nullptr);
    EXPECT_NE(apart.next_row(2, 1), nullptr);
}

// 2^-40 1, 1 1: without an exchange of rows nothing is left of the second one.
TEST(BandedLu, sees_a_growth_that_loses_digits) {
    BandedLu growing(2, 2), spline(9, 3);
    ASSERT_TRUE(factor_two(growing, {{0x1p-40, 1}, {1, 1}}));
    EXPECT_FALSE(growing.grows_little(16));
    ASSERT_TRUE(factor_spline_matrix(spline, 9));
    EXPECT_TRUE(spline.grows_little(16));
}

} // namespace

} // namespace banded_lu_test
