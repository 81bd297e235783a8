// SPDX-License-Identifier: MIT
// Banded least squares: what is consistent is solved, residuals are orthogonal to all columns.
#include "numeric/solvers/banded_least_squares.h"

#include "support/generators.h"

#include <cmath>
#include <gtest/gtest.h>

namespace banded_least_squares_test {

using nrb::BandedLeastSquares;
using support::Random;

namespace {

struct System {
    int columns;
    int band;
    int border;
    std::vector<std::vector<double>> rows; // dense
    std::vector<int> firsts;
};

System random_system(Random &random) {
    System system{random.whole(3, 12), random.whole(1, 3), random.whole(0, 2), {}, {}};
    const int banded = system.columns - system.border;
    for (int r = 0; r < 4 * system.columns; ++r) {
        const int width = std::min(system.band, banded);
        const int first = r % (banded - width + 1);
        std::vector<double> row(static_cast<size_t>(system.columns), 0.0);
        for (int i = 0; i < width; ++i) {
            row[static_cast<size_t>(first + i)] = random.between(-1, 1);
        }
        for (int i = banded; i < system.columns; ++i) {
            row[static_cast<size_t>(i)] = random.chance(80) ? random.between(-1, 1) : 0;
        }
        system.rows.push_back(row);
        system.firsts.push_back(first);
    }
    return system;
}

bool solve(const System &system, const std::vector<double> &right, int64_t width, std::vector<double> &x) {
    BandedLeastSquares squares(system.columns, system.band, system.border, width);
    const auto banded = static_cast<size_t>(system.columns - system.border);
    for (size_t r = 0; r < system.rows.size(); ++r) {
        const std::span<const double> row(system.rows[r]);
        const auto first = static_cast<size_t>(system.firsts[r]);
        squares.add_row(system.firsts[r],
                        row.subspan(first, std::min(static_cast<size_t>(system.band), banded - first)),
                        row.subspan(banded), right.data() + static_cast<int64_t>(r) * width);
    }
    x.resize(static_cast<size_t>(system.columns * width));
    return squares.solve(x.data());
}

TEST(BandedLeastSquares, residuals_are_orthogonal_to_the_columns) {
    Random random(1);
    for (int i = 0; i < 300; ++i) {
        const System system = random_system(random);
        std::vector<double> right(system.rows.size() * 2), x;
        for (double &value : right) {
            value = random.between(-1, 1);
        }
        ASSERT_TRUE(solve(system, right, 2, x));
        for (size_t c = 0; c < 2; ++c) {
            std::vector<double> product(static_cast<size_t>(system.columns), 0.0);
            for (size_t r = 0; r < system.rows.size(); ++r) {
                double rest = right[2 * r + c];
                for (size_t k = 0; k < product.size(); ++k) {
                    rest -= system.rows[r][k] * x[2 * k + c];
                }
                for (size_t k = 0; k < product.size(); ++k) {
                    product[k] += rest * system.rows[r][k];
                }
            }
            for (const double value : product) {
                EXPECT_NEAR(value, 0, 1e-9) << "system " << i;
            }
        }
    }
}

TEST(BandedLeastSquares, a_column_that_no_row_has_is_not_solved_for) {
    BandedLeastSquares squares(2, 1, 0, 1);
    const double one[] = {1}, right[] = {3};
    squares.add_row(0, one, {}, right);
    double x[2];
    EXPECT_FALSE(squares.solve(x));
    squares.add_row(1, one, {}, right);
    EXPECT_TRUE(squares.solve(x));
    EXPECT_EQ(x[1], 3);
}

} // namespace

} // namespace banded_least_squares_test
