// Critical points of the distance at poles of surfaces, edges that are points: one each, of the kind that
// follows from the curvature there.
#include "property/critical_points.h"
#include "property/made_shapes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace patch_poles_test {

using namespace support;

namespace {

// With semi-axes a across and c along the z axis; poles at (0, 0, -c) and (0, 0, c).
SplineData ellipsoid(Random &random, double a, double c) {
    const double half = std::acos(0.0);
    return revolved(ellipse_arc(0, 0, a, c, -half, 2 * half), random.between(-3, 3), 4 * half);
}

// The kinds of the points found that are within a distance of a pole.
std::vector<int32_t> kinds_near(const nurbs *g, const Critical &found, double height, double within) {
    std::vector<int32_t> kinds;
    for (size_t i = 0; i < found.kinds.size(); ++i) {
        const std::vector<double> p = eval(g, {found.params[2 * i], found.params[2 * i + 1]});
        if (std::hypot(p[0], p[1], p[2] - height) <= within) {
            kinds.push_back(found.kinds[i]);
        }
    }
    return kinds;
}

// Seen from inside, the distance has a minimum at a pole that is nearer than the radius of curvature a^2 / c.
int32_t expected(double a, double c, double height, double z) {
    const double d = height > 0 ? c - z : c + z;
    return d < a * a / c ? NURBS_CRITICAL_MINIMUM : NURBS_CRITICAL_MAXIMUM;
}

TEST(PatchPoles, are_found_once_and_of_their_kind) {
    int certified = 0, isolated = 0;
    for (uint64_t seed = 2600000; seed < 2600150; ++seed) {
        Random random(seed);
        const double size = random.magnitude(1e-6, 1e6), a = size * random.between(0.5, 2),
                     c = size * random.between(0.5, 2), radius = a * a / c;
        const Handle g = create(ellipsoid(random, a, c));
        const double z = size * random.between(-4, 4), tolerance = size * random.magnitude(1e-5, 1e-3);
        if (std::fabs(std::fabs(c - z) - radius) < 0.1 * radius ||
            std::fabs(std::fabs(c + z) - radius) < 0.1 * radius || std::fabs(std::fabs(z) - c) < 0.1 * c) {
            continue; // undecided to the tolerance
        }
        const double aside = random.chance(50) ? 1e-3 * tolerance * random.unit() : 0;
        const Critical found = critical(g.get(), {aside, aside / 3, z}, tolerance);
        for (const double height : {-c, c}) {
            EXPECT_EQ(kinds_near(g.get(), found, height, tolerance),
                      std::vector<int32_t>{expected(a, c, height, z)})
                << "seed " << seed << ", pole " << height;
        }
        // Outside the evolute there are no others.
        if (std::fabs(z) > c && std::fabs(z) > std::fabs(c - radius) && aside == 0) {
            ++isolated;
            certified += found.status == NURBS_CLOSEST_CERTIFIED && found.kinds.size() == 2 ? 1 : 0;
        }
    }
    EXPECT_GE(isolated, 20);
    EXPECT_EQ(certified, isolated);
}

// Without a tolerance they are as far apart as rounding leaves open, and that is told.
TEST(PatchPoles, are_not_scattered_by_rounding) {
    for (uint64_t seed = 2610000; seed < 2610060; ++seed) {
        Random random(seed);
        const double size = random.magnitude(1e-6, 1e6), a = size * random.between(0.5, 2),
                     c = size * random.between(0.5, 2);
        const Handle g = create(ellipsoid(random, a, c));
        const double z = size * random.between(5, 9) * (random.chance(50) ? 1 : -1);
        const Critical found = critical(g.get(), {0, 0, z}, 0);
        ASSERT_EQ(found.kinds.size(), 2U) << "seed " << seed;
        EXPECT_NEAR(std::min(found.distances[0], found.distances[1]), std::fabs(z) - c, 1e-12 * size);
        EXPECT_NEAR(std::max(found.distances[0], found.distances[1]), std::fabs(z) + c, 1e-12 * size);
        EXPECT_EQ(found.kinds[0] + found.kinds[1], NURBS_CRITICAL_MINIMUM + NURBS_CRITICAL_MAXIMUM);
    }
}

// Poles on knots inside the domain, where nothing else is equally far: profiles that go all the way round, turned by
// half a turn, stretched across.
TEST(PatchPoles, inside_the_domain_are_certified) {
    int found_all = 0, certified = 0;
    for (uint64_t seed = 2600300; seed < 2600320; ++seed) {
        Random random(seed);
        const double a = random.between(0.8, 1.2), c = random.between(0.8, 1.2), half = std::acos(0.0);
        const Handle round =
            create(revolved(ellipse_arc(0, 0, a, c, 0, 4 * half), random.between(-3, 3), 2 * half));
        const double matrix[] = {1.3, 0.2, 0, 0.2, 0.8, 0, 0, 0, 1};
        const Handle g =
            made([&](nurbs **out) { return nurbs_transform(round.get(), 3, matrix, nullptr, out); });
        const Critical found = critical(g.get(), {0, 0, random.between(4, 6)}, 1e-4);
        const bool poles =
            !kinds_near(g.get(), found, c, 1e-4).empty() && !kinds_near(g.get(), found, -c, 1e-4).empty();
        found_all += poles ? 1 : 0;
        certified += found.status == NURBS_CLOSEST_CERTIFIED ? 1 : 0;
    }
    EXPECT_EQ(found_all, 20);
    EXPECT_EQ(certified, 20);
}

// A point beside the axis has two feet on a sphere, on the line through the centre: no pole is one.
TEST(PatchPoles, that_are_not_critical_are_not_found) {
    for (uint64_t seed = 2620000; seed < 2620060; ++seed) {
        Random random(seed);
        const SplineData data = ellipsoid(random, 1, 1);
        const Handle g = create(data);
        const double angle = random.between(-3, 3), r = random.magnitude(0.05, 1), z = random.between(-2, 2);
        const Critical found = critical(g.get(), {r * std::cos(angle), r * std::sin(angle), z}, 1e-4);
        EXPECT_EQ(found.status, NURBS_CLOSEST_CERTIFIED) << "seed " << seed;
        EXPECT_TRUE(kinds_near(g.get(), found, 1, 1e-3).empty()) << "seed " << seed;
        EXPECT_TRUE(kinds_near(g.get(), found, -1, 1e-3).empty()) << "seed " << seed;
    }
}

} // namespace

} // namespace patch_poles_test
