// SPDX-License-Identifier: MIT
// The Bezier pieces of a spline as arrays, without a spline for each.
#pragma once

#include "spline/part.h"

namespace nrb::refine {

// The outputs, last axis fastest in pieces and control points. A null array is not wanted.
struct PieceArrays {
    double *points;  // [pieces][(p_0 + 1)...][dim], Cartesian
    double *weights; // [pieces][(p_0 + 1)...]
    double *domains; // [pieces][axes][2]
};

// The number of Bezier pieces. Throws Status::overflow.
int64_t count_pieces(const Spline &spline);
// The number of control points of each piece.
int64_t points_of_piece(const Spline &spline) noexcept;

// The domain of piece `index`, last axis fastest.
Part domain_of_piece(const Spline &spline, int64_t index);

// Writes the parts of bezier_pieces(), bit for bit. Throws what that throws, before anything is written.
void write_pieces(const SplinePtr &spline, const PieceArrays &arrays);

} // namespace nrb::refine
