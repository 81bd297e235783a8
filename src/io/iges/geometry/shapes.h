// SPDX-License-Identifier: MIT
// Surfaces from placed curves, with the parameters that the standard defines.
#pragma once

#include "io/iges/geometry/geometry.h"

namespace nrb::io::iges {

// The piece as a curve of its own.
model::CurveShapePtr shape_of_piece(const model::CurvePiece &piece);

// A shape of a kind, with nothing else set.
model::SurfaceShape shape_of(model::SurfaceKind kind);

Surface surface_of_spline(SplinePtr spline);

// The profile revolved about the axis Z of a placement; u along the profile, v the angle. Throws
// Status::angle.
Surface revolved(const model::CurvePiece &profile, const build::Placement &axis, double start, double end);

// u from 0 to 1 along the directrix, v from 0 to 1 along the vector. Throws Status::length.
Surface extruded(const model::CurvePiece &directrix, const Vector3 &way);

Vector3 start_of(const model::CurvePiece &piece);

// A normal of any length, at the middle of the range; an unbounded range is replaced by a finite part of it,
// around 0 if both ends are infinite.
Vector3 normal_in_the_middle(const model::SurfaceShape &surface);

// About how many doubles making a spline of the surface may take.
int64_t size_of(const model::SurfaceShape &surface) noexcept;

// Whether parameters inside a piece are those of the standard up to a shift: false for parabolas and
// hyperbolas.
bool standard_parameters(const model::CurvePiece &piece) noexcept;

} // namespace nrb::io::iges
