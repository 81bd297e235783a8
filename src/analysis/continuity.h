// SPDX-License-Identifier: MIT
// How smooth a spline is at its knots, and how smoothly two curves meet.
#pragma once

#include "closest/curve_side.h"

namespace nrb::analysis {

struct ContinuityRule {
    double position; // largest distance that counts as none
    double
        derivative; // largest difference of derivatives, relative to the larger of the two, and of curvatures
    double angle;   // largest angle that counts as none
};

// -1: a jump. Gaps that are not defined are NaN.
struct Continuity {
    int order;     // C^order, at most the degree
    int geometric; // G^geometric, at most 2
    double position_gap;
    double angle;
    double curvature_gap;
};

struct KnotContinuity {
    double knot;
    int knot_order; // what the knots guarantee: degree - multiplicity; -1 at the seam of a plain axis
    Continuity found;
};

// Two sides of one place, both run through in the same direction.
Continuity continuity(const closest::CurveSide &before, const closest::CurveSide &after,
                      const ContinuityRule &rule);

// At the distinct knots inside the domain of an axis, and at its seam, named by the upper end, if the axis is
// periodic or its ends meet. For a surface or volume: the worst of degree + 1 places in each span of every
// other axis. Cost: for a curve O(degree^2) for each knot.
std::vector<KnotContinuity> continuity(const SplinePtr &spline, int axis, const ContinuityRule &rule);

// The end of curve a (its upper one if upper_a) and that of curve b, run through from a to b. Throws
// Status::axes, incompatible.
Continuity continuity_between(const Spline &a, bool upper_a, const Spline &b, bool upper_b,
                              const ContinuityRule &rule);

} // namespace nrb::analysis
