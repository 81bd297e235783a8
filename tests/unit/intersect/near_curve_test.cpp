// Rays that pass curves.
#include "intersect/rays/near_curve.h"

#include "../shapes.h"
#include "eval/curve_point.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace near_curve_unit_test {

using namespace nrb;
using namespace nrb::intersect;

// Whether it begins before the place or past it: the origin itself is on the ray.
TEST(NearCurve, a_ray_that_begins_within_the_distance_of_a_place_passes_it) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto vector = [&] { return Vector3{number(random), number(random), number(random)}; };
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<double> points(12);
        for (double &x : points) {
            x = number(random);
        }
        const SplinePtr curve = shapes::bezier(3, points);
        const std::vector<double> x = eval::curve_point(*curve, std::abs(number(random)), false);
        const Vector3 away = vector(), along = vector();
        const double distance = std::exp2(-20 * std::abs(number(random)));
        const Vector3 from = Vector3{x[0], x[1], x[2]} + (0.99 * distance / length(away)) * away;
        const CurvePassage passage = passage_near(*curve, {from, along}, distance);
        ASSERT_TRUE(passage.there()) << trial;
        EXPECT_LE(passage.ts.lower, 0) << trial;
        EXPECT_GE(passage.ts.upper, 0) << trial;
    }
}

} // namespace near_curve_unit_test
