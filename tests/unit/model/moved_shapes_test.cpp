// Curves and surfaces that are moved: at every parameter the image, with its normal on the side of the image's own parameters.
#include "model/shapes/moved_shape.h"

#include "eval/evaluate.h"
#include "model/shapes/curve_spline.h"
#include "model/shapes/surface_spline.h"

#include <cmath>
#include <gtest/gtest.h>

namespace moved_shapes_test {

namespace {

using namespace nrb;
using namespace nrb::model;

build::Placement frame() {
    const double origin[3] = {1, 2, 3}, z[3] = {1, -2, 0.5}, x[3] = {0.25, 1, 1};
    return build::make_placement(3, origin, z, x, "origin");
}

Similarity motion(double scale, bool mirrored) {
    const double origin[3] = {0, 0, 0}, z[3] = {2, 1, -1}, x[3] = {1, 0, 3};
    const build::Placement at = build::make_placement(3, origin, z, x, "origin");
    return {{scale * at.x, scale * at.y, (mirrored ? -scale : scale) * at.z}, {-4, 5, 6}};
}

SurfaceShape shape(SurfaceKind kind, double a = 0, double b = 0) {
    SurfaceShape surface{kind, frame(), {a, b}, {}, nullptr, {}, nullptr, 0, true, true, nullptr};
    surface.range.v = {0, turn};
    return surface;
}

CurveShapePtr curve(CurveKind kind, double a, double b) {
    return std::make_shared<const CurveShape>(CurveShape{kind, frame(), {a, b}, nullptr, {}});
}

std::vector<SurfaceShapePtr> surfaces() {
    std::vector<SurfaceShape> all{shape(SurfaceKind::plane),        shape(SurfaceKind::cylinder, 2),
                                  shape(SurfaceKind::cone, 2, 0.5), shape(SurfaceKind::sphere, 2),
                                  shape(SurfaceKind::torus, 3, 1),  shape(SurfaceKind::revolution),
                                  shape(SurfaceKind::extrusion),    shape(SurfaceKind::spline)};
    const double aside[3] = {9, 2, 3};
    CurveShape ring{
        CurveKind::circle, build::make_placement(3, aside, nullptr, nullptr, "origin"), {2, 0}, nullptr, {}};
    all[5].curve = std::make_shared<const CurveShape>(std::move(ring));
    all[6].curve = curve(CurveKind::parabola, 2, 0);
    all[6].vector = {1, 2, 3};
    all[7].spline = surface_spline(all[4], {{0, 1}, {0, 1}});
    std::vector<SurfaceShapePtr> result;
    for (SurfaceShape &surface : all) {
        result.push_back(std::make_shared<const SurfaceShape>(surface));
        SurfaceShape part = shape(SurfaceKind::trimmed);
        part.basis = result.back();
        part.range = {{0, 1}, {0.25, 0.75}};
        part.u_forward = false;
        result.push_back(std::make_shared<const SurfaceShape>(std::move(part)));
    }
    return result;
}

struct Jet {
    Vector3 point, u, v;
};

Jet jet_at(const Spline &surface, double u, double v) {
    const double at[2] = {u, v};
    double x[9];
    eval::evaluate_points(surface, {}, 1, {at, 1, 2, 2, 1}, {x, 1, 9, 9, 1});
    return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}};
}

void expect_near(const Vector3 &found, const Vector3 &wanted, const char *what) {
    EXPECT_LE(length(found - wanted), 1e-12 * (1 + length(wanted))) << what;
}

TEST(MovedShapes, surfaces_are_images_at_every_parameter) {
    for (const SurfaceShapePtr &surface : surfaces()) {
        for (const double scale : {1.0, 2.5}) {
            for (const bool mirrored : {false, true}) {
                const Similarity way = motion(scale, mirrored);
                const SurfaceShapePtr image = moved(surface, way);
                const Rectangle range = surface->kind == SurfaceKind::trimmed
                                            ? Rectangle{{-1, 0}, {0.25, 0.75}}
                                            : Rectangle{{0, 1}, {0.25, 0.75}};
                const SplinePtr before = surface_spline(*surface, range),
                                after = surface_spline(*image, range);
                for (int i = 0; i <= 25; ++i) {
                    const double u = std::lerp(range.u.lower, range.u.upper, (i % 6) / 5.0),
                                 v = std::lerp(range.v.lower, range.v.upper, (i / 6) / 4.0);
                    const Jet a = jet_at(*before, u, v), b = jet_at(*after, u, v);
                    SCOPED_TRACE(static_cast<int>(surface->kind));
                    expect_near(b.point, way.point(a.point), "point");
                    expect_near(b.u, way.turned(a.u), "u");
                    expect_near(b.v, way.turned(a.v), "v");
                }
            }
        }
    }
}

TEST(MovedShapes, turned_surfaces_keep_their_kind) {
    for (const SurfaceShapePtr &surface : surfaces()) {
        EXPECT_EQ(moved(surface, motion(1, false))->kind, surface->kind);
    }
    EXPECT_EQ(moved(surfaces()[6], motion(3, false))->kind, SurfaceKind::sphere);
    EXPECT_EQ(moved(surfaces()[0], motion(1, true))->kind, SurfaceKind::plane);
}

// On the other side in a mirror: its own normal is against the image of the given one.
TEST(MovedShapes, offsets_stay_beside_their_basis) {
    SurfaceShape offset = shape(SurfaceKind::offset);
    offset.basis = surfaces()[6];
    offset.distance = 0.5;
    const auto given = std::make_shared<const SurfaceShape>(offset);
    EXPECT_EQ(moved(given, motion(2, false))->distance, 1);
    EXPECT_EQ(moved(given, motion(2, true))->distance, -1);
}

TEST(MovedShapes, curves_are_images_at_every_parameter) {
    std::vector<CurveShapePtr> curves{curve(CurveKind::line, 2, 0), curve(CurveKind::circle, 2, 0),
                                      curve(CurveKind::ellipse, 3, 2), curve(CurveKind::parabola, 2, 0),
                                      curve(CurveKind::hyperbola, 2, 1)};
    curves.push_back(curve_of_spline(curve_spline(*curves[2], {0, 1})));
    curves.push_back(curve_of_piece({curves[2], {0, 1}, false}));
    curves.push_back(composite_curve({{curves[0], {0, 1}, true}}, 1e-9));
    for (const CurveShapePtr &given : curves) {
        for (const bool mirrored : {false, true}) {
            const Similarity way = motion(2.5, mirrored);
            const CurveShapePtr image = moved(given, way);
            EXPECT_EQ(image->kind, given->kind);
            for (int i = 0; i <= 8; ++i) {
                const double t = given->kind == CurveKind::trimmed ? i / 8.0 - 1 : i / 8.0;
                expect_near(point_at(*image, t), way.point(point_at(*given, t)), "curve");
            }
        }
    }
}

} // namespace

} // namespace moved_shapes_test
