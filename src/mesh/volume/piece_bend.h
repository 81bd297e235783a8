// SPDX-License-Identifier: MIT
// How far a Bezier piece is from what is linear along every axis.
//
// Let I_k be linear interpolation between the ends of a cell along axis k, and h_k the length of the cell along it. Of a function f,
//
//     f - I_0 I_1 I_2 f = (f - I_0 f) + I_0 (f - I_1 f) + I_0 I_1 (f - I_2 f),
//
// where each difference is at most h_k^2 / 8 times the most of the second derivative along axis k, and no I_k makes anything longer.
#pragma once

#include "pieces/bezier_piece.h"

#include <array>

namespace nrb::mesh {

// Along each axis, in units of the length of the piece along it: no first, or second, derivative of the piece as computed is
// longer. Infinite where weights are not positive for certain.
struct PieceBend {
    std::array<double, max_axes> first{}, second{};
    double moved = 0; // no point of the exact piece is farther from that of the piece as computed

    // No point is farther from the interpolant at equal parameters if cells have these shares of the piece along the axes.
    [[nodiscard]] double bound(const std::array<double, max_axes> &shares) const noexcept;
};

PieceBend bend_of(const pieces::BezierPiece &piece);

} // namespace nrb::mesh
