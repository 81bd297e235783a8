#include "spline/spline.h"

#include <gtest/gtest.h>

namespace effective_test {

namespace {

using nrb::Form;
using nrb::make_knot_vector;
using nrb::make_spline;
using nrb::Spline;
using nrb::SplinePtr;

std::vector<double> points_of(const Spline &spline) {
    return {spline.points().begin(), spline.points().end()};
}
std::vector<double> weights_of(const Spline &spline) {
    return {spline.weights().begin(), spline.weights().end()};
}

TEST(ActiveLayers, are_all_of_a_clamped_axis) {
    const auto axis = make_knot_vector(2, {0, 0, 0, 1, 1, 2, 2, 2});
    EXPECT_EQ(axis->active_layers().first, 0);
    EXPECT_EQ(axis->active_layers().end, 5);
}

TEST(ActiveLayers, end_where_the_knot_of_an_end_repeats) {
    const auto axis = make_knot_vector(2, {-2, -1, 0, 0, 0, 1, 2, 2, 3, 4});
    EXPECT_EQ(axis->active_layers().first, 2);
    EXPECT_EQ(axis->active_layers().end, 6);
}

TEST(Effective, is_the_spline_itself_where_all_points_count) {
    const auto axis = make_knot_vector(1, {-1, 0, 1, 2});
    const SplinePtr spline = make_spline({axis}, 1, Form::polynomial, {3, 4});
    EXPECT_EQ(&spline->effective(), spline.get());
}

TEST(Effective, moves_points_outside_onto_their_neighbours) {
    const auto axis = make_knot_vector(1, {-1, 0, 0, 1, 1, 2});
    const SplinePtr spline = make_spline({axis}, 1, Form::rational, {100, 3, 4, 200}, {9, 1, 2, 9});
    EXPECT_EQ(points_of(spline->effective()), (std::vector<double>{3, 3, 4, 4}));
    EXPECT_EQ(weights_of(spline->effective()), (std::vector<double>{1, 1, 2, 2}));
    EXPECT_EQ(points_of(*spline), (std::vector<double>{100, 3, 4, 200}));
    EXPECT_EQ(&spline->effective(), &spline->effective());
    EXPECT_EQ(&spline->effective().effective(), &spline->effective());
}

TEST(Effective, keeps_weights_of0) {
    const auto axis = make_knot_vector(2, {0, 0, 0, 1, 1, 1});
    const SplinePtr spline = make_spline({axis}, 1, Form::rational, {3, 100, 4}, {1, 0, 1});
    EXPECT_EQ(points_of(spline->effective()), (std::vector<double>{3, 3, 4}));
    EXPECT_EQ(weights_of(spline->effective()), (std::vector<double>{1, 0, 1}));
}

TEST(Effective, leaves_points_at_infinity) {
    const auto axis = make_knot_vector(2, {0, 0, 0, 1, 1, 1});
    const SplinePtr spline = make_spline({axis}, 1, Form::homogeneous, {3, 1, 100, 0, 4, 1});
    EXPECT_EQ(&spline->effective(), spline.get());
}

TEST(Effective, looks_at_every_axis) {
    const auto open = make_knot_vector(1, {-1, 0, 0, 1, 2}), clamped = make_knot_vector(1, {0, 0, 1, 1});
    const SplinePtr spline = make_spline({open, clamped}, 1, Form::polynomial, {9, 9, 1, 2, 3, 4});
    EXPECT_EQ(points_of(spline->effective()), (std::vector<double>{1, 2, 1, 2, 3, 4}));
    const SplinePtr turned = make_spline({clamped, open}, 1, Form::polynomial, {9, 1, 2, 9, 3, 4});
    EXPECT_EQ(points_of(turned->effective()), (std::vector<double>{1, 1, 2, 3, 3, 4}));
}

} // namespace

} // namespace effective_test
