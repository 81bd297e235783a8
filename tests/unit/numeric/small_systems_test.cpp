// Systems of a few unknowns: residuals, and what is refused.
#include "base/numbers.h"
#include "numeric/solvers/small_systems.h"

#include <gtest/gtest.h>
#include <numeric>

namespace small_systems_test {

using namespace nrb;

namespace {

double row_times(const AxisMatrix &a, size_t row, const AxisVector &x) {
    return std::inner_product(x.begin(), x.end(), a[row].begin(), 0.0);
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

} // namespace small_systems_test
