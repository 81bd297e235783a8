// SPDX-License-Identifier: MIT
// Rays that pass near a curve.
#pragma once

#include "intersect/rays/ray.h"
#include "spline/spline.h"

namespace nrb::intersect {

struct CurvePassage {
    Interval ts{infinity, -infinity}; // lower > upper: the ray does not come near
    double param = 0;                 // of the curve, about where the ray first comes near

    [[nodiscard]] bool there() const noexcept { return ts.lower <= ts.upper; }
};

// Bounds on the t at which the ray may be as near to the curve as the distance; elsewhere in the query's
// range it is proven to be farther away. Precondition: a curve in space.
CurvePassage passage_near(const Spline &curve, const RayQuery &query, double distance);

} // namespace nrb::intersect
