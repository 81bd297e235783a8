#include "spline/at_origin.h"

#include <cmath>
#include <gtest/gtest.h>

namespace at_origin_test {

namespace {

using nrb::at_origin;
using nrb::Form;
using nrb::make_knot_vector;
using nrb::make_spline;
using nrb::SplinePtr;

SplinePtr line(int dim, Form form, std::vector<double> points, std::vector<double> weights = {}) {
    return make_spline({make_knot_vector(1, {0, 0, 1, 1})}, dim, form, std::move(points), std::move(weights));
}

std::vector<double> points_of(const nrb::Spline &spline) {
    return {spline.points().begin(), spline.points().end()};
}

TEST(AtOrigin, leaves_what_is_not_far_from_zero) {
    for (const std::vector<double> &points : {std::vector<double>{-1, 2}, {1, 2}, {8, 9}, {0, 0}, {-9, -8}}) {
        const SplinePtr curve = line(1, Form::polynomial, points);
        EXPECT_EQ(&at_origin(*curve), curve.get());
    }
}

TEST(AtOrigin, moves_the_nearest_corner_to_zero_without_error) {
    const double far = 1e8;
    const double next = std::nextafter(far, INFINITY);
    const SplinePtr curve = line(2, Form::polynomial, {far, -3 * far, next, -3 * far - 1});
    const nrb::Spline &moved = at_origin(*curve);
    EXPECT_EQ(points_of(moved), (std::vector<double>{0, 0, next - far, -1}));
    EXPECT_EQ(&at_origin(moved), &moved);
    EXPECT_EQ(&at_origin(*curve), &moved);
}

// Coordinates that straddle zero, or that are nearer to it than the box is long, are not touched.
TEST(AtOrigin, keeps_coordinates_that_are_near) {
    const SplinePtr curve = line(3, Form::polynomial, {100, -1, 0.1, 101, 0, 0.3});
    EXPECT_EQ(points_of(at_origin(*curve)), (std::vector<double>{0, -1, 0.1, 1, 0, 0.3}));
}

TEST(AtOrigin, moves_homogeneous_records_by_their_weights) {
    const SplinePtr curve = line(1, Form::homogeneous, {200, 2, 404, 4});
    EXPECT_EQ(points_of(at_origin(*curve)), (std::vector<double>{0, 2, 4, 4}));
}

// Neither a weight of 0 nor a function that vanishes on the domain counts.
TEST(AtOrigin, depends_on_points_with_influence_only) {
    const auto bezier = make_knot_vector(2, {0, 0, 0, 1, 1, 1});
    const SplinePtr weightless = make_spline({bezier}, 1, Form::rational, {100, 1e300, 101}, {1, 0, 1});
    EXPECT_EQ(points_of(at_origin(*weightless)).back(), 1);
    const auto outer = make_knot_vector(1, {-1, 0, 0, 1, 1, 2});
    const SplinePtr unseen = make_spline({outer}, 1, Form::polynomial, {-1.7e308, 1e308, 1e308, 1.7e308});
    EXPECT_EQ(points_of(at_origin(*unseen)), (std::vector<double>{0, 0, 0, 0}));
}

} // namespace

} // namespace at_origin_test
