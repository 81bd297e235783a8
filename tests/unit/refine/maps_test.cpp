// Maps of control points, quotients and Hermite data of small whole numbers.
#include "refine/algebra/quotient_rule.h"
#include "refine/forms/hermite.h"
#include "refine/forms/projections.h"
#include "refine/forms/transform.h"
#include "refine/periodic/periodic.h"
#include "unit/shapes.h"

#include <gtest/gtest.h>

namespace maps_test {

using namespace nrb;
using namespace shapes;

namespace {

using Values = std::vector<double>;

TEST(Transform, may_change_the_dimension) {
    const double sum[] = {1, 1}, offset[] = {10};
    const SplinePtr made = refine::transform(*bezier(2, {1, 2, 3, 4}), {1, 2, sum}, offset);
    EXPECT_EQ(made->dim(), 1);
    EXPECT_EQ(vector_of(made->points()), (Values{13, 17}));
}

TEST(Transform, projectively_makes_weights) {
    const double matrix[] = {1, 0, 1, 1}; // x / (x + 1)
    const SplinePtr made = refine::transform_projective(*bezier(1, {0, 1}), {2, 2, matrix});
    EXPECT_TRUE(made->rational());
    EXPECT_EQ(made->coordinate(1, 0), 0.5);
    EXPECT_EQ(made->weight(1), 2);
}

// (t) / (1 + t) has the derivative 1 / (1 + t)^2.
TEST(QuotientRule, of_a_linear_fraction) {
    const SplinePtr g = make_spline({make_knot_vector(1, {0, 0, 1, 1})}, 1, Form::rational, {0, 0.5}, {1, 2});
    const SplinePtr made = refine::rational_derivative(*g, 0, 1);
    EXPECT_EQ(made->axis(0).degree(), 2);
    EXPECT_EQ(made->coordinate(0, 0), 1);
    EXPECT_EQ(made->coordinate(2, 0), 0.25);
    EXPECT_EQ(made->weight(2) / made->weight(0), 4);
}

TEST(RefinePeriodic, copies_go_into_all_periods) {
    const KnotVector axis(2, {0, 1, 2, 3, 4, 5, 6, 7, 8}, true); // domain [2, 6]
    const double knot[] = {2.5};
    const refine::AxisTable made = refine::refine_periodic(axis, knot);
    EXPECT_TRUE(made.axis->periodic());
    EXPECT_EQ(vector_of(made.axis->knots()), (Values{0, 1, 2, 2.5, 3, 4, 5, 6, 6.5, 7}));
    EXPECT_EQ(made.table.rows(), 7);
}

// The parabola 4 t (1 - t) has its top at 1/2.
TEST(Hermite, data_are_ends_of_spans) {
    const refine::HermiteData data = refine::hermite_data(curve(2, {0, 0, 0, 0.5, 1, 1, 1}, 1, {0, 1, 1, 0}));
    EXPECT_EQ(data.params, (Values{0, 0.5, 1}));
    EXPECT_EQ(data.points, (Values{0, 1, 0}));
    EXPECT_EQ(data.tangents, (Values{4, 0, -4}));
}

TEST(Mirror, in_a_coordinate_plane) {
    const double origin[] = {0, 0}, normal[] = {0, 2}, eye[] = {0, 4}, line[] = {0, 0};
    EXPECT_EQ(vector_of(nrb::refine::mirror(*bezier(2, {1, 2, 3, 4}), origin, normal)->points()),
              (Values{1, -2, 3, -4}));
    EXPECT_EQ(
        vector_of(nrb::refine::project_to_plane(*bezier(2, {1, 2, 3, 4}), origin, normal, nullptr)->points()),
        (Values{1, 0, 3, 0}));
    EXPECT_EQ(nrb::refine::project_from(*bezier(2, {1, 2, 3, 2}), eye, line, normal)->coordinate(1, 0), 6);
}

} // namespace

} // namespace maps_test
