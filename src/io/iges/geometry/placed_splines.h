// SPDX-License-Identifier: MIT
// Splines of a definition space, placed.
#pragma once

#include "io/iges/geometry/placement.h"
#include "model/shapes/curve_shape.h"
#include "spline/spline.h"

namespace nrb::io::iges {

// The given spline has dimension 3, the result that of the placement.
SplinePtr placed_spline(const Spline &spline, const Placement &place);

// The whole of a curve.
model::CurvePiece whole(model::CurveShapePtr curve);

// The spline of a piece, exact and over its range. Throws what model::piece_spline() throws.
SplinePtr spline_of(const model::CurvePiece &piece);

// About how many doubles a spline of the piece may hold.
int64_t size_of(const model::CurvePiece &piece) noexcept;

} // namespace nrb::io::iges
