// Nearest points of parts that are placed in parts, against the equation of a ball under the same maps.
#include "model/near/model_locator.h"
#include "placed_balls.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace model_near_unit_test {

namespace {

using namespace placed_balls;

// Through all uses, the last one first.
Vector3 image(const std::array<Rows, 5> &placements, const std::vector<size_t> &way, Vector3 x) {
    for (size_t i = way.size(); i-- > 0;) {
        const Rows &m = placements[way[i]];
        x = {m[0] * x.x + m[1] * x.y + m[2] * x.z + m[3], m[4] * x.x + m[5] * x.y + m[6] * x.z + m[7],
             m[8] * x.x + m[9] * x.y + m[10] * x.z + m[11]};
    }
    return x;
}

double size_of(const Long &x) {
    return static_cast<double>(std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]));
}

// How much lengths grow, on the way to the whole.
double scale_of(const std::array<Rows, 5> &placements, const std::vector<size_t> &way) {
    const Vector3 x{1, 0, 0};
    return length(image(placements, way, x) - image(placements, way, {}));
}

// Of the balls, the nearest: their placements keep ratios.
double nearest_of(const std::array<Rows, 5> &uses, const Vector3 &x, int64_t &instance) {
    double least = HUGE_VAL;
    for (size_t k = 0; k < 5; ++k) {
        const double own =
            scale_of(uses, ways()[k]) * std::abs(size_of(in_ball(uses, ways()[k], x, false)) - radius);
        if (own < least) {
            least = own;
            instance = numbers_of_instances[k];
        }
    }
    return least;
}

bool certified(const ModelFoot &found) {
    return (found.foot.status & closest::closest_certified) != 0;
}

} // namespace

TEST(PlacedNearest, of_balls_are_where_their_equations_say) {
    Numbers random(5);
    for (int trial = 0; trial < 40; ++trial) {
        const std::array<Rows, 5> uses = placements(random, true);
        const Model model = balls(uses);
        ModelLocator locator(model);
        for (int i = 0; i < 30; ++i) {
            const Vector3 x = random.point(12);
            int64_t instance = -1;
            const double expected = nearest_of(uses, x, instance);
            const ModelFoot found = locator.nearest(x, 1e-9);
            ASSERT_TRUE(certified(found));
            ASSERT_NEAR(found.foot.distance, expected, 2e-9);
            ASSERT_EQ(found.instance, instance);
            ASSERT_NEAR(length(found.point - x), found.foot.distance, 1e-12);
        }
    }
}

// Balls become ellipsoids.
TEST(PlacedNearest, of_stretched_parts_no_point_is_nearer) {
    Numbers random(6);
    int sure = 0;
    for (int trial = 0; trial < 20; ++trial) {
        const std::array<Rows, 5> uses = placements(random, false);
        const Model model = balls(uses);
        ModelLocator locator(model);
        std::vector<Vector3> points;
        for (const auto &way : ways()) {
            for (int i = 0; i < 300; ++i) {
                const Vector3 x = random.point(1);
                points.push_back(image(uses, way, (radius / length(x)) * x));
            }
        }
        for (int i = 0; i < 20; ++i) {
            const Vector3 x = random.point(12);
            const ModelFoot found = locator.nearest(x, 1e-9);
            sure += certified(found) ? 1 : 0;
            const auto way = std::ranges::find(numbers_of_instances, found.instance);
            ASSERT_NE(way, numbers_of_instances.end());
            const auto &uses_of_it = ways()[static_cast<size_t>(way - numbers_of_instances.begin())];
            ASSERT_NEAR(size_of(in_ball(uses, uses_of_it, found.point, false)), radius, 1e-12);
            for (const Vector3 &other : points) {
                ASSERT_LE(found.foot.distance, length(other - x) + 1e-9);
            }
        }
    }
    EXPECT_GE(sure, 396);
}

// A ball with a hole, whose loop runs around it with the ball to its left: what is stretched stays the same part.
TEST(PlacedNearest, of_stretched_faces_are_of_the_same_part) {
    const SplinePtr ball =
        build::sphere(build::make_placement(3, nullptr, nullptr, nullptr, "centre"), radius, 0);
    const SplinePtr hole = make_spline({make_knot_vector(1, {0, 0, 1, 2, 3, 4, 4})}, 2, Form::polynomial,
                                       {0.4, 0.4, 0.4, 0.6, 0.6, 0.6, 0.6, 0.4, 0.4, 0.4}, {});
    face::FaceParts parts{ball, {{{hole, nullptr}}}, 1e-9};
    parts.as_oriented = true;
    Model model = model_of_faces({std::make_shared<const face::Face>(parts, nullptr)}, 1);
    for (const double stretch : {1.0, 1.0001, 1.5, 1e-6}) {
        model.uses[0].placement = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, stretch, 0};
        model.rays = {};
        ModelLocator locator(model);
        const ModelFoot over_hole = locator.nearest({-2 * radius, 0, 0}, 1e-9);
        EXPECT_TRUE(certified(over_hole));
        EXPECT_GT(over_hole.foot.distance, 1.001 * radius) << stretch;
        const ModelFoot opposite = locator.nearest({2 * radius, 0, 0}, 1e-9);
        EXPECT_NEAR(opposite.foot.distance, radius, 1e-8) << stretch;
    }
}

TEST(PlacedNearest, of_no_faces_is_infinitely_far) {
    const Model model;
    const ModelFoot found = ModelLocator(model).nearest({1, 2, 3}, 0);
    EXPECT_TRUE(certified(found));
    EXPECT_TRUE(std::isinf(found.foot.distance));
    EXPECT_TRUE(std::isnan(found.point.x));
    EXPECT_EQ(found.face, -1);
}

} // namespace model_near_unit_test
