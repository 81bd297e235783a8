// SPDX-License-Identifier: MIT
// Bounds the distance of a Bezier piece from its multilinear interpolants over cells, by second derivatives.
//
// Let I_k be linear interpolation along axis k between the ends of a cell, and h_k the length of the cell
// along this axis. For a function f,
//
//     f - I_0 I_1 I_2 f = (f - I_0 f) + I_0 (f - I_1 f) + I_0 I_1 (f - I_2 f).
//
// Each difference in parentheses is at most h_k^2 / 8 times the largest second derivative along axis k, and
// no I_k increases the largest length of its argument.
#pragma once

#include "pieces/bezier_piece.h"

#include <array>

namespace nrb::mesh {

// Bounds on the lengths of the first and second derivatives of the piece as computed, along each axis in
// units of the length of the piece along it. Infinite where weights may not be positive.
struct PieceBend {
    std::array<double, max_axes> first{}, second{};
    double moved = 0; // bound on the distance of points of the exact piece from the piece as computed

    // A bound on the distance of points from the interpolant at equal parameters, for cells that have these
    // shares of the piece along the axes.
    [[nodiscard]] double bound(const std::array<double, max_axes> &shares) const noexcept;
};

PieceBend bend_of(const pieces::BezierPiece &piece);

} // namespace nrb::mesh
