// The side on which the normal of an offset is: proven, or none.
#include "base/error.h"
#include "eval/evaluate.h"
#include "fit/offset/offset_side.h"
#include "numeric/vector3.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace offset_side_test {

namespace {

using namespace nrb;

SplinePtr patch(std::mt19937_64 &random, bool rational, double height) {
    std::uniform_real_distribution<double> unit_number(0, 1);
    const auto axis = [] { return make_knot_vector(3, {0, 0, 0, 0, 0.25, 0.75, 1, 1, 1, 1}); };
    std::vector<double> points, weights;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            points.insert(points.end(), {i / 5.0, j / 5.0, height * unit_number(random)});
            weights.push_back(0.5 + unit_number(random));
        }
    }
    return make_result({axis(), axis()}, 3, rational ? Form::rational : Form::polynomial, std::move(points),
                       rational ? std::move(weights) : std::vector<double>());
}

// The least and the largest (1 - k1 d)(1 - k2 d) on a grid, from the fundamental forms.
std::array<double, 2> sampled(const Spline &surface, double d) {
    std::array<double, 2> range{INFINITY, -INFINITY};
    for (int i = 0; i <= 60; ++i) {
        for (int j = 0; j <= 60; ++j) {
            const double at[2] = {i / 60.0, j / 60.0};
            double x[18];
            eval::evaluate_points(surface, {}, 2, {at, 1, 2, 2, 1}, {x, 1, 18, 18, 1});
            const auto slot = [&](int k) { return Vector3{x[3 * k], x[3 * k + 1], x[3 * k + 2]}; };
            const Vector3 n = unit(cross(slot(1), slot(2)));
            const double e = dot(slot(1), slot(1)), f = dot(slot(1), slot(2)), g = dot(slot(2), slot(2));
            const double det = (e - d * dot(slot(3), n)) * (g - d * dot(slot(5), n)) -
                               (f - d * dot(slot(4), n)) * (f - d * dot(slot(4), n));
            const double factor = det / (e * g - f * f);
            range = {std::min(range[0], factor), std::max(range[1], factor)};
        }
    }
    return range;
}

int side_of(const SplinePtr &surface, double distance, int64_t pieces) {
    const int side = fit::offset_side(surface, distance, pieces);
    EXPECT_GE(pieces, 0);
    return side;
}

// Wherever samples are far from 0 on one side it is known, and it is never what they contradict.
TEST(OffsetSide, is_that_of_samples) {
    std::mt19937_64 random(20261127);
    int known = 0;
    for (int i = 0; i < 12; ++i) {
        const SplinePtr surface = patch(random, i % 2 == 1, i % 4 < 2 ? 0.05 : 0.2);
        for (const double distance : {0.02, -0.1, 0.3, -2.0, 50.0}) {
            const auto [least, most] = sampled(*surface, distance);
            const int side = side_of(surface, distance, 4096);
            known += side != 0 ? 1 : 0;
            EXPECT_TRUE(side == 0 || side * least > 0) << least;
            EXPECT_TRUE(side == 0 || side * most > 0) << most;
            EXPECT_TRUE(side != 0 || least < 0.05) << least << ' ' << most;
        }
    }
    EXPECT_GE(known, 20);
}

// A quarter of a cylinder of radius 1 whose normal is inwards: 1 - d, known but near 1.
TEST(OffsetSide, of_a_cylinder_changes_at_its_axis) {
    const double h = std::sqrt(0.5);
    const KnotVectorPtr square = make_knot_vector(2, {0, 0, 0, 1, 1, 1}),
                        line = make_knot_vector(1, {0, 0, 1, 1});
    const SplinePtr rod =
        make_result({square, line}, 3, Form::rational, {1, 0, 1, 1, 0, 0, 1, 1, 1, 1, 1, 0, 0, 1, 1, 0, 1, 0},
                    {1, 1, h, h, 1, 1});
    EXPECT_EQ(side_of(rod, 0.9, 4096), 1);
    EXPECT_EQ(side_of(rod, 1.1, 4096), -1);
    EXPECT_EQ(side_of(rod, -100, 4096), 1);
    EXPECT_EQ(side_of(rod, 1, 4096), 0);
    EXPECT_EQ(side_of(rod, 1.1, 2), 0);
}

} // namespace

} // namespace offset_side_test
