// SPDX-License-Identifier: MIT
// The equations of orthogonal feet in Bernstein form, split into the factors that a piece of the surface and
// a piece of the curve contribute.
#pragma once

#include "bernstein/rounded_polynomial.h"
#include "intersect/surfaces/cross_cell.h"

#include <optional>

namespace nrb::intersect {

// Let S(u, v) = A / w be the surface and C(t) = B / W the curve. At a foot (S - C) . S_k = 0 for both axes k
// of S. With S_k = T_k / w^2, T_k = w A_k - w_k A, this is
//     F_k = W (A . T_k) - B . (w T_k) = 0,
// the scalar product of four polynomials in (u, v), A . T_k and w T_k, with four in t, W and -B. Where T_k
// vanishes along a side of a piece, at a pole or where control points coincide, it is divided by the distance
// from that side, as often as it vanishes: the quotient still has the direction of the tangent there, so that
// points of the side are feet only if S - C is orthogonal to the tangent plane.

// The factors of one piece: Bernstein coefficients [degrees[0] + 1][degrees[1] + 1][width]. Of a surface the
// width is 8: A . T_0, w T_0, A . T_1, w T_1. Of a curve it is 4: W, -B, and degrees[1] is 0.
struct FeetNet {
    // Of a curve, the piece of its distance_lines(), whose axis 0 is that of the curve.
    const CrossPiece *piece = nullptr;
    std::array<int, 2> degrees{};
    size_t width = 0;
    std::vector<double> values;
    // Of each group of four values: the largest magnitude of the first, the largest norm of the other three,
    // and bounds of their errors. A surface has one group for each axis, a curve has sizes[0] alone.
    struct Size {
        double first = 0, others = 0, first_error = 0, others_error = 0;
    };
    std::array<Size, 2> sizes{};
    std::array<double, 2> speeds{}; // bounds of the derivatives of points by places

    [[nodiscard]] size_t coefficients() const noexcept { return values.size() / width; }
};

// Both T_k, divided as above; none if one of them vanishes identically, to rounding.
std::optional<std::array<RoundedPolynomial, 2>> tangents_of(const CrossPiece &piece);

std::optional<FeetNet> feet_net_of(const CrossPiece &piece);
// lines: the piece of distance_lines() of the curve along this piece of it.
FeetNet feet_net_of(const pieces::BezierPiece &curve, const CrossPiece &lines);

// A bound of the derivative of points by places along an axis of a piece with positive weights.
double largest_speed(const pieces::BezierPiece &piece, size_t axis);

// The values of a net at a place, and its derivatives by places along both axes unless `slopes` are null.
void evaluate_net(const std::array<int, 2> &degrees, size_t width, const double *net,
                  const std::array<double, 2> &place, double *value, std::array<double *, 2> slopes) noexcept;

} // namespace nrb::intersect
