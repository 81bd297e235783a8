// SPDX-License-Identifier: MIT
// Surfaces as files state them, in the parametrization of ISO 10303-42.
#pragma once

#include "model/shapes/curve_shape.h"

#include <span>

namespace nrb::model {

//     plane       C + u X + v Y
//     cylinder    C + s0 (cos u X + sin u Y) + v Z
//     cone        C + (s0 + v tan s1) (cos u X + sin u Y) + v Z             s1 half of the angle at the apex
//     sphere      C + s0 cos v (cos u X + sin u Y) + s0 sin v Z
//     torus       C + (s0 + s1 cos v) (cos u X + sin u Y) + s1 sin v Z
//     revolution  `curve` at v, turned by u about the axis through C along Z
//     extrusion   `curve` at u, moved by v `vector`
//     offset      `distance` from `basis` along its normal
//     spline
//     trimmed     `basis` over `range`; against the direction of an axis of the basis the parameter is -u or -v
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
    Rectangle range;          // torus: a degenerate one has a part of v only; trimmed
    CurveShapePtr curve;      // revolution, extrusion
    Vector3 vector;           // extrusion
    SurfaceShapePtr basis;    // offset, trimmed
    double distance = 0;      // offset
    bool u_forward = true;    // trimmed
    bool v_forward = true;
    SplinePtr spline;
};

// Where the surface is defined: infinite ends where it has none, and [0, 2 pi] around an axis. A cone ends at its
// apex.
Rectangle natural_range(const SurfaceShape &surface) noexcept;
bool bounded(const SurfaceShape &surface) noexcept;

// What a parameter of an axis measures, which decides about its unit.
enum class Measure { length, angle, ratio };
Measure measure_of(const SurfaceShape &surface, int axis) noexcept;

// A range in which the surface contains the part whose points are those of the hull of `points` that are on it: ends
// that are infinite are replaced, others stay. It is wider by `margin` times its length, and never empty. Throws
// Status::too_few_points if there are no points where one is needed.
Rectangle range_around(const SurfaceShape &surface, std::span<const Vector3> points, double margin);

} // namespace nrb::model
