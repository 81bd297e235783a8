// SPDX-License-Identifier: MIT
// The equations of feet, by what pieces of a surface and of a curve have in them.
#pragma once

#include "bernstein/rounded_polynomial.h"
#include "intersect/surfaces/cross_cell.h"

#include <optional>

namespace nrb::intersect {

// With S = A / w and C = B / W, a foot (u, v, t) has (S - C) . S_k = 0 for both axes k; S_k is T_k / w^2 with
// T_k = w A_k - w_k A, so that
//     F_k = W (A . T_k) - B . (w T_k) = 0:
// products of four polynomials of (u, v) and four of t. Where T_k vanishes along a side of a piece, at a pole or where control
// points are one, it is divided by the place, as often as that is so: what is left of it is still along the tangent there, and
// places of the side are feet only if the tangent plane says so.

// Coefficients [degrees[0] + 1][degrees[1] + 1][width] of a piece. Of a surface width is 8: A . T_0, w T_0, A . T_1, w T_1; of a
// curve it is 4: W, -B, and degrees[1] is 0.
struct FeetNet {
    const CrossPiece *piece =
        nullptr; // of a curve one of lines through it, of which axis 0 is that of the curve
    std::array<int, 2> degrees{};
    size_t width = 0;
    std::vector<double> values;
    // Largest magnitudes of the first of four, and of the norms of the other three, and how far they may be off: for each axis of
    // a surface.
    struct Size {
        double first = 0, others = 0, first_error = 0, others_error = 0;
    };
    std::array<Size, 2> sizes{};
    std::array<double, 2> speeds{}; // the largest derivatives of points, by places

    [[nodiscard]] size_t coefficients() const noexcept { return values.size() / width; }
};

// Both T_k; none: one of them vanishes altogether.
std::optional<std::array<RoundedPolynomial, 2>> tangents_of(const CrossPiece &piece);

std::optional<FeetNet> feet_net_of(const CrossPiece &piece);
// lines: CrossPiece of lines through the points of the piece.
FeetNet feet_net_of(const pieces::BezierPiece &curve, const CrossPiece &lines);

// The largest derivative of points by places along an axis of a piece with positive weights.
double largest_speed(const pieces::BezierPiece &piece, size_t axis);

// Values at a place, and derivatives by places along both axes, if they are asked for (not null).
void evaluate_net(const std::array<int, 2> &degrees, size_t width, const double *net,
                  const std::array<double, 2> &place, double *value, std::array<double *, 2> slopes) noexcept;

} // namespace nrb::intersect
