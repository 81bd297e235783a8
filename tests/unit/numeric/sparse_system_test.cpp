// SPDX-License-Identifier: MIT
// Sparse factors of grids, and orders of elimination.
#include "numeric/solvers/sparse/grid_order.h"
#include "numeric/solvers/sparse/sparse_system.h"

#include "base/numbers.h"
#include "support/generators.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <numeric>
#include <set>

namespace sparse_system_test {

using namespace nrb;

namespace {

using Axes = std::array<GridAxis, 3>;

bool near_each_other(const GridAxis &axis, int64_t a, int64_t b) {
    const int64_t apart = std::abs(a - b);
    return apart <= axis.reach || (axis.periodic && axis.count - apart <= axis.reach);
}

// Random couplings of points within the reach, and a large diagonal.
Eigen::MatrixXd random_grid(support::Random &random, const Axes &axes) {
    const int64_t n = axes[0].count * axes[1].count * axes[2].count;
    const auto place = [&](int64_t i) {
        return std::array{i / (axes[1].count * axes[2].count), i / axes[2].count % axes[1].count,
                          i % axes[2].count};
    };
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    for (int64_t i = 0; i < n; ++i) {
        for (int64_t j = 0; j < i; ++j) {
            const auto p = place(i), q = place(j);
            bool coupled = true;
            for (size_t k = 0; k < 3; ++k) {
                coupled = coupled && near_each_other(axes[k], p[k], q[k]);
            }
            a(i, j) = a(j, i) = coupled ? random.between(-1, 1) : 0;
        }
    }
    for (int64_t i = 0; i < n; ++i) {
        a(i, i) = 1 + a.row(i).cwiseAbs().sum();
    }
    return a;
}

// In any order, some of them as sums of two.
std::vector<Entry> entries_of(support::Random &random, const Eigen::MatrixXd &a) {
    std::vector<Entry> entries;
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
        for (Eigen::Index j = 0; j < a.cols(); ++j) {
            if (a(i, j) != 0) {
                const double part = random.chance(20) ? 0.5 : 1;
                entries.push_back({i, j, part * a(i, j)});
                if (part < 1) {
                    entries.push_back({i, j, part * a(i, j)});
                }
            }
        }
    }
    for (size_t i = entries.size(); i > 1; --i) {
        std::swap(entries[i - 1], entries[static_cast<size_t>(random.whole(0, static_cast<int>(i) - 1))]);
    }
    return entries;
}

} // namespace

TEST(SparseSystem, solves_grids) {
    support::Random random(1);
    const std::vector<Axes> grids{{{{30, 3, false}, {}, {}}},
                                  {{{25, 2, true}, {}, {}}},
                                  {{{9, 2, false}, {11, 1, true}, {}}},
                                  {{{5, 1, false}, {4, 1, false}, {6, 2, true}}},
                                  {{{1, 0, false}, {}, {}}}};
    for (const Axes &axes : grids) {
        const Eigen::MatrixXd a = random_grid(random, axes);
        const Eigen::Index n = a.rows();
        std::vector<double> diagonal(static_cast<size_t>(n)), right(static_cast<size_t>(2 * n)), x;
        for (double &d : diagonal) {
            d = random.between(0.5, 2);
        }
        for (double &r : right) {
            r = random.between(-1, 1);
        }
        SparseSystem system(entries_of(random, a), diagonal, grid_order(axes));
        for (const double rho : {0.0, 3.0}) {
            ASSERT_TRUE(system.solve(rho, right, 2, x));
            Eigen::MatrixXd sum = a;
            for (Eigen::Index i = 0; i < n; ++i) {
                sum(i, i) += rho * diagonal[static_cast<size_t>(i)];
            }
            using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
            const Eigen::Map<const RowMajor> found(x.data(), n, 2), wanted(right.data(), n, 2);
            EXPECT_LE((sum * found - wanted).cwiseAbs().maxCoeff(), 64 * eps * static_cast<double>(n));
        }
    }
}

// Large enough that systems are solved by iteration; every solution is where the next one begins.
TEST(SparseSystem, solves_for_many_shifts) {
    support::Random random(2);
    const int64_t side = 60, reach = 3, n = side * side;
    std::vector<Entry> entries;
    std::vector<double> diagonal(static_cast<size_t>(n)), right(static_cast<size_t>(3 * n)), x;
    for (int64_t i = 0; i < n; ++i) {
        diagonal[static_cast<size_t>(i)] = random.between(0.5, 2);
        for (int64_t j = i + 1; j < n; ++j) {
            if (j / side - i / side <= reach && std::abs(j % side - i % side) <= reach) {
                const double bond = random.between(0, 1); // pulls both together
                entries.insert(entries.end(), {{i, i, bond}, {j, j, bond}, {i, j, -bond}, {j, i, -bond}});
            }
        }
    }
    for (double &r : right) {
        r = random.between(-1, 1);
    }
    SparseSystem system(entries, diagonal, grid_order({{{side, reach, false}, {side, reach, false}, {}}}));
    for (const double rho : {1e3, 1e2, 99.0, 99.01, 1e-3, 1.1e-3, 1.0999e-3, 1.0999e-3, 0.5, 2e3}) {
        for (const double sign : {1.0, -1.0}) { // a new right side has nothing to do with the old one
            for (size_t i = 0; i < right.size(); i += 2) {
                right[i] *= sign;
            }
            ASSERT_TRUE(system.solve(rho, right, 3, x));
            std::vector<double> image = times(entries, x, 3);
            std::array<double, 3> left{}, whole{};
            for (size_t i = 0; i < right.size(); ++i) {
                const double error = image[i] + rho * diagonal[i / 3] * x[i] - right[i];
                left[i % 3] += error * error;
                whole[i % 3] += right[i] * right[i];
            }
            for (size_t c = 0; c < 3; ++c) {
                EXPECT_LE(std::sqrt(left[c]), 2e-10 * std::sqrt(whole[c])) << rho << ' ' << c;
            }
        }
    }
}

TEST(SparseSystem, tells_a_matrix_that_is_not_positive) {
    std::vector<double> x;
    const std::vector<Entry> entries{{0, 0, 1}, {1, 1, 1}, {0, 1, 2}, {1, 0, 2}};
    SparseSystem system(entries, {1, 1}, {1, 0});
    EXPECT_FALSE(system.solve(0, {1, 1}, 1, x));
    EXPECT_TRUE(system.solve(2, {1, 1}, 1, x));
    EXPECT_NEAR(x[0], 0.2, 4 * eps);
}

TEST(GridOrder, is_a_permutation_that_keeps_factors_thin) {
    for (const Axes &axes :
         std::vector<Axes>{{{{40, 3, true}, {}, {}}}, {{{17, 2, false}, {23, 3, true}, {3, 1, false}}}}) {
        const std::vector<int64_t> order = grid_order(axes);
        const std::set<int64_t> all(order.begin(), order.end());
        EXPECT_EQ(std::ssize(order), axes[0].count * axes[1].count * axes[2].count);
        EXPECT_EQ(all.size(), order.size());
        EXPECT_EQ(*all.rbegin(), std::ssize(order) - 1);
    }
    // Both halves of a grid come before what separates them.
    const std::vector<int64_t> order = grid_order({{{33, 1, false}, {}, {}}});
    EXPECT_EQ(order.back(), 16);
}

} // namespace sparse_system_test
