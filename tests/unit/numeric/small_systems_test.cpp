// SPDX-License-Identifier: MIT
#include "numeric/solvers/small_systems.h"

#include <gtest/gtest.h>

namespace small_systems_test {

using namespace nrb;

namespace {

TEST(SmallSystems, eigenvalues_rise) {
    const AxisVector values = symmetric_eigenvalues(2, {{{2, 1}, {1, 2}}});
    EXPECT_NEAR(values[0], 1, 1e-15);
    EXPECT_NEAR(values[1], 3, 1e-15);
    EXPECT_EQ(values[2], 0);
}

TEST(SmallSystems, only_positive_eigenvalues_are_added_to_1) {
    const AxisMatrix one = inverse_of_positive_part(1, {{{3}}}), none = inverse_of_positive_part(1, {{{-3}}});
    EXPECT_EQ(one[0][0], 0.25);
    EXPECT_EQ(none[0][0], 1);
    const AxisMatrix both = inverse_of_positive_part(2, {{{1, 2}, {2, 1}}}); // eigenvalues 3 and -1
    EXPECT_NEAR(both[0][0], 0.625, 1e-15);
    EXPECT_NEAR(both[0][1], -0.375, 1e-15);
    EXPECT_NEAR(both[1][1], 0.625, 1e-15);
}

TEST(SmallSystems, an_inverse_times_its_matrix_is_the_identity) {
    const AxisMatrix a{{{4, 1, 2}, {0, 3, 1}, {5, 0, 1}}};
    const std::optional<AxisMatrix> b = inverse(3, a);
    ASSERT_TRUE(b);
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j) {
            const double product = a[i][0] * (*b)[0][j] + a[i][1] * (*b)[1][j] + a[i][2] * (*b)[2][j];
            EXPECT_NEAR(product, i == j ? 1 : 0, 1e-14);
        }
    }
    EXPECT_FALSE(inverse(2, {{{1, 2}, {2, 4}}}));
}

TEST(SmallSystems, of_many_solutions_the_shortest_one_counts) {
    const AxisVector x = shortest_solution(2, {{{1, 1}, {1, 1}}}, {2, 2});
    EXPECT_NEAR(x[0], 1, 1e-15);
    EXPECT_NEAR(x[1], 1, 1e-15);
}

} // namespace

} // namespace small_systems_test
