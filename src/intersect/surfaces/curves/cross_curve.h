// SPDX-License-Identifier: MIT
// Cubic splines along chains of common arcs.
#pragma once

#include "intersect/surfaces/cross_chains.h"
#include "intersect/surfaces/curves/cross_segment.h"

namespace nrb::intersect {

// Cubic splines with the same knots, parametrized by about the arc length in space: the curve in space, and
// those in both parameter domains, which may run into neighbouring periods.
struct CrossCurve {
    SplinePtr space;
    std::array<SplinePtr, 2> on;
    double deviation; // of all three, in space
};

// A branch of level 0 along a curve.
MeetBranch branch_along(CrossCurve curve, const std::array<int64_t, 2> &nodes, int64_t loop, BranchKind kind);

CrossCurve cross_curve(const pieces::Frame &frame, const CrossSurface &a, const CrossSurface &b,
                       std::vector<CrossSegment> segments, bool closed);
CrossCurve cross_curve(CrossFitter &fitter, const pieces::Frame &frame, const CrossSurface &a,
                       const CrossSurface &b, const CrossParts &found, const CrossChain &chain);

} // namespace nrb::intersect
