// SPDX-License-Identifier: MIT
// Shapes beside which a curve or surface has a distance that is known.
#include "recognize/shape_bound.h"

#include <cmath>
#include <gtest/gtest.h>

namespace shape_bound_test {

using nrb::Form;
using nrb::SplinePtr;
using nrb::pieces::Enclosure;
using nrb::recognize::Shape;

namespace {

constexpr double half_root = 0.70710678118654757;

nrb::KnotVectorPtr bezier_axis(int degree) {
    std::vector<double> knots(static_cast<size_t>(degree) + 1, 0.0);
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, 1.0);
    return nrb::make_knot_vector(degree, std::move(knots));
}

SplinePtr curve(int dim, std::vector<double> points, std::vector<double> weights) {
    const auto form = weights.empty() ? Form::polynomial : Form::rational;
    const int degree = static_cast<int>(points.size()) / dim - 1;
    return nrb::make_spline({bezier_axis(degree)}, dim, form, std::move(points), std::move(weights));
}

SplinePtr quarter(double r) {
    return curve(2, {r, 0, r, r, 0, r}, {1, half_root, 1});
}

Shape shape_of(int32_t kind, double first, double second = 0) {
    Shape shape;
    shape.kind = kind;
    shape.sizes[0] = first;
    shape.sizes[1] = second;
    return shape;
}

void expect_distance(const SplinePtr &spline, const Shape &shape, double distance) {
    const Enclosure found = nrb::recognize::distance_from(*spline, shape, 1e9);
    EXPECT_LE(found.lower, distance);
    EXPECT_GE(found.upper, distance);
    EXPECT_LE(found.upper, 1.25 * distance + 1e-13);
}

// On the axis of a torus that cuts itself the cusp at sqrt(r^2 - R^2) = 0.75 is nearest, not the part beyond
// the axis, which is 0.25 away.
TEST(ShapeBound, a_torus_that_cuts_itself_is_its_outer_part) {
    expect_distance(curve(3, {0, 0, 0, 0, 0, 0.05, 0, 0, 0.1}, {}),
                    shape_of(nrb::recognize::shape_torus, 1, 1.25), 0.75);
    expect_distance(curve(3, {0, 0, 0.8, 0.01, 0, 0.8, 0.02, 0, 0.8}, {}),
                    shape_of(nrb::recognize::shape_torus, 1, 1.25), std::hypot(1, 0.8) - 1.25);
}

TEST(ShapeBound, encloses_known_distances) {
    for (const double d : {0.0, 1e-12, 1e-6, 1e-2, 0.3}) {
        expect_distance(quarter(1), shape_of(nrb::recognize::shape_circle, 1 + d), d);
        expect_distance(quarter(1), shape_of(nrb::recognize::shape_cylinder, 1 - d), d);
        expect_distance(quarter(1), shape_of(nrb::recognize::shape_sphere, 1 + d), d);
        expect_distance(quarter(2 + d), shape_of(nrb::recognize::shape_torus, 1, 1), d);
        Shape moved = shape_of(nrb::recognize::shape_circle, 1);
        moved.origin = {0, 0, d};
        expect_distance(curve(3, {1, 0, 0, 1, 1, 0, 0, 1, 0}, {1, half_root, 1}), moved, d);
        Shape parabola = shape_of(nrb::recognize::shape_parabola, 0.25);
        parabola.origin = {-d, 0, 0};
        expect_distance(curve(2, {0, 0, 0, 0.5, 1, 1}, {}), parabola, d); // at the vertex
    }
}

// On the other half of a cone and the other branch of a hyperbola the equation holds as well.
TEST(ShapeBound, knows_the_half_and_the_branch) {
    const SplinePtr generator = curve(3, {-1, 0, -1, 1, 0, 1}, {});
    expect_distance(generator, shape_of(nrb::recognize::shape_cone, std::atan(1.0)), std::sqrt(2.0));
    expect_distance(curve(3, {0, 0, 0, 1, 0, 1}, {}), shape_of(nrb::recognize::shape_cone, std::atan(1.0)),
                    0);
    const SplinePtr branch = curve(2, {-1, 0, -1, 1. / 3, -1.25, 0.75}, {1, std::sqrt(1.125), 1});
    double least = 9; // from the end (-5/4, 3/4) to the branch x = sqrt(1 + y^2)
    for (int i = 0; i < 10000; ++i) {
        const double y = i * 1e-4;
        least = std::min(least, std::hypot(std::hypot(1, y) + 1.25, y - 0.75));
    }
    expect_distance(branch, shape_of(nrb::recognize::shape_hyperbola, 1, 1), least - 1e-8);
}

TEST(ShapeBound, is_infinite_where_the_weight_has_no_certain_sign) {
    const auto spline =
        nrb::make_spline({bezier_axis(2)}, 2, Form::homogeneous, {1, 0, 1, 0, 1, -1, -1, 0, 1});
    EXPECT_TRUE(std::isinf(
        nrb::recognize::distance_from(*spline, shape_of(nrb::recognize::shape_circle, 1), 1e9).upper));
    const auto negative =
        nrb::make_spline({bezier_axis(2)}, 2, Form::homogeneous, {-1, 0, -1, 0, -1, 0, 1, 0, -1});
    expect_distance(negative, shape_of(nrb::recognize::shape_circle, 1), 0); // half a circle
}

} // namespace

} // namespace shape_bound_test
