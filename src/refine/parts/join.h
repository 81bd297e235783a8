// SPDX-License-Identifier: MIT
// Splines joined end to end along an axis: the inverse of cutting.
#pragma once

#include "spline/spline.h"

#include <span>

namespace nrb::refine {

struct JoinRule {
    double tolerance; // the largest distance at which ends meet
    bool keep_gaps;   // ends that do not meet become a jump, not an error
};

struct Joined {
    SplinePtr spline;
    double gap; // the largest distance between control points of adjacent ends
};

// Joins the parts in their order. Each is shifted in the parameter to begin where the part before it ends.
// Ends to be joined are clamped first, and degrees are raised to the highest. Where two ends meet they become
// one layer, that of the earlier part, under a knot of multiplicity `degree`, and the weights of the later
// part are multiplied by the factor that makes them continue those of the earlier one. Where they do not
// meet, and at degree 0, both layers stay, under a knot of multiplicity degree + 1. Throws
// Status::incompatible, gap, knots_merge, not_representable, and what cutting and elevate() throw.
// Precondition: there is at least one part, and all parts have the axis.
Joined join(std::span<const SplinePtr> given, int axis, JoinRule rule);

} // namespace nrb::refine
