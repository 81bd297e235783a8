// SPDX-License-Identifier: MIT
// Boxes of parameters in the coordinates of one piece, which may reach into those beside it.
#pragma once

#include "base/numbers.h"
#include "intersect/extrema/fields/stratum.h"

#include <algorithm>
#include <optional>

namespace nrb::intersect {

// Part of a piece, and how its derivatives are seen from another one: the place on it is a multiple of that of the other
// along each axis, and its unit another one.
struct CoveredPart {
    PieceIndex index;
    GradientPiecePtr piece;
    Part box{}; // in [0, 1] of each axis that is free
    std::array<double, max_axes> scale{1, 1, 1};
    int exponent = 0;
};

// Where a box in coordinates of a piece lies, on a stratum whose joints of free axes it crosses are smooth: widened by
// rounding. None if it reaches beyond the pieces beside that one.
std::optional<std::vector<CoveredPart>> covered(const GradientField &field, const Stratum &stratum,
                                                const PieceIndex &home, const Part &box);

// A sum of intervals, which begins with nothing.
inline Interval hull(Interval a, Interval b) noexcept {
    return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}
inline constexpr Interval nothing{infinity, -infinity};

// What a polynomial on a part of a piece may be, as its coefficients there tell. Precondition: degree 0 along axes that are
// fixed.
Interval range_over(RoundedPolynomial f, const CoveredPart &part, const Stratum &stratum, int axes);

// The numerator of derivative k on a stratum, divided by its zeros along the side of the piece that is on it if axis k is
// fixed: 1 or -1, the sign of the derivative beside all of a part; else 0.
int slope_sign(const CoveredPart &part, const Stratum &stratum, int axes, int k);

} // namespace nrb::intersect
