// What of the curves in which two surfaces meet lies in faces of them: as much as lies in both by their sides, in any order, and
// where the surfaces are exchanged.
#include "crossings.h"
#include "faces.h"
#include "made_shapes.h"
#include "support/scale.h"

#include <numbers>

namespace crossings_in_faces {

using namespace surface_crossings;

namespace {

constexpr double tolerance = 1e-7;

SplineData hills(Random &random) {
    const bool rational = random.chance(50);
    return net_of({random.whole(4, 7), random.whole(4, 7)}, {3, 3}, rational, [&](double u, double v) {
        return std::array<double, 4>{u + random.between(-0.05, 0.05), v + random.between(-0.05, 0.05),
                                     random.between(-0.3, 0.3), random.between(0.5, 2)};
    });
}

// A polygon about the middle of the domain of a surface that does not cross itself.
faces::Face star_on(const nurbs *g, Random &random) {
    const int n = random.whole(3, 9);
    std::vector<double> points, knots{0};
    for (int i = 0; i <= n; ++i) {
        const double angle = 2 * std::numbers::pi * (i % n + 0.5) / n, radius = random.between(0.1, 0.49);
        points.push_back(0.5 + radius * std::cos(angle));
        points.push_back(0.5 + radius * std::sin(angle));
        knots.push_back(i);
    }
    knots.push_back(n);
    std::copy_n(points.begin(), 2, points.end() - 2);
    const int32_t degree = 1;
    const int64_t count = n + 1;
    const Handle loop = made([&](nurbs **out) {
        return nurbs_create(1, &degree, &count, knots.data(), count + 2, 2, points.data(), 0, 0, nullptr, 0,
                            0, out);
    });
    return faces::face_of(g, {{loop.get()}});
}

MeetHandle meet_of(const Handle &a, const Handle &b) {
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_surface_intersections(a.get(), b.get(), tolerance, &meet));
    return MeetHandle(meet);
}
MeetHandle part_in(const MeetHandle &whole, const nurbs_face *face, bool second) {
    nurbs_meet *meet = nullptr;
    require_ok((second ? nurbs_meet_trim_second : nurbs_meet_trim)(whole.get(), face, &meet));
    return MeetHandle(meet);
}

// How much of the curves lies in both faces by the sides of samples, and how far the samples may be from the ends.
struct Share {
    double length = 0, room = 0;
};
Share share_in(const Crossing &whole, const nurbs_face *a, const nurbs_face *b) {
    constexpr int n = 500;
    Share share;
    for (size_t i = 0; i < whole.found.branches.size(); ++i) {
        const Branch &branch = whole.found.branches[i];
        std::vector<double> middles, on_a, on_b;
        for (int k = 0; k < n; ++k) {
            middles.push_back(branch.domain[0] + (branch.domain[1] - branch.domain[0]) * (k + 0.5) / n);
        }
        for (const Place &at : places_on(branch.on.get(), middles)) {
            on_a.insert(on_a.end(), at.begin(), at.end());
        }
        for (const Place &at : places_on(whole.on_second[i].get(), middles)) {
            on_b.insert(on_b.end(), at.begin(), at.end());
        }
        const std::vector<int32_t> sides_a = faces::sides(a, on_a), sides_b = faces::sides(b, on_b);
        const std::vector<Point3> x = points_on(branch.space.get(), branch.params(n));
        bool before = false;
        for (size_t k = 0; k < sides_a.size(); ++k) {
            const bool inside = sides_a[k] >= 0 && sides_b[k] >= 0;
            const double step = surface_sections::distance(x[k], x[k + 1]);
            share.length += inside ? step : 0;
            share.room += (k > 0 && inside != before ? step : 0) + 1e-4 * step;
            before = inside;
        }
    }
    return share;
}

void expect_common_domains(const Crossing &crossing) {
    for (size_t i = 0; i < crossing.found.branches.size(); ++i) {
        for (const Handle *curve : {&crossing.found.branches[i].on, &crossing.on_second[i]}) {
            std::array<double, 2> domain{};
            require_ok(nurbs_domain(curve->get(), 0, domain.data()));
            EXPECT_EQ(domain, crossing.found.branches[i].domain);
        }
    }
}

} // namespace

TEST(CrossingsInFaces, AreWhatLiesInBoth) {
    for_each_case(6310000, 30, [](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const SplineData one = hills(random), other = hills(random);
        const Handle a = create(one), b = create(other);
        const faces::Face in_a = star_on(a.get(), random), in_b = star_on(b.get(), random);
        const MeetHandle whole = meet_of(a, b), back = meet_of(b, a);
        const Crossing both = crossing_in(part_in(part_in(whole, in_a.get(), false), in_b.get(), true).get()),
                       other_order =
                           crossing_in(part_in(part_in(whole, in_b.get(), true), in_a.get(), false).get()),
                       exchanged =
                           crossing_in(part_in(part_in(back, in_b.get(), false), in_a.get(), true).get());
        const Share expected = share_in(crossing_in(whole.get()), in_a.get(), in_b.get());
        const double length = length_of(both.found);
        EXPECT_NEAR(length, expected.length, expected.room + 1e-6);
        EXPECT_NEAR(length_of(other_order.found), length, 1e-6);
        EXPECT_NEAR(length_of(exchanged.found), length, 1e-4);
        EXPECT_EQ(both.found.branches.size(), other_order.found.branches.size());
        expect_common_domains(both);
        check_curves(both, Ground(a.get(), one), Ground(b.get(), other), 100);
        check_nodes(both, 1e-8);
    });
}

// A window across the seam of a cylinder that is periodic there, and a plane around it: half of a circle, whose nodes are in the
// domain of the cylinder though the curve runs on over the seam.
TEST(CrossingsInFaces, GoOnAcrossSeams) {
    const Handle clamped = made([](nurbs **out) {
        return nurbs_surface_cylinder(nullptr, nullptr, nullptr, 1, 2, 0, 2 * std::numbers::pi,
                                      NURBS_ARC_SMOOTH, out);
    });
    const Handle tube =
        made([&](nurbs **out) { return nurbs_make_periodic(clamped.get(), 0, 1e-9, nullptr, nullptr, out); });
    const double origin[] = {-0.5, -3, 1}, u[] = {6, 0, 0}, v[] = {0, 6, 0}; // an arc over the seam
    const Handle plane = made([&](nurbs **out) { return nurbs_surface_plane(3, origin, u, v, out); });
    const MeetHandle whole = meet_of(plane, tube);
    nurbs_face *made_face = nullptr; // x >= 0 on the plane
    const double at = 0.5 / 6, corners[] = {at, 0, 1, 0, 1, 1, at, 1, at, 0}, knots[] = {0, 0, 1, 2, 3, 4, 4};
    const int32_t degree = 1;
    const int64_t count = 5;
    const Handle loop = made([&](nurbs **out) {
        return nurbs_create(1, &degree, &count, knots, 7, 2, corners, 0, 0, nullptr, 0, 0, out);
    });
    const int64_t one = 1;
    const nurbs *curve = loop.get();
    require_ok(
        nurbs_face_create(plane.get(), 1, &one, &curve, nullptr, nullptr, 1e-9, 0, nullptr, &made_face));
    const faces::Face half(made_face);
    const Crossing found = crossing_in(part_in(whole, half.get(), false).get());
    EXPECT_TRUE(found.found.complete);
    EXPECT_NEAR(length_of(found.found), std::numbers::pi, 1e-5);
    double domain[2];
    require_ok(nurbs_domain(tube.get(), 0, domain));
    for (const MeetPart &node : found.on_b) {
        EXPECT_GE(node.at[0], domain[0]);
        EXPECT_LE(node.at[0], domain[1]);
    }
    EXPECT_EQ(found.found.count(NURBS_NODE_BORDER), 2);
}

// What is undecided beside a face is none of it: a square lies in a plane up to a crease of that, outside of the face and
// in it.
TEST(CrossingsInFaces, WhatIsUndecidedOutsideIsLeftOut) {
    const Handle square = create(net_of({2, 2}, {1, 1}, false, [](double x, double y) {
        return std::array<double, 4>{x - 0.5, y - 0.5, 1, 1};
    }));
    const Handle plane = create(net_of({33, 33}, {1, 1}, false, [](double x, double y) {
        return std::array<double, 4>{8 * x - 4.1, 8 * y - 4.1, 1 + std::max(0.0, 8 * x - 4.1), 1};
    }));
    const MeetHandle whole = meet_of(plane, square);
    ASSERT_FALSE(found_in(whole.get()).complete);
    const int32_t degree = 1;
    const int64_t count = 5, one = 1;
    for (const bool around : {false, true}) {
        const double lower = around ? 0.25 : 0.75, upper = 0.875, knots[] = {0, 0, 1, 2, 3, 4, 4},
                     corners[] = {lower, lower, upper, lower, upper, upper, lower, upper, lower, lower};
        const Handle loop = made([&](nurbs **out) {
            return nurbs_create(1, &degree, &count, knots, 7, 2, corners, 0, 0, nullptr, 0, 0, out);
        });
        const nurbs *curve = loop.get();
        nurbs_face *face = nullptr;
        require_ok(
            nurbs_face_create(plane.get(), 1, &one, &curve, nullptr, nullptr, 1e-9, 0, nullptr, &face));
        const faces::Face owner(face);
        EXPECT_EQ(found_in(part_in(whole, face, false).get()).complete, !around);
    }
}

} // namespace crossings_in_faces
