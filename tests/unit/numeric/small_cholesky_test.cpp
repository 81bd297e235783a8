// SPDX-License-Identifier: MIT
// Cholesky factors of a few rows: exact solutions, and what is refused.
#include "numeric/solvers/small_cholesky.h"

#include <gtest/gtest.h>

namespace small_cholesky_test {

using Cholesky = nrb::SmallCholesky<3>;

TEST(SmallCholesky, solves_and_factors) {
    const Cholesky::Matrix a{{{4, 99, 99}, {2, 10, 99}, {-2, 5, 9}}}; // only the lower half is read
    Cholesky factor;
    ASSERT_TRUE(factor.factorise(a, 3, 0));
    Cholesky::Vector x{4 * 1 + 2 * 2 - 2 * 3, 2 * 1 + 10 * 2 + 5 * 3, -2 * 1 + 5 * 2 + 9 * 3};
    factor.solve(x);
    EXPECT_DOUBLE_EQ(x[0], 1);
    EXPECT_DOUBLE_EQ(x[1], 2);
    EXPECT_DOUBLE_EQ(x[2], 3);
    Cholesky::Vector y{2, 4, 1};
    factor.solve_lower(y);
    EXPECT_DOUBLE_EQ(y[0], 1);
    EXPECT_DOUBLE_EQ(y[1], 1);
}

TEST(SmallCholesky, refuses_what_may_be_singular) {
    Cholesky factor;
    EXPECT_FALSE(factor.factorise({{{1, 0, 0}, {2, 3, 0}, {0, 0, 1}}}, 2, 0));        // indefinite
    EXPECT_FALSE(factor.factorise({{{1, 0, 0}, {1, 1 + 0x1p-40, 0}, {}}}, 2, 1e-10)); // nearly singular
    EXPECT_TRUE(factor.factorise({{{1, 0, 0}, {1, 1 + 0x1p-40, 0}, {}}}, 2, 1e-13));
    EXPECT_TRUE(factor.factorise({{{1, 0, 0}, {2, 3, 0}, {0, 0, 1}}}, 1, 0));
}

} // namespace small_cholesky_test
