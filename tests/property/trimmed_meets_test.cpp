// Meets trimmed to faces: lines over polygons as exact arithmetic cuts them, chords of discs, arcs across seams, whole faces.
#include "faces.h"
#include "sections.h"

#include <numbers>

namespace trimmed_meets_test {

using surface_sections::Found;
using surface_sections::MeetHandle;
using surface_sections::Point3;
using namespace support;

namespace {

constexpr double pi = std::numbers::pi;

Found trimmed_sections(const nurbs *g, const nurbs_face *face, const Point3 &normal,
                       const std::vector<double> &offsets, double tolerance) {
    nurbs_meet *whole = nullptr, *meet = nullptr;
    require_ok(
        nurbs_surface_sections(g, normal.data(), std::ssize(offsets), offsets.data(), tolerance, &whole));
    const MeetHandle owner(whole);
    require_ok(nurbs_meet_trim(whole, face, &meet));
    return surface_sections::found_in(MeetHandle(meet).get());
}

Handle unit_plane() {
    const double origin[] = {0, 0, 0}, u[] = {1, 0, 0}, v[] = {0, 1, 0};
    return made([&](nurbs **out) { return nurbs_surface_plane(3, origin, u, v, out); });
}

Handle closed_polygon(const std::vector<double> &corners) {
    std::vector<double> points = corners;
    points.insert(points.end(), corners.begin(), corners.begin() + 2);
    const int64_t n = std::ssize(points) / 2;
    std::vector<double> knots{0};
    for (int64_t i = 0; i < n; ++i) {
        knots.push_back(static_cast<double>(i));
    }
    knots.push_back(static_cast<double>(n - 1));
    const int32_t degree = 1;
    return made([&](nurbs **out) {
        return nurbs_create(1, &degree, &n, knots.data(), n + 2, 2, points.data(), 0, 0, nullptr, 0, 0, out);
    });
}

// A star about the middle: it does not cross itself.
std::vector<double> random_star(Random &random) {
    const int n = random.whole(3, 12);
    std::vector<double> corners;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * pi * (i + 0.8 * random.unit()) / n, radius = random.between(0.05, 0.45);
        corners.push_back(0.5 + radius * std::cos(angle));
        corners.push_back(0.5 + radius * std::sin(angle));
    }
    return corners;
}

// Where the line u = c is inside of a polygon: lower and upper ends in turn.
std::vector<double> ends_on(const std::vector<double> &corners, double c) {
    std::vector<double> ends;
    const size_t n = corners.size() / 2;
    for (size_t i = 0; i < n; ++i) {
        const double *a = &corners[2 * i], *b = &corners[2 * ((i + 1) % n)];
        if ((a[0] < c) != (b[0] < c)) {
            ends.push_back(a[1] + (b[1] - a[1]) * ((c - a[0]) / (b[0] - a[0])));
        }
    }
    std::ranges::sort(ends);
    return ends;
}

} // namespace

TEST(TrimmedMeets, of_planes_are_what_lines_have_in_polygons) {
    const Handle ground = unit_plane();
    for_each_case(3500000, 200, [&](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const std::vector<double> corners = random_star(random);
        const Handle loop = closed_polygon(corners);
        const faces::Face face = faces::face_of(ground.get(), {{loop.get()}});
        std::vector<double> offsets;
        for (int i = 0; i < 10; ++i) {
            offsets.push_back(random.chance(20) ? corners[2 * static_cast<size_t>(i % 3)] + 1e-9
                                                : random.unit());
        }
        const Found found = trimmed_sections(ground.get(), face.get(), {1, 0, 0}, offsets, 1e-9);
        EXPECT_TRUE(found.complete);
        std::vector<std::vector<double>> seen(offsets.size());
        for (const auto &branch : found.branches) {
            EXPECT_EQ(branch.loop, -1);
            const auto ends =
                surface_sections::points_on(branch.space.get(), {branch.domain[0], branch.domain[1]});
            seen[static_cast<size_t>(branch.level)].push_back(ends[0][1]);
            seen[static_cast<size_t>(branch.level)].push_back(ends[1][1]);
        }
        for (size_t i = 0; i < offsets.size(); ++i) {
            std::ranges::sort(seen[i]);
            const std::vector<double> expected = ends_on(corners, offsets[i]);
            double more = 0, given = 0; // shorter ones than rounding may be there or not
            for (size_t j = 0; j + 1 < expected.size(); j += 2) {
                given += expected[j + 1] - expected[j];
            }
            for (size_t j = 0; j + 1 < seen[i].size(); j += 2) {
                more += seen[i][j + 1] - seen[i][j];
            }
            EXPECT_NEAR(more, given, 1e-7) << "u = " << offsets[i];
        }
    });
}

TEST(TrimmedMeets, of_a_disc_are_its_chords) {
    const Handle ground = unit_plane();
    const double centre[] = {0.5, 0.5};
    const Handle circle = made([&](nurbs **out) {
        return nurbs_curve_circle(2, centre, nullptr, nullptr, 0.4, NURBS_ARC_QUARTERS, out);
    });
    const faces::Face face = faces::face_of(ground.get(), {{circle.get()}});
    for (const double height : {0.0, 0.1, 0.3999, -0.2, 0.41}) {
        const Found found = trimmed_sections(ground.get(), face.get(), {0, 1, 0}, {0.5 + height}, 1e-9);
        EXPECT_TRUE(found.complete);
        const double half = std::sqrt(std::max(0.16 - height * height, 0.0));
        EXPECT_EQ(found.branches.size(), half > 0 ? 1U : 0U);
        EXPECT_NEAR(length_of(found), 2 * half, 1e-9);
        EXPECT_EQ(found.count(NURBS_NODE_BORDER), half > 0 ? 2 : 0);
    }
}

// A window across the seam of a cylinder: half of each circle, which begins in it.
TEST(TrimmedMeets, go_on_across_seams) {
    const Handle cylinder = made([](nurbs **out) {
        return nurbs_surface_cylinder(nullptr, nullptr, nullptr, 1, 2, 0, 2 * pi, NURBS_ARC_QUARTERS, out);
    });
    const Handle window = closed_polygon({-0.25, 0.2, 0.25, 0.2, 0.25, 0.8, -0.25, 0.8});
    const faces::Face face = faces::face_of(cylinder.get(), {{window.get()}});
    const Found inside = trimmed_sections(cylinder.get(), face.get(), {0, 0, 1}, {1, 0.2, 1.7}, 1e-7);
    EXPECT_TRUE(inside.complete);
    EXPECT_EQ(inside.branches.size(), 2U);
    EXPECT_NEAR(length_of(inside), pi, 1e-6);
    EXPECT_EQ(inside.loops(), 0);
    const Found upright = trimmed_sections(cylinder.get(), face.get(), {0, 1, 0}, {0.5}, 1e-7);
    EXPECT_NEAR(length_of(upright), 1.2, 1e-9);
}

TEST(TrimmedMeets, of_whole_faces_are_as_they_were) {
    const Handle sphere = made([](nurbs **out) {
        return nurbs_surface_sphere(nullptr, nullptr, nullptr, 1, NURBS_ARC_QUARTERS, out);
    });
    nurbs_face *made_face = nullptr;
    require_ok(
        nurbs_face_create(sphere.get(), 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0, nullptr, &made_face));
    const faces::Face face(made_face);
    const Point3 normal{0.6, 0, 0.8};
    const std::vector<double> offsets{-0.5, 0, 0.3, 1};
    const Found before = surface_sections::sections_of(sphere.get(), normal, offsets, 1e-6);
    const Found after = trimmed_sections(sphere.get(), face.get(), normal, offsets, 1e-6);
    EXPECT_TRUE(after.complete);
    EXPECT_EQ(after.branches.size(), before.branches.size());
    EXPECT_EQ(after.loops(), before.loops());
    EXPECT_EQ(after.nodes.size(), before.nodes.size());
    EXPECT_EQ(after.count(NURBS_NODE_TOUCH), 1);
    EXPECT_NEAR(length_of(after), length_of(before), 1e-9);
}

} // namespace trimmed_meets_test
