// SPDX-License-Identifier: MIT
// The Bezier pieces of a spline in the frame of a shape.
#pragma once

#include "pieces/bezier_piece.h"
#include "recognize/shape_model.h"

#include <vector>

namespace nrb::recognize {

// The pieces in dimension 3, with the origin of the shape as their centre. Cost: linear in the number of
// pieces. Precondition: dimension 2 or 3.
std::vector<pieces::BezierPiece> shape_pieces(const Spline &spline, const Shape &shape);

inline Vector3 point_of(const pieces::BezierPiece &piece, int64_t i) noexcept {
    const double *x = piece.point(i);
    return {x[0], x[1], x[2]};
}

// The axis along which the control points spread most; -1 if all degrees are 0.
int widest_axis(const pieces::BezierPiece &piece) noexcept;

} // namespace nrb::recognize
