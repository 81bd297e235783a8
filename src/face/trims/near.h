// SPDX-License-Identifier: MIT
// Whether places of a domain lie near a piece, in the metric of the surface there.
#pragma once

#include "face/trims/trim_piece.h"

namespace nrb::face {

// The first fundamental form at a place, in units of the distance that is asked for: to first order, a step d
// in the domain has the squared length |J d|^2 = d^T G d with G = J^T J.
struct Metric {
    double uu = 0, uv = 0, vv = 0;

    // From the first derivatives of the surface, [dim] each.
    static Metric of(const double *u, const double *v, int dim, double unit) noexcept;
    // How far along each axis places at a distance of 1 may be: half the sides of the box of the unit
    // ellipse. Infinite where G is nearly singular.
    [[nodiscard]] Point2 reach() const noexcept;
    [[nodiscard]] double squared(double u, double v) const noexcept {
        return uu * u * u + 2 * uv * u * v + vv * v * v;
    }
};

// Whether a point of the piece is at a distance of at most 1 from x, decided to 1e-6. Cost: halvings of the
// parts that may be that near.
bool is_near(const TrimPieces &pieces, const TrimPiece &piece, const Point2 &x, const Metric &metric);

} // namespace nrb::face
