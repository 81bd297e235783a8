// Systems of a few unknowns: residuals, and what is refused.
#include "numeric/solvers/small_systems.h"

#include "support/generators.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace nrb;
using support::Random;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

template <size_t kSize>
SmallMatrix<kSize> random_matrix(Random &random) {
    SmallMatrix<kSize> a;
    for (auto &row : a) {
        std::generate(row.begin(), row.end(), [&] { return random.between(-1, 1); });
    }
    return a;
}

// B B^T + 1.
template <size_t kSize>
SmallMatrix<kSize> positive_matrix(Random &random) {
    const auto b = random_matrix<kSize>(random);
    SmallMatrix<kSize> a{};
    for (size_t i = 0; i < kSize; ++i) {
        for (size_t j = 0; j < kSize; ++j) {
            for (size_t k = 0; k < kSize; ++k) {
                a[i][j] += b[i][k] * b[j][k];
            }
        }
        a[i][i] += 1;
    }
    return a;
}

template <size_t kSize>
double row_times(const SmallMatrix<kSize> &a, size_t row, const SmallVector<kSize> &x) {
    double sum = 0;
    for (size_t j = 0; j < kSize; ++j) {
        sum += a[row][j] * x[j];
    }
    return sum;
}

TEST(SmallSystems, positive_ones_are_solved_to_rounding) {
    Random random(1);
    for (int round = 0; round < 100; ++round) {
        const auto a = positive_matrix<6>(random);
        const auto right = random_matrix<6>(random)[0];
        auto x = right;
        ASSERT_TRUE(solve_positive(6, a, x));
        for (size_t i = 0; i < x.size(); ++i) {
            EXPECT_NEAR(row_times(a, i, x), right[i], 200 * eps);
        }
    }
}

TEST(SmallSystems, indefinite_and_singular_ones_are_refused) {
    AxisVector x{1, 1, 1};
    EXPECT_FALSE(solve_positive(2, AxisMatrix{{{1, 2, 0}, {2, 1, 0}, {0, 0, 1}}}, x));
    EXPECT_FALSE(solve_positive(2, AxisMatrix{{{1, 1, 0}, {1, 1 + eps, 0}, {0, 0, 1}}}, x));
    EXPECT_FALSE(solve_positive(1, AxisMatrix{}, x));
    EXPECT_TRUE(solve_positive(0, AxisMatrix{}, x));
}

TEST(SmallSystems, newton_steps_move_free_unknowns_only) {
    Random random(2);
    const auto hessian = positive_matrix<6>(random);
    const auto gradient = random_matrix<6>(random)[0];
    const SmallVector<6> damping{0, 0.5, 0, 0.25, 0, 100};
    const std::array<bool, 6> free{true, false, true, true, false, true};
    SmallVector<6> step;
    ASSERT_TRUE(newton_step(5, hessian, damping, gradient, free, step));
    for (size_t i = 0; i < step.size(); ++i) {
        if (!free[i] || i == 5) { // the last one is beyond the count
            EXPECT_EQ(step[i], 0);
        } else {
            EXPECT_NEAR(row_times(hessian, i, step) + damping[i] * step[i], -gradient[i], 200 * eps);
        }
    }
}

TEST(SmallSystems, eigenvalues_rise) {
    const AxisVector values = symmetric_eigenvalues(3, {{{2, 1, 0}, {1, 2, 0}, {0, 0, -5}}});
    EXPECT_NEAR(values[0], -5, 16 * eps);
    EXPECT_NEAR(values[1], 1, 16 * eps);
    EXPECT_NEAR(values[2], 3, 16 * eps);
    EXPECT_EQ(symmetric_eigenvalues(1, {{{7, 1, 0}, {1, 2, 0}, {0, 0, 1}}})[0], 7);
}

TEST(SmallSystems, inverses_exist_where_no_pivot_vanishes) {
    const AxisMatrix a{{{0, 2, 0}, {4, 1, 0}, {1, 0, 3}}};
    const auto found = inverse(3, a);
    ASSERT_TRUE(found);
    for (size_t j = 0; j < 3; ++j) {
        const AxisVector column{(*found)[0][j], (*found)[1][j], (*found)[2][j]};
        for (size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(row_times(a, i, column), i == j ? 1 : 0, 16 * eps);
        }
    }
    EXPECT_FALSE(inverse(2, {{{1, 2, 0}, {2, 4, 0}, {0, 0, 1}}}));
}

TEST(SmallSystems, shortest_solutions_leave_null_directions_out) {
    const AxisVector x = shortest_solution(2, {{{1, 1, 0}, {1, 1, 0}, {0, 0, 1}}}, {1, 3, 0});
    EXPECT_NEAR(x[0], 1, 16 * eps); // closest right side: (2, 2)
    EXPECT_NEAR(x[1], 1, 16 * eps);
    EXPECT_EQ(x[2], 0);
}

} // namespace
