// SPDX-License-Identifier: MIT
// Surfaces from curves that have been placed, with the parameters that the standard gives them.
#pragma once

#include "io/iges/geometry/geometry.h"

namespace nrb::io::iges {

// The piece as a curve of its own.
model::CurveShapePtr shape_of_piece(const model::CurvePiece &piece);

// Without contents.
model::SurfaceShape shape_of(model::SurfaceKind kind);

Surface surface_of_spline(SplinePtr spline);

// Turned about the axis Z of a placement; u along the profile, v the angle. Throws Status::angle.
Surface revolved(const model::CurvePiece &profile, const build::Placement &axis, double start, double end);

// u from 0 to 1 along the directrix, v from 0 to 1 along the vector. Throws Status::length.
Surface extruded(const model::CurvePiece &directrix, const Vector3 &way);

Vector3 start_of(const model::CurvePiece &piece);

// Of any length; around the middle of the range, and of its part around 0 where it has no ends.
Vector3 normal_in_the_middle(const model::SurfaceShape &surface);

// Doubles that making a spline of the surface may take.
int64_t size_of(const model::SurfaceShape &surface) noexcept;

// Whether parameters between the ends of a piece are those of the standard but for a shift: those of parabolas and
// hyperbolas are others.
bool standard_parameters(const model::CurvePiece &piece) noexcept;

} // namespace nrb::io::iges
