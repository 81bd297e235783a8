// SPDX-License-Identifier: MIT
// Splines joined end to end along an axis: the inverse of cutting.
#pragma once

#include "spline/spline.h"

#include <span>

namespace nrb::refine {

struct JoinRule {
    double tolerance; // the largest distance between ends that counts as none
    bool keep_gaps;   // ends farther apart become a jump instead of an error
};

struct Joined {
    SplinePtr spline;
    double gap; // the largest distance between control points of ends that were joined
};

// The parts one after the other, each moved in the parameter to begin where the one before ends. Inner ends
// are clamped first, and degrees raised to the highest. Where ends meet they become one layer, that of the
// earlier part, under a knot of multiplicity degree. Where they do not meet, and at degree 0, both layers
// stay, under a knot of multiplicity degree + 1. Weights of a part are multiplied by the factor that makes it
// continue the parts before. Throws Status::incompatible, gap, not_representable, and what cutting and
// elevate() throw. Precondition: at least one part, and all have the axis.
Joined join(std::span<const SplinePtr> given, int axis, JoinRule rule);

} // namespace nrb::refine
