// SPDX-License-Identifier: MIT
// Whether places of a domain lie near a piece, in the metric of the surface there.
#pragma once

#include "face/trims/trim_piece.h"

namespace nrb::face {

// The lengths of steps in the domain to first order: |J d|^2 = d^T G d with G = J^T J, in units of the distance that is asked for.
struct Metric {
    double uu = 0, uv = 0, vv = 0;

    // Of first derivatives [dim] each.
    static Metric of(const double *u, const double *v, int dim, double unit) noexcept;
    // How far along the axes places may be that are at a distance of 1; infinite where points do not move.
    [[nodiscard]] Point2 reach() const noexcept;
    [[nodiscard]] double squared(double u, double v) const noexcept {
        return uu * u * u + 2 * uv * u * v + vv * v * v;
    }
};

// Whether a point of the piece has at most the distance 1 from x: decided to a millionth of it. Cost: halvings of the parts that
// may be as near.
bool is_near(const TrimPieces &pieces, const TrimPiece &piece, const Point2 &x, const Metric &metric);

} // namespace nrb::face
