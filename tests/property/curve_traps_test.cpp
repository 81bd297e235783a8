// Where other libraries lose meets of curves, or do not end. Numbers are those of their issues; all shapes are our own.
#include "curve_meets.h"
#include "support/cases.h"

#include <numbers>

namespace curve_traps_test {

using namespace support;
using namespace curve_meets;

// axom#71: meets at ends, and many control points near an end.
TEST(CurveTraps, ends_are_met) {
    const Handle line = create(bezier(2, {0, 0, 1, 1})), from_end = create(bezier(2, {1, 1, 2, 0}));
    const Hits end = meets(line, from_end, 0);
    ASSERT_EQ(end.size(), 1U);
    EXPECT_EQ(end.kinds[0], NURBS_HIT_CROSSING);
    EXPECT_EQ(end.a[0], 1);
    EXPECT_EQ(end.b[0], 0);
    Vec crowded{0, 0};
    for (int i = 1; i <= 8; ++i) {
        crowded.insert(crowded.end(), {std::ldexp(1, -40 - i), std::ldexp(1, -41 - i)});
    }
    crowded.insert(crowded.end(), {1, -1});
    const Handle curve = create(bezier(2, crowded)), across = create(bezier(2, {-1, -0.25, 1, -0.25}));
    EXPECT_EQ(meets(curve, across, 0).count(NURBS_HIT_CROSSING), 1);
    EXPECT_EQ(meets(curve, create(bezier(2, {-1, 1, 1, -1})), 1e-9).complete, 1);
}

// axom!1869: circles that touch at a knot of both.
TEST(CurveTraps, circles_touch_at_a_knot) {
    const Handle a = circle(0, 0, 1), b = circle(0, 2, 1);
    const Hits hits = meets(a, b, 1e-9);
    ASSERT_EQ(hits.size(), 1U);
    EXPECT_EQ(hits.complete, 1);
    EXPECT_EQ(hits.kinds[0], NURBS_HIT_TANGENT);
    EXPECT_NEAR(hits.a[0], 0.25, 1e-6);
    EXPECT_NEAR(hits.b[0], 0.75, 1e-6);
}

// bezier#10: a touch that a linear step takes to be outside.
TEST(CurveTraps, touches_are_found_at_any_size) {
    for (const double size : {1e-150, 1e-3, 1.0, 1e3, 1e150}) {
        const Handle parabola = create(bezier(2, {-size, size, 0, -size, size, size})),
                     line = create(bezier(2, {-size, 0, size, 0}));
        const Hits hits = meets(parabola, line, 1e-9 * size);
        ASSERT_EQ(hits.size(), 1U) << size;
        EXPECT_EQ(hits.kinds[0], NURBS_HIT_TANGENT) << size;
        EXPECT_EQ(hits.complete, 1) << size;
    }
}

// bezierjs#204, paper.js#648: hundreds of hits for curves that are one. paper.js#784: ranges of overlaps.
TEST(CurveTraps, one_curve_twice_is_one_overlap) {
    const SplineData data = bezier(2, {0, 0, 1, 2, 3, -1, 4, 1});
    const Handle a = create(data), b = create(data);
    nurbs *out = nullptr;
    require_ok(nurbs_elevate(b.get(), 0, 2, &out));
    const Handle high(out);
    const double from = 0.25, to = 0.75;
    require_ok(nurbs_extract(a.get(), &from, &to, &out));
    const Handle part(out);
    for (const nurbs *other : {b.get(), high.get(), part.get()}) {
        const Hits hits = meets(a.get(), other, 1e-9);
        ASSERT_EQ(hits.size(), 1U);
        EXPECT_EQ(hits.kinds[0], NURBS_HIT_OVERLAP);
        EXPECT_EQ(hits.complete, 1);
        EXPECT_NEAR(hits.ranges_a[0], other == part.get() ? 0.25 : 0, 1e-9);
        EXPECT_NEAR(hits.ranges_a[1], other == part.get() ? 0.75 : 1, 1e-9);
    }
}

// Rational arcs of one circle with different parametrizations.
TEST(CurveTraps, an_overlap_does_not_depend_on_parametrizations) {
    nurbs *out = nullptr;
    const double at[] = {0, 0};
    require_ok(nurbs_curve_circle(2, at, nullptr, nullptr, 1, NURBS_ARC_THIRDS, &out));
    const Handle quarters = circle(0, 0, 1), thirds(out);
    const Hits hits = meets(quarters, thirds, 1e-9);
    EXPECT_EQ(hits.complete, 1);
    EXPECT_EQ(hits.count(NURBS_HIT_OVERLAP), 1);
}

// FloBezier#19: curves that osculate; lyon!422: clips to one point. A curve and its circle of curvature.
TEST(CurveTraps, osculating_curves_end) {
    const Handle parabola = create(bezier(2, {-1, 1, 0, -1, 1, 1})), inner = circle(0, 0.5, 0.5);
    const Hits touch = meets(parabola, inner, 1e-9);
    EXPECT_EQ(touch.complete, 1);
    EXPECT_GE(touch.size(), 1U);
    const Hits open = meets(parabola, inner, 0);
    EXPECT_EQ(open.complete, 0);
    for (const int32_t kind : open.kinds) {
        EXPECT_EQ(kind, NURBS_HIT_UNDECIDED);
    }
}

// pythonocc#308: answers that depend on how long a line is.
TEST(CurveTraps, the_length_of_a_line_does_not_matter) {
    const Handle ring = circle(0, 0, 1);
    for (const double length : {1.5, 10.0, 1e4, 1e8}) {
        const Handle line = create(bezier(2, {-length, 0.25, length, 0.25}));
        const Hits hits = meets(ring, line, 0);
        ASSERT_EQ(hits.count(NURBS_HIT_CROSSING), 2) << length;
        EXPECT_EQ(hits.complete, 1) << length;
        EXPECT_NEAR(hits.b[0], 0.5 + std::sqrt(0.9375) / 2 / length, 1e-12) << length;
    }
}

// fonttools!4180: halving at extreme coordinates until no stack is left. Crossings far from the origin, where rounding hides
// the angle, and of curves a million million times as long as they are near each other.
TEST(CurveTraps, extreme_coordinates_end) {
    for (const double far : {1e9, 1e15, 1e150, 1e300}) {
        const Handle a = create(bezier(2, {-far, -far, 0, far, far, -far / 2})),
                     line = create(bezier(2, {-far, -1, far, 1}));
        const Hits hits = meets(a, line, 0);
        EXPECT_EQ(hits.complete, 1) << far;
        EXPECT_EQ(hits.count(NURBS_HIT_CROSSING), 2) << far;
        const Handle offset = create(bezier(2, {far, far, far, far + 1, far + 1, far + 1})),
                     beside = create(bezier(2, {far + 1, far, far, far, far, far + 1}));
        (void)meets(offset, beside, 0);
        (void)own_meets(offset.get(), 0);
    }
}

// tigl#783: extrema of the distance taken for meets.
TEST(CurveTraps, many_meets_and_both_ends) {
    Vec zigzag;
    for (int i = 0; i <= 2000; ++i) {
        zigzag.insert(zigzag.end(), {static_cast<double>(i), i % 2 == 0 ? 0.0 : i % 4 == 1 ? 1.0 : -1.0});
    }
    const Handle a = create(polygon(zigzag)), axis = create(polygon({0, 0, 2000, 0}));
    const Hits hits = meets(a, axis, 1e-9);
    EXPECT_EQ(hits.complete, 1);
    EXPECT_EQ(hits.count(NURBS_HIT_CROSSING), 1001);
}

// Limits of work: an answer that claims nothing false.
TEST(CurveTraps, limits_of_work_leave_places_undecided) {
    Random random(2750000);
    Vec first, second;
    for (int i = 0; i < 40; ++i) {
        first.insert(first.end(), {random.between(-1, 1), random.between(-1, 1)});
        second.insert(second.end(), {random.between(-1, 1), random.between(-1, 1)});
    }
    const Handle a = create(polygon(first)), b = create(polygon(second));
    const Hits all = meets(a, b, 0);
    ASSERT_EQ(all.complete, 1);
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    for (const int64_t work : {1, 10, 100, 10000, 1000000}) {
        call.work = work;
        const Hits some = hits_of([&](auto... rest) {
            return nurbs_curve_intersections_with(a.get(), b.get(), 0, rest..., &call);
        });
        for (size_t i = 0; i < all.size(); ++i) {
            bool covered = false;
            for (size_t j = 0; j < some.size(); ++j) {
                covered =
                    covered || (some.ranges_a[2 * j] <= all.a[i] && all.a[i] <= some.ranges_a[2 * j + 1] &&
                                some.ranges_b[2 * j] <= all.b[i] && all.b[i] <= some.ranges_b[2 * j + 1]);
            }
            ASSERT_TRUE(covered) << work << ' ' << i;
        }
        ASSERT_EQ(some.complete == 1, some.count(NURBS_HIT_UNDECIDED) == 0);
        ASSERT_LE(some.count(NURBS_HIT_CROSSING), all.count(NURBS_HIT_CROSSING));
    }
}

// A copy moved by half of the tolerance is an overlap; one moved by three times meets where it crosses.
TEST(CurveTraps, copies_beside_each_other) {
    const SplineData data = bezier(2, {0, 0, 1, 2, 3, -1, 4, 1});
    SplineData near = data, far = data;
    for (size_t i = 1; i < data.points.size(); i += 2) {
        near.points[i] += 0.5e-6;
        far.points[i] += 3e-6;
    }
    const Handle a = create(data);
    const Hits beside = meets(a, create(near), 1e-6), apart = meets(a, create(far), 1e-6);
    EXPECT_EQ(beside.complete, 1);
    ASSERT_EQ(beside.size(), 1U);
    EXPECT_EQ(beside.kinds[0], NURBS_HIT_OVERLAP);
    EXPECT_EQ(apart.complete, 1);
    EXPECT_EQ(apart.count(NURBS_HIT_CROSSING), 0); // translates of a graph along y
    EXPECT_EQ(apart.count(NURBS_HIT_OVERLAP), 0);
}

// Steps, jumps, points of weight 0, periodic curves at their seams.
TEST(CurveTraps, awkward_forms) {
    SplineData steps{{0}, {3}, {{0, 1, 2, 3}}, 2, {0, 0, 0.5, 0, 5, 5}, {}, 0};
    const Handle line = create(bezier(2, {0, 0, 1, 0}));
    const Hits on_steps = meets(create(steps), line, 1e-9);
    EXPECT_EQ(on_steps.complete, 1);
    EXPECT_EQ(on_steps.count(NURBS_HIT_OVERLAP), 2);
    SplineData jump{{1}, {4}, {{0, 0, 1, 1, 2, 2}}, 2, {0, 0, 1, 1, 2, 0, 3, 1}, {}, 0};
    const Handle broken = create(jump);
    EXPECT_EQ(meets(broken, create(bezier(2, {1.5, -1, 1.5, 2})), 0).size(), 0U); // in the gap
    EXPECT_EQ(meets(broken, create(bezier(2, {2.5, -1, 2.5, 2})), 0).count(NURBS_HIT_CROSSING), 1);
    const Handle arch = create(bezier(2, {0, 0, 1, 1, 2, 0}, {1, 0, 1}));
    const Hits through = meets(arch, create(bezier(2, {0.5, -1, 0.5, 2})), 0);
    EXPECT_EQ(through.count(NURBS_HIT_CROSSING), 1);
    EXPECT_EQ(through.complete, 1);
    SplineData ring{
        {2}, {6},           {{-2, -1, 0, 1, 2, 3, 4, 5, 6}}, 2, {1, 1, -1, 1, -1, -1, 1, -1, 1, 1, -1, 1},
        {},  NURBS_PERIODIC};
    const Handle periodic = create(ring);
    const Vec seam = point_of(periodic.get(), 0);
    const Hits at_seam =
        meets(periodic, create(bezier(2, {seam[0] / 2, seam[1] / 2 - 0.0, 2 * seam[0], 2 * seam[1]})), 1e-12);
    EXPECT_EQ(at_seam.count(NURBS_HIT_CROSSING), 1);
    EXPECT_EQ(at_seam.size(), 1U);
}

namespace {

// One overlap, of so much of both; complete.
void expect_overlap(const Hits &hits, const Vec &on_a, const Vec &on_b, double by) {
    ASSERT_EQ(hits.complete, 1);
    ASSERT_EQ(hits.size(), 1U);
    EXPECT_EQ(hits.kinds[0], NURBS_HIT_OVERLAP);
    for (size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(hits.ranges_a[i], on_a[i], by);
        EXPECT_NEAR(hits.ranges_b[i], on_b[i], by);
    }
}

} // namespace

// Curves that run over themselves: there and back, exactly and within the tolerance, and around twice.
TEST(CurveTraps, curves_that_run_over_themselves) {
    const auto own = [](const SplineData &data, double tolerance) {
        return own_meets(create(data).get(), tolerance);
    };
    expect_overlap(own(bezier(2, {0, 0, 1, 0, 0, 0}), 1e-9), {0, 0.5}, {1, 0.5}, 1e-3);
    expect_overlap(own(polygon({0, 0, 1, 0, 0, 9e-4}), 1e-3), {0, 1}, {2, 1}, 1e-3);
    expect_overlap(own(polygon({0, 0, 1, 0, 1, 5e-4, 0, 5e-4}), 1e-3), {0, 1}, {3, 2}, 1e-3);
    expect_overlap(own(polygon({0, 0, 1, 0, 0, 9e-4, 0, 5, -5, 5}), 1e-3), {0, 1}, {2, 1}, 1e-3);
    expect_overlap(own(bezier(2, {0, 0, 1, 0, 1, 1e-7, 0, 1e-7}), 1e-6), {0, 0.5}, {1, 0.5}, 1e-2);
    for (const int degree : {1, 2, 3}) {
        SplineData twice{{degree}, {8 + degree}, {{}}, 2, {}, {}, NURBS_PERIODIC};
        for (int i = 0; i < 8 + 2 * degree + 1; ++i) {
            twice.knots[0].push_back(i - degree);
        }
        const double square[] = {0, 0, 1, 0, 1, 1, 0, 1};
        for (int i = 0; i < 8 + degree; ++i) {
            twice.points.insert(twice.points.end(), {square[2 * (i % 4)], square[2 * (i % 4) + 1]});
        }
        expect_overlap(own(twice, 1e-9), {0, 4}, {4, 8}, 1e-12);
    }
    // Three times over itself: what cannot be decided is told.
    const Hits thrice = own(bezier(2, {0, 0, 3, 0, -2, 0, 1, 0}), 1e-6);
    EXPECT_GE(thrice.size(), 1U);
    EXPECT_EQ(thrice.complete == 1, thrice.count(NURBS_HIT_UNDECIDED) == 0);
    // A loop smaller than the tolerance, and a circle whose pieces are.
    EXPECT_EQ(own(bezier(2, {0, 0, 1 + 1e-8, 1, -1e-8, 1, 1, 0}), 1e-6).count(NURBS_HIT_CROSSING), 0);
    nurbs *out = nullptr;
    Vec knots;
    for (int i = 1; i < 2000; ++i) {
        knots.push_back(i / 2000.0);
    }
    require_ok(nurbs_refine(circle(0, 0, 1).get(), 0, std::ssize(knots), knots.data(), &out));
    const Hits fine = own_meets(Handle(out).get(), 1e-2);
    EXPECT_EQ(fine.size(), 0U);
    EXPECT_EQ(fine.complete, 1);
}

// A derivative of 0 at an end or inside does not hide an overlap.
TEST(CurveTraps, overlaps_with_points_at_rest) {
    const Handle line = create(bezier(2, {0, 0, 1, 0}));
    expect_overlap(meets(line, create(bezier(2, {0, 0, 0, 0, 1, 0})), 1e-9), {0, 1}, {0, 1}, 1e-3);
    expect_overlap(meets(line, create(bezier(2, {0, 0, 1, 0, 1, 0})), 1e-6), {0, 1}, {0, 1}, 1e-3);
    const Hits twice = meets(line, create(bezier(2, {0, 0, 1, 0, 0, 0})), 1e-9);
    EXPECT_EQ(twice.count(NURBS_HIT_OVERLAP), 2);
    EXPECT_EQ(twice.complete, 1);
    const Hits square = meets(create(bezier(2, {0, 0, 1, 2, 2, 0})),
                              create(bezier(2, {0, 0, 0, 0, 1 / 3.0, 2 / 3.0, 1, 2, 2, 0})), 1e-9);
    EXPECT_TRUE(square.count(NURBS_HIT_OVERLAP) == 1 || square.complete == 0);
    EXPECT_EQ(square.count(NURBS_HIT_TANGENT), 0);
}

// The same across the seam of a periodic curve, both ways.
TEST(CurveTraps, overlaps_with_points_at_rest_across_a_seam) {
    SplineData ring{
        {1}, {6},           {{-1, 0, 1, 2, 3, 4, 5, 6}}, 2, {0.5, 0, 2, 0, 2, 3, -1, 3, -1, 0, 0.5, 0},
        {},  NURBS_PERIODIC};
    const Handle periodic = create(ring);
    const double from = 4 + 2 / 3.0, to = 5 + 1 / 3.0;
    const Handle rests = create(bezier(2, {0, 0, 0, 0, 1, 0})), back = create(bezier(2, {1, 0, 0, 0, 0, 0}));
    expect_overlap(meets(periodic, rests, 1e-9), {from, to}, {0, 1}, 1e-3);
    expect_overlap(meets(rests, periodic, 1e-9), {0, 1}, {from, to}, 1e-3);
    expect_overlap(meets(back, periodic, 1e-9), {0, 1}, {to, from}, 1e-3);
}

// Strokes through places near one, joined far from it: each crosses each other one, also where eight places evenly between
// them on the curve are near, too.
TEST(CurveTraps, loops_are_told_by_more_than_samples) {
    Vec corners;
    for (int i = 0; i < 9; ++i) {
        const double angle = 0.3 * i, x = std::cos(angle), y = std::sin(angle), off = 1e-8 * (i * i % 7);
        corners.insert(corners.end(), {-x - off * y, -y + off * x, x - off * y, y + off * x});
    }
    const Handle star = create(polygon(corners));
    const Hits exact = own_meets(star.get(), 0), near = own_meets(star.get(), 1e-6);
    EXPECT_EQ(exact.complete, 1);
    EXPECT_EQ(near.complete, 1);
    EXPECT_GE(exact.count(NURBS_HIT_CROSSING), 36);
    EXPECT_EQ(near.count(NURBS_HIT_CROSSING), exact.count(NURBS_HIT_CROSSING));
}

// All of a periodic circle beside one that is not periodic and begins elsewhere, in either order, and both ways around.
TEST(CurveTraps, a_periodic_circle_beside_a_clamped_one) {
    const auto ring_from = [](int first, bool back) {
        SplineData data{{2}, {6}, {{}}, 2, {}, {}, NURBS_PERIODIC};
        for (int i = -2; i <= 6; ++i) {
            data.knots[0].push_back(i);
        }
        const double square[] = {1, 1, -1, 1, -1, -1, 1, -1};
        for (int i = 0; i < 6; ++i) {
            const int corner = (back ? 8 - i + first : i + first) % 4;
            data.points.insert(data.points.end(), {square[2 * corner], square[2 * corner + 1]});
        }
        return create(data);
    };
    const Handle ring = ring_from(0, false);
    for (const bool back : {false, true}) {
        const Handle plain = made([&](nurbs **out) {
            return nurbs_clamp_ends(ring_from(2, back).get(), 0,
                                    NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END, out);
        });
        const Hits hits = meets(ring, plain, 1e-9), swapped = meets(plain, ring, 1e-9);
        for (const Hits *found : {&hits, &swapped}) {
            const bool first = found == &hits;
            const Vec &on_ring = first ? found->ranges_a : found->ranges_b,
                      &on_plain = first ? found->ranges_b : found->ranges_a;
            EXPECT_EQ(found->complete, 1);
            ASSERT_EQ(found->size(), 1U);
            EXPECT_EQ(found->kinds[0], NURBS_HIT_OVERLAP);
            EXPECT_NEAR(std::abs(on_ring[1] - on_ring[0]), 4, 1e-6);
            EXPECT_NEAR(std::abs(on_plain[1] - on_plain[0]), 4, 1e-6);
        }
    }
}

// Tolerances beyond the size of spans, and curves shorter than the tolerance.
TEST(CurveTraps, large_tolerances) {
    EXPECT_EQ(meets(circle(0, 0, 1), circle(0, 0, 1.5), 0.6).count(NURBS_HIT_OVERLAP), 1);
    EXPECT_EQ(meets(circle(0, 0, 1), circle(0, 0, 1.01), 0.5).count(NURBS_HIT_OVERLAP), 1);
    const Handle line = create(bezier(2, {0, 0, 1, 0})), dot = create(bezier(2, {0.5, 0, 0.5 + 4e-9, 0}));
    EXPECT_EQ(meets(line, dot, 1e-9).count(NURBS_HIT_OVERLAP), 1);
    EXPECT_EQ(meets(circle(0, 0, 1), circle(0, 0, 1.5), 0.4).size(), 0U);
}

// A periodic figure of eight whose seam is where it crosses itself, at the origin and away from it.
TEST(CurveTraps, a_seam_at_a_crossing) {
    for (const double offset : {0.0, 5.0, 1e6}) {
        const double corners[] = {1, -1, 0, 0, -1, 1, -2, 0, -1, -1, 0, 0, 1, 1, 2, 0};
        SplineData eight{{3}, {11}, {{}}, 2, {}, {}, NURBS_PERIODIC};
        for (int i = 0; i < 15; ++i) {
            eight.knots[0].push_back(i - 3);
        }
        for (int i = 0; i < 11; ++i) {
            eight.points.insert(eight.points.end(),
                                {corners[2 * (i % 8)] + offset, corners[2 * (i % 8) + 1] + offset});
        }
        const Handle g = create(eight);
        const Hits own = own_meets(g.get(), 1e-9);
        ASSERT_EQ(own.size(), 1U) << offset;
        EXPECT_EQ(own.kinds[0], NURBS_HIT_CROSSING) << offset;
        EXPECT_EQ(own.complete, 1) << offset;
        const Hits across =
            meets(g, create(bezier(2, {offset - 0.5, offset + 0.1, offset + 0.5, offset - 0.1})), 1e-9);
        EXPECT_EQ(across.count(NURBS_HIT_CROSSING), 2) << offset;
        EXPECT_EQ(across.size(), 2U) << offset;
    }
}

// A crossing beside the seam, whose near places go on across it, has parameters of the domain.
TEST(CurveTraps, a_crossing_beside_a_seam) {
    const SplineData data{
        {2}, {6},           {{-2, -1, 0, 1, 2, 3, 4, 5, 6}}, 2, {1, 1, -1, 1, -1, -1, 1, -1, 1, 1, -1, 1},
        {},  NURBS_PERIODIC};
    const Handle g = create(data);
    for (const double at : {1e-7, 4 - 1e-7}) {
        const Vec x = point_of(g.get(), at);
        const Handle across = create(bezier(2, {x[0] / 2, x[1] / 2, 1.5 * x[0], 1.5 * x[1]}));
        const Hits hits = meets(g, across, 1e-4), other = meets(across, g, 1e-4);
        ASSERT_EQ(hits.size(), 1U);
        ASSERT_EQ(other.size(), 1U);
        EXPECT_EQ(hits.kinds[0], NURBS_HIT_CROSSING);
        EXPECT_NEAR(hits.a[0], at, 1e-12);
        EXPECT_NEAR(other.b[0], at, 1e-12);
        EXPECT_LE(hits.ranges_a[0], hits.a[0]);
        EXPECT_GE(hits.ranges_a[1], hits.a[0]);
    }
}

// Segments on one line but for rounding, which ends of both leave on either side: they may cross there more than once.
TEST(CurveTraps, long_parts_beside_each_other_are_not_one_crossing) {
    const Handle a = create(polygon({0.6, 0.4, 0.6, 0.6, 0.8, 0.8, 0.6, 0.4})),
                 b = create(polygon({0.4, 0.6, 0.2, 0.2, 0.4, 0.4, 0.6, 0.6, 0.8, 0.8, 0.4, 0.6}));
    for (const bool swapped : {false, true}) {
        const Hits exact = swapped ? meets(b, a, 0) : meets(a, b, 0);
        EXPECT_EQ(exact.count(NURBS_HIT_CROSSING), 0);
        EXPECT_EQ(exact.complete, 0);
        const Hits near = swapped ? meets(b, a, 1e-9) : meets(a, b, 1e-9);
        EXPECT_EQ(near.count(NURBS_HIT_OVERLAP), 1);
        EXPECT_EQ(near.complete, 1);
    }
}

} // namespace curve_traps_test
