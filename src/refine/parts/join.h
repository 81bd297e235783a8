// Splines joined end to end along an axis: the inverse of cutting.
#pragma once

#include "spline/spline.h"

#include <span>

namespace nrb::refine {

struct JoinRule {
    double tolerance; // largest distance between ends that counts as none
    bool keep_gaps;   // ends farther apart become a jump, in place of an error
};

struct Joined {
    SplinePtr spline;
    double gap; // largest distance between control points of ends that were joined
};

// The parts one after the other, each moved in the parameter to begin where the one before ends. Inner ends
// are clamped first, and degrees raised to the highest. Where ends meet they become one layer, that of the
// earlier part, under a knot of multiplicity degree; where they do not, and at degree 0, both stay, under one
// of degree + 1. Weights of a part are multiplied by the factor that makes its end carry on those before.
// Throws Status::incompatible, gap, not_representable, and what cutting and elevate() throw.
// Precondition: at least one part, and all have the axis.
Joined join(std::span<const SplinePtr> given, int axis, JoinRule rule);

} // namespace nrb::refine
