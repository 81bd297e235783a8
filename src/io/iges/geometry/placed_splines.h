// SPDX-License-Identifier: MIT
// Splines of a definition space where they lie.
#pragma once

#include "io/iges/geometry/placement.h"
#include "model/shapes/curve_shape.h"
#include "spline/spline.h"

namespace nrb::io::iges {

// Of dimension 3 before, and of that of the placement afterwards.
SplinePtr placed_spline(const Spline &spline, const Placement &place);

// All of a curve.
model::CurvePiece whole(model::CurveShapePtr curve);

// Exact, over the range of the piece. Throws what model::piece_spline() throws.
SplinePtr spline_of(const model::CurvePiece &piece);

// Doubles that a spline of the piece may hold.
int64_t size_of(const model::CurvePiece &piece) noexcept;

} // namespace nrb::io::iges
