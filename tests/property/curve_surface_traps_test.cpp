// Where curves meet surfaces at poles, seams, borders, corners and knots, touch them, lie on them, or are degenerate.
#include "support/cases.h"
#include "surface_meets.h"

#include <numbers>

namespace curve_surface_traps_test {

using namespace support;
using namespace surface_meets;

namespace {

Handle cylinder() { // of radius 1, from z = 0 to 1
    return made([](nurbs **out) {
        return nurbs_surface_cylinder(nullptr, nullptr, nullptr, 1, 1, 0, 2 * std::numbers::pi,
                                      NURBS_ARC_QUARTERS, out);
    });
}
Handle square() { // z = 0, x and y from 0 to 1
    return create(patch(1, 1, {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0}));
}
// A smooth cubic surface over a grid of heights between -0.5 and 0.5.
SplineData hills(Random &random, int count) {
    SplineData data{{3, 3}, {count, count}, {{}, {}}, 3, {}, {}, 0};
    for (Vec &knots : data.knots) {
        for (int i = 0; i < count + 4; ++i) {
            knots.push_back(std::clamp(i - 3, 0, count - 3));
        }
    }
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) {
            data.points.insert(data.points.end(), {1.0 * i, 1.0 * j, random.between(-0.5, 0.5)});
        }
    }
    return data;
}

void expect_one(const Hits &hits, int32_t kind, double at, double by) {
    ASSERT_EQ(hits.size(), 1U);
    EXPECT_EQ(hits.complete, 1);
    EXPECT_EQ(hits.kinds[0], kind);
    EXPECT_NEAR(hits.t[0], at, by);
}
void expect_overlap(const Hits &hits, double from, double to, double by) {
    ASSERT_EQ(hits.size(), 1U);
    EXPECT_EQ(hits.complete, 1);
    EXPECT_EQ(hits.kinds[0], NURBS_HIT_OVERLAP);
    EXPECT_NEAR(hits.ranges_curve[0], from, by);
    EXPECT_NEAR(hits.ranges_curve[1], to, by);
}

} // namespace

// S_u is 0 there, and all of an axis is one point.
TEST(CurveSurfaceTraps, poles_and_seams_are_met_once) {
    const Handle ball = sphere();
    for (const double tolerance : {0.0, 1e-9, 1e-4}) {
        for (const Handle &through : {line({0, 0, -2}, {0, 0, 3}), line({-0.5, 0.25, -2}, {0.5, -0.25, 2}),
                                      line({-2, 0, 0.25}, {2, 0, 0.25}), line({-2, 1, 0}, {2, -1, 0})}) {
            const Hits hits = meets(through, ball, tolerance);
            EXPECT_EQ(hits.count(NURBS_HIT_CROSSING), 2) << tolerance;
            EXPECT_EQ(hits.size(), 2U) << tolerance;
            EXPECT_EQ(hits.complete, 1) << tolerance;
        }
        // From the seam to inside, and obliquely through a pole.
        expect_one(meets(line({2, 0, 0}, {0, 0, 0}), ball, tolerance), NURBS_HIT_CROSSING, 0.5, 1e-9);
        expect_one(meets(line({1, 1, 2}, {-0.25, -0.25, 0.75}), ball, tolerance), NURBS_HIT_CROSSING, 0.8,
                   1e-9);
    }
}

TEST(CurveSurfaceTraps, touches_are_found_at_any_size) {
    for (const double size : {1e-150, 1e-3, 1.0, 1e3, 1e150}) {
        const Handle ball = made([&](nurbs **out) {
            return nurbs_surface_sphere(nullptr, nullptr, nullptr, size, NURBS_ARC_QUARTERS, out);
        });
        const auto scaled_line = [&](Vec a, Vec b) {
            for (Vec *end : {&a, &b}) {
                std::ranges::for_each(*end, [size](double &x) { x *= size; });
            }
            return line(a, b);
        };
        for (const Vec &start : {Vec{-2, 0.6, 0.8}, Vec{-2, 0, 1}, Vec{-2, 1, 0}}) {
            const Hits hits = meets(scaled_line(start, {3, start[1], start[2]}), ball, 1e-9 * size);
            expect_one(hits, NURBS_HIT_TANGENT, 0.4, 1e-4);
            EXPECT_LE(hits.ranges_curve[0], 0.4 + 1e-7);
            EXPECT_GE(hits.ranges_curve[1], 0.4 - 1e-7);
        }
        const double apart = 1 + 1e-6;
        const Handle beside = scaled_line({-2, 0.6 * apart, 0.8 * apart}, {3, 0.6 * apart, 0.8 * apart});
        expect_one(meets(beside, ball, 2e-6 * size), NURBS_HIT_CONTACT, 0.4, 1e-3);
        for (const double tolerance : {0.0, 0.3e-6 * size}) {
            const Hits none = meets(beside, ball, tolerance);
            EXPECT_EQ(none.size(), 0U) << size;
            EXPECT_EQ(none.complete, 1) << size;
        }
        const double inside = 1 - 1e-6; // twice through
        const Hits twice =
            meets(scaled_line({-2, 0.6 * inside, 0.8 * inside}, {3, 0.6 * inside, 0.8 * inside}), ball, 0);
        EXPECT_EQ(twice.count(NURBS_HIT_CROSSING), 2) << size;
        EXPECT_EQ(twice.complete, 1) << size;
    }
}

// z = t^3, which has the direction of the plane where it crosses it, also on a knot of the surface.
TEST(CurveSurfaceTraps, crossings_along_the_tangent_plane) {
    const Handle flat = square(), cut = insert(flat.get(), 0, 0.5, 1);
    const Handle curve = create(
        bezier(3, {0.25, 0.25, -1, 0.4375, 0.375, 1, 0.5625, 0.625, -1, 0.75, 0.75, 1})); // 8 (t - 1/2)^3
    for (const Handle *surface : {&flat, &cut}) {
        const Hits hits = meets(curve, *surface, 0);
        expect_one(hits, NURBS_HIT_CROSSING, 0.5, 1e-4);
    }
}

// An end on a surface is proven where both have one control point.
TEST(CurveSurfaceTraps, ends_and_borders) {
    const Handle flat = square();
    const Handle to_middle = line({0.25, 0.5, 1}, {0.5, 0.75, 0}), to_corner = line({2, 3, 1}, {1, 1, 0}),
                 past_border = line({1, 0.5, 1}, {1, 0.5, -1});
    EXPECT_EQ(meets(to_middle, flat, 0).count(NURBS_HIT_UNDECIDED), 1);
    EXPECT_EQ(meets(past_border, flat, 0).count(NURBS_HIT_UNDECIDED), 1);
    expect_one(meets(to_corner, flat, 0), NURBS_HIT_CROSSING, 1, 0);
    for (const double tolerance : {1e-12, 1e-3}) {
        expect_one(meets(to_middle, flat, tolerance), NURBS_HIT_CROSSING, 1, 1e-12);
        expect_one(meets(to_corner, flat, tolerance), NURBS_HIT_CROSSING, 1, 1e-12);
        expect_one(meets(past_border, flat, tolerance), NURBS_HIT_CROSSING, 0.5, 1e-12);
    }
    const Handle beside = line({1.0005, 0.5, 1}, {1.0005, 0.5, -1});
    expect_one(meets(beside, flat, 1e-3), NURBS_HIT_CONTACT, 0.5, 1e-3);
    EXPECT_EQ(meets(beside, flat, 1e-4).size(), 0U);
}

// The apex of a cone is touched from outside and crossed from there to inside; a generator ends there.
TEST(CurveSurfaceTraps, an_apex) {
    const Handle cone = made([](nurbs **out) {
        return nurbs_surface_cone(nullptr, nullptr, nullptr, 1, 0, 1, 0, 2 * std::numbers::pi,
                                  NURBS_ARC_QUARTERS, out);
    });
    for (const double y : {0.0, 0.25, 1.0}) {
        const Hits hits = meets(line({-1, -y, 1}, {1, y, 1}), cone, 1e-9);
        expect_one(hits, NURBS_HIT_TANGENT, 0.5, 1e-8);
        const Hits none = meets(line({-1, -y, 1.0625}, {1, y, 1.0625}), cone, 1e-9);
        EXPECT_EQ(none.size(), 0U);
        EXPECT_EQ(none.complete, 1);
    }
    expect_overlap(meets(line({-1, 0, 0}, {1, 0, 2}), cone, 1e-9), 0, 0.5, 1e-8);
}

// A line past the fold of a surface that runs back on itself meets both sheets; on the fold that cannot be told.
TEST(CurveSurfaceTraps, a_fold) {
    const Handle folded = create(patch(2, 1, {0, 0, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0, 0, 0, 0, 0, 1, 0}));
    EXPECT_EQ(meets(line({0.5, 0.5, 1}, {0.5, 0.5, -1}), folded, 0).count(NURBS_HIT_CROSSING), 2);
    EXPECT_EQ(meets(line({1.25, 0.5, 1}, {1.25, 0.5, -1}), folded, 0).size(), 0U);
    const Hits on_fold = meets(line({1, 0.5, 1}, {1, 0.5, -1}), folded, 0);
    EXPECT_EQ(on_fold.complete, 0);
    EXPECT_EQ(on_fold.count(NURBS_HIT_UNDECIDED), 1);
}

TEST(CurveSurfaceTraps, curves_in_surfaces_are_one_overlap) {
    const Handle ball = sphere();
    for (const double tolerance : {1e-11, 1e-9, 1e-3}) {
        const double axes[][3] = {{0, 0, 1}, {0, 0.6, 0.8}, {1, 0, 0}, {0.36, 0.48, 0.8}};
        for (const auto &axis : axes) {
            const Handle ring = made([&](nurbs **out) {
                return nurbs_curve_circle(3, nullptr, axis, nullptr, 1, NURBS_ARC_QUARTERS, out);
            });
            expect_overlap(meets(ring, ball, tolerance), 0, 1, 0);
        }
        expect_overlap(meets(iso(ball.get(), 0, 0.125), ball, tolerance), 0, 1, 0);
        expect_overlap(meets(line({0, 1, -1}, {0, 1, 3}), cylinder(), tolerance), 0.25, 0.5, 2 * tolerance);
        expect_overlap(meets(line({-1, 0.25, 0}, {3, 0.75, 0}), square(), tolerance), 0.25, 0.5,
                       2 * tolerance);
    }
    Random random(3060000);
    const SplineData data = hills(random, 8);
    const Handle surface = create(data);
    for (const double t : {0.0, 0.7, 2.0, 5.0}) {
        for (int axis = 0; axis < 2; ++axis) {
            expect_overlap(meets(iso(surface.get(), axis, t), surface, 1e-9), 0, 5, 0);
        }
    }
}

// Moved by half the tolerance they are as near; by three times that they are not.
TEST(CurveSurfaceTraps, curves_beside_surfaces) {
    Random random(3070000);
    const Handle surface = create(hills(random, 6));
    SplineData on = read_back(iso(surface.get(), 0, 1.3).get());
    const double tolerance = 1e-5;
    for (const double share : {0.5, -0.5, 3.0}) {
        SplineData moved = on;
        for (size_t i = 2; i < moved.points.size(); i += 3) {
            moved.points[i] += share * tolerance;
        }
        const Hits hits = meets(create(moved), surface, tolerance);
        EXPECT_EQ(hits.complete, 1) << share;
        if (share > 1) {
            EXPECT_EQ(hits.size(), 0U);
        } else {
            expect_overlap(hits, 0, 3, 0);
        }
    }
}

TEST(CurveSurfaceTraps, awkward_forms) {
    const Handle flat = square();
    const SplineData steps{{0}, {3}, {{0, 1, 2, 3}}, 3, {0.5, 0.5, 0, 0.25, 0.75, 0, 5, 5, 5}, {}, 0};
    const Hits on_steps = meets(create(steps), flat, 1e-9);
    EXPECT_EQ(on_steps.complete, 1);
    EXPECT_EQ(on_steps.count(NURBS_HIT_OVERLAP), 2);
    const SplineData jump{
        {1}, {4}, {{0, 0, 1, 1, 2, 2}}, 3, {0.5, 0.5, 2, 0.5, 0.5, 1, 0.5, 0.5, -1, 0.5, 0.5, -2}, {}, 0};
    EXPECT_EQ(meets(create(jump), flat, 0).size(), 0U); // in the gap
    const SplineData torn{{1, 1},
                          {4, 2},
                          {{0, 0, 1, 1, 2, 2}, {0, 0, 1, 1}},
                          3,
                          {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0, 2, 1, 0, 3, 0, 0, 3, 1, 0},
                          {},
                          0};
    const Handle halves = create(torn);
    EXPECT_EQ(meets(line({1.5, 0.5, 1}, {1.5, 0.5, -1}), halves, 0).size(), 0U);
    EXPECT_EQ(meets(line({2.5, 0.5, 1}, {2.5, 0.5, -1}), halves, 0).count(NURBS_HIT_CROSSING), 1);
    const Handle arch = create(bezier(3, {0, 0.5, 1, 0.5, 0.5, -3, 1, 0.5, 1}, {1, 1e-6, 1}));
    EXPECT_EQ(meets(arch, flat, 0).complete, 1);
    const SplineData ring{{2},
                          {6},
                          {{-2, -1, 0, 1, 2, 3, 4, 5, 6}},
                          3,
                          {0.5, 0.5, 1, 0.25, 0.5, 0, 0.5, 0.5, -1, 0.75, 0.5, 0, 0.5, 0.5, 1, 0.25, 0.5, 0},
                          {},
                          NURBS_PERIODIC};
    const Hits twice = meets(create(ring), flat, 1e-12);
    EXPECT_EQ(twice.count(NURBS_HIT_CROSSING), 2);
    EXPECT_EQ(twice.complete, 1);
    // Weights of 0, and a surface all of whose weights are negative.
    const Handle zero = create(bezier(3, {0.5, 0.5, 1, 0.5, 0.5, 9, 0.5, 0.5, -1}, {1, 0, 1}));
    EXPECT_EQ(meets(zero, flat, 0).count(NURBS_HIT_CROSSING), 1);
}

// Crossings beside seams of both, whose near places go on across them, have parameters of the domains.
TEST(CurveSurfaceTraps, crossings_beside_seams) {
    const SplineData ring{{2},
                          {6},
                          {{-2, -1, 0, 1, 2, 3, 4, 5, 6}},
                          3,
                          {1, 1, 0.5, -1, 1, 0.5, -1, -1, 0.5, 1, -1, 0.5, 1, 1, 0.5, -1, 1, 0.5},
                          {},
                          NURBS_PERIODIC};
    SplineData tube{{2, 1}, {6, 2}, {ring.knots[0], {0, 0, 1, 1}}, 3, {}, {}, NURBS_PERIODIC};
    for (size_t i = 0; i < ring.points.size(); i += 3) {
        const double x = ring.points[i], y = ring.points[i + 1];
        tube.points.insert(tube.points.end(), {x, y, 0, x, y, 1});
    }
    const Handle curve = create(ring), surface = create(tube);
    for (const double at : {1e-7, 0.5, 4 - 1e-7}) {
        const Vec x = point_of(curve.get(), at);
        const Handle along = create(patch(1, 1,
                                          {x[0] / 2, x[1] / 2, 0, x[0] / 2, x[1] / 2, 1, 1.5 * x[0],
                                           1.5 * x[1], 0, 1.5 * x[0], 1.5 * x[1], 1})),
                     across = line({x[0] / 2, x[1] / 2, 0.5}, {1.5 * x[0], 1.5 * x[1], 0.5});
        for (const double tolerance : {0.0, 1e-4}) {
            expect_one(meets(curve, along, tolerance), NURBS_HIT_CROSSING, at, 1e-12);
            const Hits hits = meets(across, surface, tolerance);
            expect_one(hits, NURBS_HIT_CROSSING, 0.5, 1e-12);
            EXPECT_NEAR(hits.uv[0], at, 1e-12);
        }
    }
}

// A limit of work: what is claimed is true, and what is not looked at is undecided.
TEST(CurveSurfaceTraps, limits_of_work_leave_places_undecided) {
    Random random(3080000);
    const SplineData data = hills(random, 12);
    const Handle surface = create(data);
    Vec points;
    for (int i = 0; i < 30; ++i) {
        points.insert(points.end(), {11 * random.unit(), 11 * random.unit(), random.between(-0.5, 0.5)});
    }
    SplineData polygon{{1}, {30}, {{0}}, 3, points, {}, 0};
    for (int i = 0; i < 30; ++i) {
        polygon.knots[0].push_back(i);
    }
    polygon.knots[0].push_back(29);
    const Handle curve = create(polygon);
    const Hits all = meets(curve, surface, 0);
    ASSERT_EQ(all.complete, 1);
    ASSERT_GE(all.size(), 10U);
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    for (const int64_t work : {1, 10, 100, 10000, 1000000}) {
        call.work = work;
        Vec ranges(2 * 10000);
        std::vector<int32_t> kinds(10000);
        int64_t count = 0;
        int32_t complete = -1;
        require_ok(nurbs_curve_surface_intersections_with(curve.get(), surface.get(), 0, 10000, nullptr,
                                                          nullptr, kinds.data(), ranges.data(), nullptr,
                                                          &count, &complete, &call));
        kinds.resize(static_cast<size_t>(count));
        for (const double t : all.t) {
            bool covered = false;
            for (size_t j = 0; j < kinds.size(); ++j) {
                covered = covered || (ranges[2 * j] <= t && t <= ranges[2 * j + 1]);
            }
            ASSERT_TRUE(covered) << work << ' ' << t;
        }
        ASSERT_EQ(complete == 1, std::ranges::count(kinds, int32_t{NURBS_HIT_UNDECIDED}) == 0);
        ASSERT_LE(std::ranges::count(kinds, int32_t{NURBS_HIT_CROSSING}), all.count(NURBS_HIT_CROSSING));
    }
}

} // namespace curve_surface_traps_test
