// Rays on parts that are placed in parts, against the equation of a ball under the same maps.
#include "base/error.h"
#include "model/rays/classify.h"
#include "placed_balls.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace model_rays_unit_test {

namespace {

using namespace placed_balls;

// The roots of |o + t d| = radius, NaN if there are none, and by how much there might be.
struct Roots {
    double first, second, margin;
};
Roots roots(const Long &o, const Long &d) {
    long double a = 0, b = 0, c = -static_cast<long double>(radius) * radius;
    for (size_t k = 0; k < 3; ++k) {
        a += d[k] * d[k];
        b += d[k] * o[k];
        c += o[k] * o[k];
    }
    const long double disc = b * b - a * c, root = std::sqrt(disc);
    return {static_cast<double>((-b - root) / a), static_cast<double>((-b + root) / a),
            static_cast<double>(disc / a)};
}

} // namespace

TEST(PlacedRays, instances_are_the_ways_to_parts) {
    Numbers random(1);
    const Model model = balls(placements(random, true));
    const std::vector<Instance> found = instances_of(model);
    ASSERT_EQ(found.size(), 7U);
    constexpr std::array<int64_t, 7> uses{0, 1, 3, 4, 2, 3, 4}, parents{-1, -1, 1, 1, -1, 4, 4},
        parts{0, 1, 0, 0, 1, 0, 0};
    for (size_t i = 0; i < 7; ++i) {
        EXPECT_EQ(found[i].use, uses[i]);
        EXPECT_EQ(found[i].parent, parents[i]);
        EXPECT_EQ(found[i].part, parts[i]);
    }
}

TEST(PlacedRays, meet_placed_balls_first_where_their_equations_say) {
    Numbers random(2);
    int certified = 0, hits = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const std::array<Rows, 5> uses = placements(random, trial % 2 == 0);
        const Model model = balls(uses);
        ModelCaster caster(model, scene_of(model));
        for (int i = 0; i < 30; ++i) {
            const Vector3 from = random.point(20), along = random.point(8) - from;
            double first = HUGE_VAL;
            int64_t instance = -1;
            for (size_t k = 0; k < 5; ++k) {
                const Roots t =
                    roots(in_ball(uses, ways()[k], from, false), in_ball(uses, ways()[k], along, true));
                const double own = t.first >= 0 ? t.first : t.second;
                if (t.margin > 0 && own >= 0 && own < first) {
                    first = own;
                    instance = numbers_of_instances[k];
                }
            }
            const ModelAnswer found = caster.first({from, along});
            if ((found.answer.status & intersect::ray_certified) == 0) {
                continue;
            }
            ++certified;
            ASSERT_EQ((found.answer.status & intersect::ray_hit) != 0, instance >= 0);
            ASSERT_EQ(found.instance, instance);
            if (instance >= 0) {
                ++hits;
                ASSERT_NEAR(found.answer.t, first, 1e-9);
            }
        }
    }
    EXPECT_GE(certified, 1780);
    EXPECT_GE(hits, 300);
}

// A point in any of them is inside.
TEST(PlacedRays, sides_are_those_of_the_union) {
    Numbers random(3);
    int inside = 0, undecided = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const std::array<Rows, 5> uses = placements(random, trial % 2 == 0);
        const Model model = balls(uses);
        Classifier exactly(model, 0), nearly(model, 1e-3);
        for (int i = 0; i < 30; ++i) {
            const Vector3 x = random.point(10);
            bool in = false;
            for (const auto &way : ways()) {
                const Long at = in_ball(uses, way, x, false);
                in = in || at[0] * at[0] + at[1] * at[1] + at[2] * at[2] < radius * radius;
            }
            for (Classifier *classifier : {&exactly, &nearly}) {
                const Side side = classifier->side(x);
                undecided += side == side_undecided ? 1 : 0;
                if (side == side_inside || side == side_outside) {
                    ASSERT_EQ(side == side_inside, in);
                }
            }
            inside += in ? 1 : 0;
        }
    }
    EXPECT_GE(inside, 30);
    EXPECT_LE(undecided, 40);
}

// What is near is told in the whole, whatever the units of the part.
TEST(PlacedRays, sides_beside_a_part_are_clear_at_every_scale) {
    for (const double scale : {1e-4, 1.0, 1e4}) {
        const Rows placement{scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0};
        const Model model = one_ball(placement);
        const double tolerance = 1e-6 * scale * radius;
        Classifier classifier(model, tolerance);
        for (const double beside : {-2.0, -0.5, 0.5, 2.0}) {
            const Vector3 x = (scale * radius + beside * tolerance) * unit(Vector3{1, 2, 3});
            EXPECT_EQ(classifier.side(x), beside < -1  ? side_inside
                                          : beside > 1 ? side_outside
                                                       : side_on)
                << scale << ' ' << beside;
        }
    }
}

// The determinant of the matrix is not representable.
TEST(PlacedRays, placements_may_be_as_small_or_large_as_numbers) {
    for (const double scale : {1e-200, -1e-110, 1e110, -1e200}) {
        const Model model = one_ball({0, scale, 0, 0, 0, 0, scale, 0, scale, 0, 0, 0});
        const Placement placement(instances_of(model), 0);
        EXPECT_EQ(placement.mirrors(), scale < 0);
        EXPECT_NEAR(placement.growth_to_whole() / std::abs(scale), 1, 1e-14);
        EXPECT_NEAR(placement.growth_to_part() * std::abs(scale), 1, 1e-14);
        const Vector3 x = placement.moved(scale * Vector3{1, 2, 3});
        EXPECT_NEAR(length(x - Vector3{3, 1, 2}), 0, 1e-14);
    }
}

TEST(PlacedRays, need_placements_that_can_be_inverted) {
    Numbers random(4);
    std::array<Rows, 5> uses = placements(random, true);
    uses[4] = {1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0};
    const Model model = balls(uses);
    EXPECT_THROW(static_cast<void>(scene_of(model)), Error);
    EXPECT_EQ(instances_of(model).size(), 7U);
}

// Parts in parts, each twice: 2^21 of them.
TEST(PlacedRays, are_refused_where_parts_multiply) {
    Model model;
    for (int64_t i = 0; i < 21; ++i) {
        model.parts.emplace_back();
        model.uses.push_back({i - 1, i, Use{}.placement, ""});
        model.uses.push_back({i - 1, i, Use{}.placement, ""});
    }
    try {
        static_cast<void>(instances_of(model));
        FAIL();
    } catch (const Error &error) {
        EXPECT_EQ(error.status(), Status::too_large);
    }
}

} // namespace model_rays_unit_test
