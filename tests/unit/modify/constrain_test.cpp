// The smallest change that meets linear constraints, where it can be written down.
#include "base/error.h"
#include "modify/constrain/constrain.h"
#include "unit/shapes.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace constrain_test {

namespace {

using nrb::SplinePtr;
using nrb::modify::Condition;
using nrb::modify::Constrained;

constexpr double eps = std::numeric_limits<double>::epsilon();

Constrained through(const SplinePtr &curve, double t, const std::vector<double> &target,
                    const nrb::modify::ChangeRule &rule) {
    const std::vector<Condition> conditions = {
        Condition(nrb::modify::constrain_value, {}, &t, target.data(), 1, curve->dim())};
    return nrb::modify::constrain(*curve, conditions, rule, 0);
}

// One equation sum B_i e_i = d has the shortest solution e_i = B_i d / sum B_j^2: B = (1, 2, 1) / 4 at 1/2.
TEST(Constrain, a_point_moves_control_points_by_their_functions) {
    const SplinePtr curve = shapes::bezier(2, {0, 0, 1, 0, 2, 0});
    const Constrained made = through(curve, 0.5, {1, 3}, {nullptr, nullptr, nullptr});
    const std::array<double, 6> expected = {0, 2, 1, 4, 2, 2}; // sum B^2 = 3/8
    for (size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(made.spline->points()[i], expected[i], 32 * eps * 4);
    }
    EXPECT_EQ(made.rank, 2);
    EXPECT_NEAR(made.moved, 4, 32 * eps * 4);
}

// With costs c_i: e_i = B_i / c_i d / sum B_j^2 / c_j.
TEST(Constrain, dear_control_points_move_less) {
    const SplinePtr curve = shapes::bezier(1, {0, 0, 0});
    const std::array<double, 3> costs = {1, 4, 1};
    const Constrained made = through(curve, 0.5, {3}, {nullptr, costs.data(), nullptr});
    // B^2 / c = (1, 1, 1) / 16
    for (const double e : made.spline->points()) {
        EXPECT_NEAR(e, e == made.spline->points()[1] ? 2 : 4, 32 * eps * 4);
    }
}

TEST(Constrain, what_is_kept_does_not_move) {
    const SplinePtr curve = shapes::bezier(1, {5, 0, 7});
    const std::array<int32_t, 2> keep = {0, 0};
    const Constrained made = through(curve, 0.5, {9}, {keep.data(), nullptr, nullptr});
    EXPECT_EQ(made.spline->points()[0], 5);
    EXPECT_EQ(made.spline->points()[2], 7);
    EXPECT_NEAR(made.spline->points()[1], 12, 32 * eps * 12); // 3 + e / 2 = 9
}

TEST(Constrain, no_influence_is_told) {
    const SplinePtr curve = shapes::bezier(1, {5, 0, 7});
    const std::array<int32_t, 2> keep = {0, -1};
    try {
        through(curve, 0, {9}, {keep.data(), nullptr, nullptr});
        FAIL();
    } catch (const nrb::Error &error) {
        EXPECT_EQ(error.status(), nrb::Status::influence);
    }
}

} // namespace

} // namespace constrain_test
