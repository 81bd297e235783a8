// Changes of form that move no value.
#include "refine/forms/homogeneous.h"
#include "refine/forms/parametrization.h"
#include "refine/forms/transpose.h"
#include "refine/knots/axis_table.h"
#include "refine/parts/iso.h"
#include "refine/parts/join.h"
#include "unit/shapes.h"

#include <gtest/gtest.h>

namespace forms_test {

using namespace nrb;
using namespace shapes;

namespace {

using Values = std::vector<double>;

SplinePtr rational() {
    return make_spline({make_knot_vector(1, {0, 0, 1, 1})}, 2, Form::rational, {1, 2, 3, 4}, {1, 0.5});
}

SplinePtr surface() { // 2 by 3 points
    return make_spline({make_knot_vector(1, {0, 0, 1, 1}), make_knot_vector(2, {0, 0, 0, 2, 2, 2})}, 1,
                       Form::polynomial, {1, 2, 3, 4, 5, 6});
}

TEST(Homogeneous, points_carry_their_weights) {
    EXPECT_EQ(nrb::refine::homogeneous_points(*rational()), (Values{1, 2, 1, 1.5, 2, 0.5}));
    const SplinePtr there = refine::to_homogeneous(*rational());
    EXPECT_EQ(there->dim(), 3);
    EXPECT_EQ(nrb::refine::from_homogeneous(*there)->coordinate(1, 1), 4);
}

TEST(Homogeneous, the_common_form_holds_all) {
    const SplinePtr both[] = {bezier(2, {0, 0, 1, 1}), rational()};
    EXPECT_EQ(nrb::refine::common_form(both), Form::rational);
    EXPECT_EQ(vector_of(nrb::refine::in_form(both[0], Form::rational)->weights()), (Values{1, 1}));
}

TEST(Transpose, exchanges_axes) {
    const int32_t turn[] = {1, 0};
    const SplinePtr made = refine::transpose(*surface(), turn);
    EXPECT_EQ(vector_of(made->points()), (Values{1, 4, 2, 5, 3, 6}));
    EXPECT_EQ(made->axis(0).degree(), 2);
}

TEST(Iso, at_an_end_is_the_boundary) {
    EXPECT_EQ(vector_of(nrb::refine::iso(*surface(), 0, 1, {})->points()), (Values{4, 5, 6}));
    EXPECT_EQ(vector_of(nrb::refine::iso(*surface(), 1, 0, {})->points()), (Values{1, 4}));
}

TEST(Reverse, negates_knots_or_keeps_the_domain) {
    const SplinePtr g = curve(1, {0, 0, 1, 3, 3}, 1, {5, 6, 7});
    EXPECT_EQ(vector_of(nrb::refine::reverse(*g, 0, false)->axis(0).knots()), (Values{-3, -3, -1, 0, 0}));
    EXPECT_EQ(vector_of(nrb::refine::reverse(*g, 0, true)->axis(0).knots()), (Values{0, 0, 2, 3, 3}));
    EXPECT_EQ(vector_of(nrb::refine::reverse(*g, 0, true)->points()), (Values{7, 6, 5}));
}

TEST(Join, of_parts_that_meet_shares_the_end) {
    const SplinePtr parts[] = {bezier(1, {0, 1, 4}), bezier(1, {4, 5, 6})};
    const refine::Joined joined = refine::join(parts, 0, {0, false});
    EXPECT_EQ(vector_of(joined.spline->points()), (Values{0, 1, 4, 5, 6}));
    EXPECT_EQ(vector_of(joined.spline->axis(0).knots()), (Values{0, 0, 0, 1, 1, 2, 2, 2}));
    EXPECT_EQ(joined.gap, 0);
}

TEST(AxisTable, merges_sorted_knots) {
    const double a[] = {0, 1, 1, 3}, b[] = {1, 2};
    EXPECT_EQ(nrb::refine::merged(a, b), (Values{0, 1, 1, 1, 2, 3}));
}

} // namespace

} // namespace forms_test
