// Offset surfaces that are known surfaces again: by their definition, point by point.
#include "model/shapes/offset_shape.h"

#include "eval/evaluate.h"
#include "model/shapes/surface_spline.h"

#include <cmath>
#include <gtest/gtest.h>

namespace offset_shapes_test {

namespace {

using namespace nrb;
using namespace nrb::model;

build::Placement frame() {
    const double origin[3] = {1, 2, 3}, z[3] = {1, -2, 0.5}, x[3] = {0.25, 1, 1};
    return build::make_placement(3, origin, z, x, "origin");
}

SurfaceShape shape(SurfaceKind kind, double a = 0, double b = 0) {
    SurfaceShape surface{kind, frame(), {a, b}, {}, nullptr, {}, nullptr, 0, true, true, nullptr};
    surface.range.v = {0, turn};
    return surface;
}

SurfaceShapePtr shared(SurfaceShape surface) {
    return std::make_shared<const SurfaceShape>(std::move(surface));
}

SurfaceShapePtr extruded(CurveKind kind, const Vector3 &way) {
    SurfaceShape surface = shape(SurfaceKind::extrusion);
    surface.curve = std::make_shared<const CurveShape>(CurveShape{kind, frame(), {2, 0}, nullptr, {}});
    surface.vector = way;
    return shared(std::move(surface));
}

SurfaceShapePtr part_of(const SurfaceShapePtr &basis, bool u_forward, bool v_forward) {
    SurfaceShape part = shape(SurfaceKind::trimmed);
    part.basis = basis;
    part.range = {{-2, 2}, {-2, 2}};
    part.u_forward = u_forward;
    part.v_forward = v_forward;
    return shared(std::move(part));
}

SurfaceShapePtr moved(const SurfaceShapePtr &basis, double distance) {
    SurfaceShape offset = shape(SurfaceKind::offset);
    offset.basis = basis;
    offset.distance = distance;
    return shared(std::move(offset));
}

// The point at a distance along S_u x S_v.
Vector3 offset_point(const Spline &spline, const double *at, double distance) {
    double x[9];
    eval::evaluate_points(spline, {}, 1, {at, 1, 2, 2, 1}, {x, 1, 9, 9, 1});
    const Vector3 normal = cross(Vector3{x[3], x[4], x[5]}, Vector3{x[6], x[7], x[8]});
    return Vector3{x[0], x[1], x[2]} + distance / length(normal) * normal;
}

constexpr Rectangle usual_range{{0.25, 1.25}, {-0.5, 1}};

// Parameters of circles are those of their splines in quarters only, but the same of both.
void expect_offset(const SurfaceShapePtr &basis, double distance, SurfaceKind kind) {
    const SurfaceShapePtr known = known_offset(basis, distance);
    ASSERT_NE(known, nullptr);
    EXPECT_EQ(known->kind, kind);
    const SplinePtr spline = surface_spline(*basis, usual_range), found = surface_spline(*known, usual_range);
    for (int i = 0; i <= 10; ++i) {
        for (int j = 0; j <= 10; ++j) {
            const double at[2] = {std::lerp(0.25, 1.25, i / 10.0), std::lerp(-0.5, 1.0, j / 10.0)};
            double x[3];
            eval::evaluate_points(*found, {}, 0, {at, 1, 2, 2, 1}, {x, 1, 3, 3, 1});
            EXPECT_LE(length(Vector3{x[0], x[1], x[2]} - offset_point(*spline, at, distance)), 4e-14);
        }
    }
}

TEST(OffsetShapes, keep_their_kind) {
    for (const double distance : {0.25, -0.25}) {
        expect_offset(shared(shape(SurfaceKind::plane)), distance, SurfaceKind::plane);
        expect_offset(shared(shape(SurfaceKind::cylinder, 2)), distance, SurfaceKind::cylinder);
        expect_offset(shared(shape(SurfaceKind::cone, 2, 0.5)), distance, SurfaceKind::cone);
        expect_offset(shared(shape(SurfaceKind::cone, 2, -0.5)), distance, SurfaceKind::cone);
        expect_offset(shared(shape(SurfaceKind::sphere, 2)), distance, SurfaceKind::sphere);
        expect_offset(shared(shape(SurfaceKind::torus, 3, 0.5)), distance, SurfaceKind::torus);
        expect_offset(extruded(CurveKind::line, {0.5, -1, 2}), distance, SurfaceKind::extrusion);
        expect_offset(extruded(CurveKind::circle, 2 * frame().z), distance, SurfaceKind::extrusion);
        expect_offset(extruded(CurveKind::circle, -2 * frame().z), distance, SurfaceKind::extrusion);
    }
}

TEST(OffsetShapes, of_parts_and_of_offsets) {
    const SurfaceShapePtr ball = shared(shape(SurfaceKind::sphere, 2));
    for (const bool u : {false, true}) {
        for (const bool v : {false, true}) {
            expect_offset(part_of(ball, u, v), 0.25, SurfaceKind::trimmed);
        }
    }
    EXPECT_EQ(known_offset(ball, 0), ball);
    EXPECT_EQ(known_offset(ball, -0.0), ball);
}

// A radius beyond 0 is that of the same points from their other side on.
TEST(OffsetShapes, beyond_the_centre_of_curvature) {
    expect_offset(shared(shape(SurfaceKind::cylinder, 2)), -3, SurfaceKind::cylinder);
    expect_offset(shared(shape(SurfaceKind::sphere, 2)), -3, SurfaceKind::trimmed);
    expect_offset(extruded(CurveKind::circle, 2 * frame().z), -3, SurfaceKind::extrusion);
    expect_offset(extruded(CurveKind::circle, -2 * frame().z), 3, SurfaceKind::extrusion);
    for (const bool u : {false, true}) {
        for (const bool v : {false, true}) {
            const double inwards = u == v ? -3 : 3;
            expect_offset(part_of(shared(shape(SurfaceKind::cylinder, 2)), u, v), inwards,
                          SurfaceKind::trimmed);
            expect_offset(part_of(shared(shape(SurfaceKind::sphere, 2)), u, v), inwards,
                          SurfaceKind::trimmed);
        }
    }
}

// Each along the normal of the one before it, whatever that has become of the first.
TEST(OffsetShapes, of_offsets_go_along_their_normals) {
    for (const double first : {0.5, -0.5, -2.5, -3.0}) {
        for (const double second : {0.25, -0.25, 1.0, -1.0, 4.0, -4.0}) {
            for (const SurfaceKind kind : {SurfaceKind::cylinder, SurfaceKind::sphere, SurfaceKind::plane}) {
                const SurfaceShapePtr once = known_offset(shared(shape(kind, 2)), first);
                const SurfaceShapePtr twice = known_offset(once, second);
                if (twice != nullptr) { // a radius of 0
                    expect_offset(once, second, twice->kind);
                }
            }
        }
    }
}

double radius_of(const SurfaceShapePtr &surface) {
    return surface == nullptr                      ? 0
           : surface->kind == SurfaceKind::trimmed ? radius_of(surface->basis)
                                                   : surface->sizes[0];
}

// As shapes whose basis is an offset still, too.
TEST(OffsetShapes, of_cylinders_turned_inside_out) {
    const SurfaceShapePtr rod = shared(shape(SurfaceKind::cylinder, 1)),
                          ball = shared(shape(SurfaceKind::sphere, 1));
    EXPECT_EQ(radius_of(known_offset(known_offset(rod, -1.5), 1)), 1.5);
    EXPECT_EQ(radius_of(known_offset(moved(rod, -1.5), 1)), 1.5);
    EXPECT_EQ(radius_of(known_offset(moved(rod, -1.5), -0.5)), 0); // the axis
    EXPECT_EQ(radius_of(known_offset(moved(rod, 0.5), 1)), 2.5);
    EXPECT_EQ(radius_of(known_offset(known_offset(ball, -1.5), 1)),
              0.5); // its normal is still outwards from where it was
    EXPECT_EQ(radius_of(known_offset(moved(ball, -1.5), 1)), 0.5);
    const SurfaceShapePtr tube = shared(shape(SurfaceKind::torus, 3, 0.5));
    EXPECT_EQ(known_offset(moved(tube, -0.75), -0.5)->sizes[1],
              0.25); // -0.25 from the circle, and its normal to the other side
    EXPECT_EQ(known_offset(moved(tube, -0.75), 0.5), nullptr);
    EXPECT_EQ(known_offset(moved(tube, -4), 1), nullptr);
    EXPECT_EQ(known_offset(moved(shared(shape(SurfaceKind::cone, 2, 0.5)), -3), 1), nullptr);
    EXPECT_EQ(known_offset(moved(shared(shape(SurfaceKind::cone, 2, 0.5)), 3), 1)->sizes[0],
              2 + 4 * std::cos(0.5));
}

TEST(OffsetShapes, are_none_where_a_radius_would_not_be_one) {
    EXPECT_EQ(known_offset(shared(shape(SurfaceKind::sphere, 2)), -2), nullptr);
    EXPECT_EQ(known_offset(shared(shape(SurfaceKind::cylinder, 2)), -2), nullptr);
    EXPECT_EQ(known_offset(shared(shape(SurfaceKind::cone, 2, 0.5)), -3), nullptr);
    EXPECT_EQ(known_offset(shared(shape(SurfaceKind::torus, 3, 0.5)), -0.5), nullptr);
    EXPECT_EQ(known_offset(shared(shape(SurfaceKind::torus, 3, 0.5)), 2.5), nullptr);
    EXPECT_EQ(known_offset(extruded(CurveKind::circle, 2 * frame().z), -2), nullptr);
    EXPECT_EQ(known_offset(extruded(CurveKind::circle, frame().x), 0.25), nullptr);
    EXPECT_EQ(known_offset(extruded(CurveKind::line, frame().x), 0.25), nullptr);
    EXPECT_EQ(known_offset(extruded(CurveKind::parabola, frame().z), 0.25), nullptr);
}

} // namespace

} // namespace offset_shapes_test
