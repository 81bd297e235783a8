// SPDX-License-Identifier: MIT
// The polynomial pieces of a spline as arrays, without a spline for each.
#pragma once

#include "spline/part.h"

namespace nrb::refine {

// Where the pieces go, last axis fastest in pieces and control points; null: not wanted.
struct PieceArrays {
    double *points;  // [pieces][(p_0 + 1)...][dim], Cartesian
    double *weights; // [pieces][(p_0 + 1)...]
    double *domains; // [pieces][axes][2]
};

// Throws Status::overflow.
int64_t count_pieces(const Spline &spline);
// Control points of each piece.
int64_t points_of_piece(const Spline &spline) noexcept;

// The domain of a piece along each axis; last axis fastest in pieces.
Part domain_of_piece(const Spline &spline, int64_t index);

// Writes what bezier_pieces() has in its parts, bit for bit. Throws what that throws, before anything is written.
void write_pieces(const SplinePtr &spline, const PieceArrays &arrays);

} // namespace nrb::refine
