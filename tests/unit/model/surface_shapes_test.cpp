// Surfaces as files state them: their splines at mapped parameters, and parts around points.
#include "base/error.h"
#include "model/shapes/curve_spline.h"
#include "model/shapes/surface_spline.h"
#include "recognize/recognize.h"
#include "support/step_reading.h"

#include <cmath>
#include <functional>
#include <random>

namespace surface_shapes_test {

namespace {

using namespace nrb;
using namespace nrb::model;
using step_test::expect_near;
using step_test::point_of;

const build::Placement &frame() {
    static const build::Placement place = [] {
        const double origin[3] = {1, 2, 3}, z[3] = {1, -2, 0.5}, x[3] = {0.25, 1, 1};
        return build::make_placement(3, origin, z, x, "origin");
    }();
    return place;
}

Vector3 in_frame(double x, double y, double z) {
    double out[3];
    frame().point(x, y, z, out);
    return {out[0], out[1], out[2]};
}

SurfaceShape shape(SurfaceKind kind, double a = 0, double b = 0) {
    SurfaceShape surface{kind, frame(), {a, b}, {}, nullptr, {}, nullptr, 0, true, true, nullptr};
    surface.range.v = {0, turn};
    return surface;
}

struct Case {
    const char *name;
    SurfaceShape surface;
    std::function<Vector3(double, double)> point;
    Rectangle most; // parameters for the test
};

CurveShapePtr circle_beside_the_axis() {
    CurveShape circle{CurveKind::circle, frame(), {0.5, 0}, nullptr, {}};
    // in the plane of X and Z, 3 from the axis
    const Vector3 at = in_frame(3, 0, 0), normal = -1.0 * frame().y;
    const double o[3] = {at.x, at.y, at.z}, n[3] = {normal.x, normal.y, normal.z},
                 x[3] = {frame().x.x, frame().x.y, frame().x.z};
    circle.place = build::make_placement(3, o, n, x, "origin");
    return std::make_shared<const CurveShape>(std::move(circle));
}

std::vector<Case> cases() {
    std::vector<Case> all;
    all.push_back({"plane",
                   shape(SurfaceKind::plane),
                   [](double u, double v) { return in_frame(u, v, 0); },
                   {{-2, 2}, {-2, 2}}});
    all.push_back({"cylinder",
                   shape(SurfaceKind::cylinder, 2),
                   [](double u, double v) { return in_frame(2 * std::cos(u), 2 * std::sin(u), v); },
                   {{-3, 3}, {-2, 2}}});
    all.push_back({"cone",
                   shape(SurfaceKind::cone, 2, 0.5),
                   [](double u, double v) {
                       const double r = 2 + v * std::tan(0.5);
                       return in_frame(r * std::cos(u), r * std::sin(u), v);
                   },
                   {{-3, 3}, {-3, 2}}});
    all.push_back({"sphere",
                   shape(SurfaceKind::sphere, 2),
                   [](double u, double v) {
                       return in_frame(2 * std::cos(v) * std::cos(u), 2 * std::cos(v) * std::sin(u),
                                       2 * std::sin(v));
                   },
                   {{-3, 3}, {-1.5, 1.5}}});
    all.push_back({"torus",
                   shape(SurfaceKind::torus, 3, 0.5),
                   [](double u, double v) {
                       const double r = 3 + 0.5 * std::cos(v);
                       return in_frame(r * std::cos(u), r * std::sin(u), 0.5 * std::sin(v));
                   },
                   {{-3, 3}, {-3, 3}}});
    SurfaceShape turned = shape(SurfaceKind::revolution);
    turned.curve = circle_beside_the_axis();
    all.push_back({"revolution", turned, all.back().point, {{-3, 3}, {-3, 3}}});
    SurfaceShape moved = shape(SurfaceKind::extrusion);
    moved.curve = circle_beside_the_axis();
    moved.vector = {0.5, -1, 2};
    const CurveShapePtr circle = moved.curve;
    all.push_back({"extrusion",
                   moved,
                   [circle](double u, double v) {
                       return point_at(*circle, u) + v * Vector3{0.5, -1, 2};
                   },
                   {{-3, 3}, {-2, 2}}});
    return all;
}

TEST(SurfaceShapes, splines_are_the_surface_at_mapped_parameters) {
    std::mt19937_64 random(20261127);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto part_of = [&](Interval all) {
        double a = std::lerp(all.lower, all.upper, unit(random)),
               b = std::lerp(all.lower, all.upper, unit(random));
        return a < b ? Interval{a, b + 0.01} : Interval{b, a + 0.01};
    };
    for (const Case &one : cases()) {
        SCOPED_TRACE(one.name);
        for (int k = 0; k < 30; ++k) {
            const Rectangle range = {part_of(one.most.u), part_of(one.most.v)};
            const SplinePtr spline = surface_spline(one.surface, range);
            for (int i = 0; i < 25; ++i) {
                const double u = std::lerp(range.u.lower, range.u.upper, unit(random)),
                             v = std::lerp(range.v.lower, range.v.upper, unit(random));
                const double s = to_spline_parameter(law_at(one.surface, 0, u), spline->axis(0), u);
                const double t = to_spline_parameter(law_at(one.surface, 1, v), spline->axis(1), v);
                expect_near(point_of(*spline, s, t), one.point(u, v), 2e-14);
            }
        }
    }
}

TEST(SurfaceShapes, parts_around_points_contain_them) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const Case &one : cases()) {
        if (bounded(one.surface)) {
            continue;
        }
        SCOPED_TRACE(one.name);
        for (int k = 0; k < 100; ++k) {
            std::vector<Vector3> points;
            std::vector<std::array<double, 2>> params;
            for (int i = 0; i < 3; ++i) {
                params.push_back({std::lerp(one.most.u.lower, one.most.u.upper, unit(random)),
                                  std::lerp(one.most.v.lower, one.most.v.upper, unit(random))});
                points.push_back(one.point(params.back()[0], params.back()[1]));
            }
            const Rectangle range = range_around(one.surface, points, 0x1p-6);
            for (const auto &[u, v] : params) {
                const bool around = range.u.lower == 0 && range.u.upper == turn;
                EXPECT_TRUE(around || (range.u.lower < u && u < range.u.upper));
                EXPECT_TRUE(range.v.lower < v && v < range.v.upper);
            }
            EXPECT_LT(range.v.upper - range.v.lower, 12);
        }
    }
}

// The apex of this cone is at -2 / tan 0.5, about -3.66.
TEST(SurfaceShapes, cones_go_on_beyond_their_apex) {
    const Case cone = cases()[2];
    const double apex = -2 / std::tan(0.5);
    for (const double nearest : {-5.0, apex}) {
        const std::vector<Vector3> points{cone.point(0, nearest), cone.point(1, -7), cone.point(2, -6)};
        const Rectangle range = range_around(cone.surface, points, 0x1p-6);
        EXPECT_LT(range.v.lower, -7);
        EXPECT_GE(range.v.lower, -8);
        EXPECT_GE(range.v.upper, nearest);
        EXPECT_LE(range.v.upper, apex);
        const SplinePtr spline = surface_spline(cone.surface, range);
        for (const double u : {0.25, 2.0, 5.0}) {
            const double s = to_spline_parameter(law_at(cone.surface, 0, u), spline->axis(0), u);
            expect_near(point_of(*spline, s, -6.5), cone.point(u, -6.5), 2e-14);
        }
    }
}

TEST(SurfaceShapes, measures_say_what_parameters_are) {
    const std::vector<Case> all = cases();
    const std::pair<Measure, Measure> expected[] = {
        {Measure::length, Measure::length}, {Measure::angle, Measure::length},
        {Measure::angle, Measure::length},  {Measure::angle, Measure::angle},
        {Measure::angle, Measure::angle},   {Measure::angle, Measure::angle},
        {Measure::angle, Measure::ratio}};
    for (size_t i = 0; i < all.size(); ++i) {
        SCOPED_TRACE(all[i].name);
        EXPECT_EQ(measure_of(all[i].surface, 0), expected[i].first);
        EXPECT_EQ(measure_of(all[i].surface, 1), expected[i].second);
    }
}

// Recognition knows nothing of how splines are made.
TEST(SurfaceShapes, splines_are_recognized_as_what_they_were_made_of) {
    using namespace nrb::recognize;
    const std::pair<int32_t, std::array<double, 2>> expected[] = {
        {shape_plane, {0, 0}},  {shape_cylinder, {2, 0}}, {shape_cone, {0.5, 0}},
        {shape_sphere, {2, 0}}, {shape_torus, {3, 0.5}},  {shape_torus, {3, 0.5}}};
    const std::vector<Case> all = cases();
    for (size_t i = 0; i < std::size(expected); ++i) {
        SCOPED_TRACE(all[i].name);
        const SplinePtr spline = surface_spline(all[i].surface, {{0.25, 1.5}, {-0.5, 1}});
        const Recognition found = recognize::recognize(*spline, 1e-12);
        EXPECT_EQ(found.shape.kind, expected[i].first);
        if (found.shape.kind != shape_plane) {
            EXPECT_NEAR(found.shape.sizes[0], expected[i].second[0], 1e-12);
            EXPECT_NEAR(found.shape.sizes[1], expected[i].second[1], 1e-12);
        }
    }
}

} // namespace

} // namespace surface_shapes_test
