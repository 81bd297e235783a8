// Faces whose loops touch, are slivers, run along seams, through poles or around axes, or have curves of no length, of the
// highest degree, or very many.
#include "property/faces.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace worst_faces_test {

using namespace support;
using namespace support::faces;

namespace {

Handle square(double a, double b, double c, double d) {
    return polygon({{a, b}, {c, b}, {c, d}, {a, d}});
}
double area_of_loops(const Ground &ground, const std::vector<const Handle *> &curves) {
    Curves loops;
    for (const Handle *curve : curves) {
        loops.push_back({curve->get()});
    }
    return area_of(face_of(ground.surface.get(), loops).get());
}
Handle axes_exchanged(const nurbs *g) {
    const int32_t order[] = {1, 0};
    return made([&](nurbs **out) { return nurbs_transpose(g, order, out); });
}

TEST(WorstFaces, loops_may_touch_at_places_and_along_sides) {
    const Ground ground = plane();
    const Handle outer = square(0, 0, 1, 1), left = square(0, 0.25, 0.25, 0.5);
    const Handle a = square(0.25, 0.25, 0.5, 0.5), b = square(0.5, 0.5, 0.75, 0.75),
                 c = square(0.5, 0.25, 0.75, 0.5), tip = polygon({{0, 0.5}, {0.5, 0.75}, {0.5, 0.25}});
    EXPECT_NEAR(area_of_loops(ground, {&outer, &tip}), 1 - 0.125, 1e-14);
    EXPECT_NEAR(area_of_loops(ground, {&outer, &a, &b}), 1 - 0.125, 1e-14);
    EXPECT_NEAR(area_of_loops(ground, {&outer, &a, &c}), 1 - 0.125, 1e-14);
    EXPECT_NEAR(area_of_loops(ground, {&left, &outer}), 1 - 0.0625, 1e-14);
    EXPECT_NEAR(area_of_loops(ground, {&a, &b}), 0.125, 1e-14);
    const Face face = face_of(ground.surface.get(), {{outer.get()}, {left.get()}});
    EXPECT_EQ(sides(face.get(), {0.125, 0.375, 0.375, 0.375, 0, 0.375, 0.25, 0.25}),
              (std::vector<int32_t>{-1, 1, 0, 0}));
}

TEST(WorstFaces, slivers_have_the_width_of_their_coordinates) {
    const Ground ground = plane();
    for (const double width : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const double top = 0.5 + width;
        const Handle loop = square(0.125, 0.5, 0.875, top);
        EXPECT_NEAR(area_of_loops(ground, {&loop}), 0.75 * (top - 0.5), 2 * 0x1p-52);
        const Face face = face_of(ground.surface.get(), {{loop.get()}});
        EXPECT_EQ(sides(face.get(), {0.5, 0.5 + width / 2, 0.5, 0.5 - width / 2, 0.5, top + width / 2}),
                  (std::vector<int32_t>{1, -1, -1}));
    }
}

TEST(WorstFaces, curves_of_no_length_change_nothing) {
    const Ground ground = plane();
    const Handle south = segment({0.25, 0.25}, {0.75, 0.25}), east = segment({0.75, 0.25}, {0.75, 0.75}),
                 back = segment({0.75, 0.75}, {0.25, 0.25}), still = segment({0.75, 0.25}, {0.75, 0.25});
    const Face face =
        face_of(ground.surface.get(), {{south.get(), still.get(), still.get(), east.get(), back.get()}});
    EXPECT_NEAR(area_of(face.get()), 0.125, 1e-14);
    EXPECT_EQ(sides(face.get(), {0.625, 0.5, 0.375, 0.5, 0.75, 0.25}), (std::vector<int32_t>{1, -1, 0}));
    nurbs *edge = nullptr;
    require_ok(nurbs_face_edge(face.get(), 0, 1, nullptr, &edge));
    const Handle owner(edge);
    EXPECT_NEAR(box_of(face.get(), 1e-9).upper[0], 0.75, 1e-9);
}

TEST(WorstFaces, the_highest_degree_and_many_segments) {
    Random random(1);
    const Ground ground = plane();
    Star kind;
    kind.degree = NURBS_MAX_DEGREE;
    const Handle high = create(star(random, ground, {0.5, 0.5}, kind));
    const Face face = face_of(ground.surface.get(), {{high.get()}});
    EXPECT_EQ(sides(face.get(), {0.5, 0.5, 0.96, 0.5}), (std::vector<int32_t>{1, -1}));
    double enclosed = 0;
    const nurbs *curves[] = {high.get()};
    require_ok(nurbs_enclosed_area(1, curves, 0, 1e-10, &enclosed, nullptr, nullptr, nullptr));
    EXPECT_NEAR(area_of(face.get(), 1e-10), enclosed, 1e-9);
    std::vector<Place> corners;
    double twice = 0;
    constexpr size_t n = 20000;
    for (size_t i = 0; i < n; ++i) {
        const double angle = 2 * pi * static_cast<double>(i) / n, r = 0.4 + 0.05 * std::sin(50 * angle);
        corners.push_back({0.5 + r * std::cos(angle), 0.5 + r * std::sin(angle)});
        if (i > 0) {
            twice += corners[i - 1][0] * corners[i][1] - corners[i][0] * corners[i - 1][1];
        }
    }
    twice += corners.back()[0] * corners[0][1] - corners[0][0] * corners.back()[1];
    const Handle many = polygon(corners);
    EXPECT_NEAR(area_of_loops(ground, {&many}), twice / 2, 1e-11);
}

// As files have them: the boundary of the domain, the seam up and down.
TEST(WorstFaces, seams_are_no_boundaries) {
    const Ground tube = cylinder(1, 2), globe = sphere(1);
    const Place a = tube.at(0, 0), b = tube.at(1, 0), c = tube.at(1, 1), d = tube.at(0, 1);
    const Handle bottom = segment(a, b), up = segment(b, c), top = segment(c, d), down = segment(d, a);
    const Face whole = face_of(tube.surface.get(), {{bottom.get(), up.get(), top.get(), down.get()}});
    EXPECT_NEAR(area_of(whole.get()), 4 * pi, 1e-8);
    const Place p = globe.at(0.5, 0), q = globe.at(0.5, 1), r = globe.at(0, 0), s = globe.at(0, 1);
    const Handle seam = segment(s, r), middle = segment(p, q), other = segment(q, p), same = segment(r, s);
    const Face east = face_of(globe.surface.get(), {{seam.get(), middle.get()}}),
               west = face_of(globe.surface.get(), {{other.get(), same.get()}});
    EXPECT_NEAR(area_of(east.get()), 2 * pi, 1e-8);
    EXPECT_NEAR(area_of(west.get()), 2 * pi, 1e-8);
    const Place in = globe.at(0.25, 0.4), out = globe.at(0.75, 0.4);
    EXPECT_EQ(sides(east.get(), {in[0], in[1], out[0], out[1]}), (std::vector<int32_t>{1, -1}));
    EXPECT_EQ(sides(west.get(), {in[0], in[1], out[0], out[1]}), (std::vector<int32_t>{-1, 1}));
}

// Around either axis of a torus, and both, wherever the loops begin; they may stay in one column.
TEST(WorstFaces, bands_of_a_torus_are_halves) {
    const Ground ring = torus(3, 1);
    const double whole = 12 * pi * pi;
    const auto band = [&](const Place &a, const Place &b, const Place &c, const Place &d) {
        const Handle first = segment(ring.at(a[0], a[1]), ring.at(b[0], b[1])),
                     second = segment(ring.at(c[0], c[1]), ring.at(d[0], d[1]));
        return area_of(face_of(ring.surface.get(), {{first.get()}, {second.get()}}).get()) / whole;
    };
    EXPECT_NEAR(band({0.25, 1}, {0.25, 0}, {0.75, 0}, {0.75, 1}), 0.5, 1e-9);
    EXPECT_NEAR(band({0, 1}, {0, 0}, {0.5, 0}, {0.5, 1}), 0.5, 1e-9);
    EXPECT_NEAR(band({1, 1}, {1, 0}, {0.25, 0}, {0.25, 1}), 0.25, 1e-9);
    EXPECT_NEAR(band({0.25, 1.25}, {0.25, 0.25}, {3, 0}, {3, 1}), 0.75, 1e-9);
    EXPECT_NEAR(band({0, 0}, {1, 1}, {1.5, 1}, {0.5, 0}), 0.5, 1e-9);
}

Face face_of_edges(const Ground &ground, const std::vector<const nurbs *> &edges, double tolerance) {
    const auto size = std::ssize(edges);
    nurbs_face *face = nullptr;
    require_ok(nurbs_face_create(ground.surface.get(), 1, &size, nullptr, edges.data(), nullptr, tolerance, 0,
                                 nullptr, &face));
    return Face(face);
}

// The face of the edges alone has the area of the face that they are of.
void expect_again(const Ground &ground, const std::vector<Handle> &loop) {
    std::vector<const nurbs *> curves;
    for (const Handle &curve : loop) {
        curves.push_back(curve.get());
    }
    const Face face = face_of(ground.surface.get(), {curves}, 1e-5);
    std::vector<Handle> held;
    std::vector<const nurbs *> edges;
    for (int64_t i = 0; i < std::ssize(loop); ++i) {
        held.push_back(made([&](nurbs **out) { return nurbs_face_edge(face.get(), 0, i, nullptr, out); }));
        edges.push_back(held.back().get());
    }
    const Face again = face_of_edges(ground, edges, 1e-4);
    EXPECT_NEAR(area_of(again.get(), 1e-6) / area_of(face.get(), 1e-6), 1, 1e-3);
}

// In one curve by more than half of it, or several times.
TEST(WorstFaces, edges_are_followed_around_closed_surfaces) {
    for (const Ground &ground : {cylinder(1, 2), torus(3, 1)}) {
        for (const double radius : {0.1, 0.24, 0.26, 0.35, 0.45}) {
            for (const double middle : {0.02, 0.5, 1.0}) {
                SplineData oval{{3}, {13}, {{0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 10, 10, 10}}, 2, {},
                                {},  0};
                for (int i = 0; i < 13; ++i) {
                    const double angle = i % 12 * pi / 6;
                    const Place x = ground.at(middle + radius * std::cos(angle), 0.5 + 0.3 * std::sin(angle));
                    oval.points.insert(oval.points.end(), x.begin(), x.end());
                }
                std::vector<Handle> loop;
                loop.push_back(create(oval));
                SCOPED_TRACE(radius);
                expect_again(ground, loop);
            }
        }
        for (const double turns : {0.9, 1.4, 2.0, 5.0}) {
            const Place a = ground.at(0.2, 0.1), b = ground.at(0.2 + turns, 0.7),
                        c = ground.at(0.2 + turns, 0.7 + 0.2 / turns), d = ground.at(0.2, 0.1 + 0.2 / turns);
            std::vector<Handle> loop;
            loop.push_back(segment(a, b));
            loop.push_back(segment(b, c));
            loop.push_back(segment(c, d));
            loop.push_back(segment(d, a));
            SCOPED_TRACE(turns);
            expect_again(ground, loop);
        }
    }
}

// A great circle, wherever it begins and however its pieces lie, bounds a half.
TEST(WorstFaces, edges_may_pass_poles) {
    const Ground globe = sphere(2);
    const double centre[] = {0, 0, 0};
    for (const int32_t form : {NURBS_ARC_QUARTERS, NURBS_ARC_SMOOTH}) {
        for (const double begin : {0.0, 0.3, pi / 4}) {
            for (const double meridian : {0.0, 0.7}) {
                const double c = std::cos(meridian), s = std::sin(meridian), axis[] = {s, -c, 0},
                             x[] = {std::cos(begin) * c, std::cos(begin) * s, std::sin(begin)};
                const Handle circle =
                    made([&](nurbs **out) { return nurbs_curve_circle(3, centre, axis, x, 2, form, out); });
                const nurbs *edge = circle.get();
                EXPECT_NEAR(area_of(face_of_edges(globe, {edge}, 1e-6).get()), 8 * pi, 1e-6)
                    << begin << ' ' << meridian;
            }
        }
    }
}

// Also where axis 1 is the one that closes.
TEST(WorstFaces, whole_surfaces_of_either_axis) {
    for (const bool exchanged : {false, true}) {
        std::vector<std::pair<Ground, double>> all;
        all.emplace_back(cylinder(1, 2), 4 * pi);
        all.emplace_back(sphere(1), 4 * pi);
        all.emplace_back(torus(3, 1), 12 * pi * pi);
        for (auto &[ground, area] : all) {
            if (exchanged) {
                ground = ground_of(axes_exchanged(ground.surface.get()), ground.closed[1], ground.closed[0]);
            }
            nurbs_face *handle = nullptr;
            require_ok(nurbs_face_create(ground.surface.get(), 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0,
                                         nullptr, &handle));
            const Face face(handle);
            EXPECT_NEAR(area_of(face.get()) / area, 1, 1e-9);
            const Place x = ground.at(0.1, 0.7), y = ground.at(0.9, 0.2);
            EXPECT_EQ(sides(face.get(), {x[0], x[1], y[0], y[1]}), (std::vector<int32_t>{1, 1}));
        }
    }
}

// What lies outside of a hole without an outer loop ends where the surface does; the apex of a cone is inside its cap.
TEST(WorstFaces, boxes_reach_ends_of_surfaces_and_poles) {
    const Ground ground = plane(2);
    const Handle hole = polygon({{0.25, 0.25}, {0.25, 0.5}, {0.5, 0.5}, {0.5, 0.25}});
    const Box box =
        box_of(face_of(ground.surface.get(), {{hole.get()}}, 1e-9, NURBS_AS_ORIENTED).get(), 1e-6);
    for (size_t c = 0; c < 2; ++c) {
        EXPECT_NEAR(box.lower[c], 0, 1e-6);
        EXPECT_NEAR(box.upper[c], 2, 1e-6);
    }
    const Ground cone = ground_of(made([](nurbs **out) {
                                      return nurbs_surface_cone(nullptr, nullptr, nullptr, 1, 0, 2, 0, 2 * pi,
                                                                NURBS_ARC_THIRDS, out);
                                  }),
                                  true, false);
    const Handle circle = segment(cone.at(0, 0.5), cone.at(1, 0.5));
    const Face cap = face_of(cone.surface.get(), {{circle.get()}});
    const Box around = box_of(cap.get(), 1e-6);
    EXPECT_NEAR(around.lower[2], 1, 1e-6);
    EXPECT_NEAR(around.upper[2], 2, 1e-6);
    EXPECT_NEAR(area_of(cap.get()), pi * 0.5 * std::hypot(0.5, 1), 1e-9);
}

// Long pieces that pass a corner of a cell, knots on which nothing jumps, and an apex where all tangents do.
TEST(WorstFaces, boxes_are_tight_along_slanted_loops_and_creases) {
    const Ground ring = torus(3, 1);
    const Handle a = segment(ring.at(0, 0), ring.at(1, 1)), b = segment(ring.at(1.5, 1), ring.at(0.5, 0)),
                 c = segment(ring.at(0.25, 1), ring.at(0.25, 0)),
                 d = segment(ring.at(0.75, 0), ring.at(0.75, 1));
    const Box slanted = box_of(face_of(ring.surface.get(), {{a.get()}, {b.get()}}).get(), 1e-3);
    EXPECT_LE(slanted.gap, 1.001e-3);
    EXPECT_LT(slanted.upper[1], 3.15); // (3 + cos v) sin u with v = u - pi has its largest value there
    const Box half = box_of(face_of(ring.surface.get(), {{c.get()}, {d.get()}}).get(), 1e-3);
    EXPECT_LE(half.gap, 1.001e-3);
    EXPECT_NEAR(half.upper[0], 0, 1e-3);
    EXPECT_NEAR(half.lower[0], -4, 1e-3);
    const Vec knots{0, 0, 0.125, 0.75, 1, 1};
    SplineData hat{{1, 1}, {4, 4}, {knots, knots}, 3, {}, {}, 0};
    for (int i = 0; i < 16; ++i) {
        hat.points.insert(hat.points.end(), {i / 4 + 0.0, i % 4 + 0.0, i == 5 ? 1.0 : i == 10 ? -2.0 : 0.0});
    }
    const Ground tent = ground_of(create(hat), false, false);
    const Handle outline = square(0.01, 0.01, 0.99, 0.99);
    const Box box = box_of(face_of(tent.surface.get(), {{outline.get()}}).get(), 1e-6);
    EXPECT_NEAR(box.upper[2], 1, 1e-6);
    EXPECT_NEAR(box.lower[2], -2, 1e-6);
}

// There and back encloses nothing, nor does a place; the message names the loop.
TEST(WorstFaces, what_encloses_nothing_is_refused) {
    const Ground ground = plane();
    const Handle outer = square(0, 0, 1, 1), point = segment({0.5, 0.5}, {0.5, 0.5});
    const Handle there = polygon({{0.25, 0.3}, {0.75, 0.6}}), upright = polygon({{0.25, 0.3}, {0.25, 0.6}});
    for (const Handle *loop : {&point, &there, &upright}) {
        const nurbs *curves[] = {outer.get(), loop->get()};
        const int64_t sizes[] = {1, 1};
        nurbs_face *face = nullptr;
        EXPECT_EQ(
            nurbs_face_create(ground.surface.get(), 2, sizes, curves, nullptr, nullptr, 0, 0, nullptr, &face),
            NURBS_ERROR_ORIENTATION);
        EXPECT_NE(last_error().find("loop 1"), std::string::npos) << last_error();
    }
}

} // namespace

} // namespace worst_faces_test
