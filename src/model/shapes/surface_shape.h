// SPDX-License-Identifier: MIT
// Surfaces in analytic form, as files state them, in the parametrization of ISO 10303-42.
#pragma once

#include "model/shapes/curve_shape.h"

#include <span>

namespace nrb::model {

// With the origin C and the axes X, Y, Z of the frame `place`, and the sizes s0, s1:
//     plane       C + u X + v Y
//     cylinder    C + s0 (cos u X + sin u Y) + v Z
//     cone        C + (s0 + v tan s1) (cos u X + sin u Y) + v Z             s1 half of the angle at the apex
//     sphere      C + s0 cos v (cos u X + sin u Y) + s0 sin v Z
//     torus       C + (s0 + s1 cos v) (cos u X + sin u Y) + s1 sin v Z
//     revolution  `curve` at v, rotated by u about the axis through C along Z
//     extrusion   `curve` at u, moved by v `vector`
//     offset      `distance` from `basis` along its normal
//     spline
//     trimmed     `basis` over `range`; on an axis that runs against the basis the parameter is -u or -v
// Angles are in radians.
enum class SurfaceKind {
    plane,
    cylinder,
    cone,
    sphere,
    torus,
    revolution,
    extrusion,
    offset,
    spline,
    trimmed
};

struct SurfaceShape;
using SurfaceShapePtr = std::shared_ptr<const SurfaceShape>;

struct Rectangle {
    Interval u;
    Interval v;
};

struct SurfaceShape {
    SurfaceKind kind;
    build::Placement place;   // plane to revolution
    double sizes[2] = {0, 0}; // s0, s1
    Rectangle range;          // trimmed; of a torus v, all of it unless degenerate
    CurveShapePtr curve;      // revolution, extrusion
    Vector3 vector;           // extrusion
    SurfaceShapePtr basis;    // offset, trimmed
    double distance = 0;      // offset
    bool u_forward = true;    // trimmed
    bool v_forward = true;
    SplinePtr spline;
};

// The range on which the surface is defined: with infinite ends where it is unbounded, and [0, 2 pi] around
// an axis. A cone ends at its apex.
Rectangle natural_range(const SurfaceShape &surface) noexcept;
bool bounded(const SurfaceShape &surface) noexcept;

// What the parameter of an axis measures, which determines its unit.
enum class Measure { length, angle, ratio };
Measure measure_of(const SurfaceShape &surface, int axis) noexcept;

// A range over which the surface contains those of its points that are in the convex hull of `points`. Finite
// ends of its natural range stay; an infinite end is replaced, with a margin of about `margin` times the
// extent of the points. The range is not empty if the points are on the surface. Throws
// Status::too_few_points if there are no points and one is needed.
Rectangle range_around(const SurfaceShape &surface, std::span<const Vector3> points, double margin);

} // namespace nrb::model
