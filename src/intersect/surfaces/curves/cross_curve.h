// SPDX-License-Identifier: MIT
// Splines along chains of common arcs.
#pragma once

#include "intersect/surfaces/cross_chains.h"
#include "intersect/surfaces/curves/cross_segment.h"

namespace nrb::intersect {

// Cubics with the same knots, whose parameter is about the length in space: in space, and in the parameter domains, where
// they may run into neighbouring periods.
struct CrossCurve {
    SplinePtr space;
    std::array<SplinePtr, 2> on;
    double deviation; // of all, in space
};

// A branch along it, of level 0.
MeetBranch branch_along(CrossCurve curve, const std::array<int64_t, 2> &nodes, int64_t loop, BranchKind kind);

CrossCurve cross_curve(const pieces::Frame &frame, const CrossSurface &a, const CrossSurface &b,
                       std::vector<CrossSegment> segments, bool closed);
CrossCurve cross_curve(CrossFitter &fitter, const pieces::Frame &frame, const CrossSurface &a,
                       const CrossSurface &b, const CrossParts &found, const CrossChain &chain);

} // namespace nrb::intersect
