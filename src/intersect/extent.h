// SPDX-License-Identifier: MIT
// The extent of Bezier pieces along a vector.
#pragma once

#include "base/numbers.h"
#include "numeric/norm.h"
#include "pieces/bezier_piece.h"

#include <algorithm>

namespace nrb::intersect {

// The range of vector . P over the control points P, which bounds it over the whole piece (convex hull
// property). Precondition: piece.positive().
inline Interval extent_along(const pieces::BezierPiece &piece, const double *vector) noexcept {
    Interval range{infinity, -infinity};
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        const double x = dot(vector, piece.point(i), piece.dim());
        range = {std::min(range.lower, x), std::max(range.upper, x)};
    }
    return range;
}

} // namespace nrb::intersect
