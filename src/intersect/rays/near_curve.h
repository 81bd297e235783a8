// SPDX-License-Identifier: MIT
// Rays that pass near a curve.
#pragma once

#include "intersect/rays/ray.h"
#include "spline/spline.h"

namespace nrb::intersect {

struct CurvePassage {
    Interval ts{infinity, -infinity}; // lower > upper: they do not come near
    double param = 0;                 // of the curve, about where

    [[nodiscard]] bool there() const noexcept { return ts.lower <= ts.upper; }
};

// The t, of those that count, outside of which it is proven that the ray comes no nearer to the curve than the distance.
// Precondition: a curve in space.
CurvePassage passage_near(const Spline &curve, const RayQuery &query, double distance);

} // namespace nrb::intersect
