// SPDX-License-Identifier: MIT
// Parametric and geometric continuity of a spline at its knots, and of two curves where they meet.
#pragma once

#include "closest/curve_side.h"

namespace nrb::analysis {

struct ContinuityRule {
    double position;   // largest distance that counts as 0
    double derivative; // largest relative difference of derivatives and of curvatures
    double angle;      // largest angle that counts as 0
};

// Gaps that are not defined are NaN.
struct Continuity {
    int order;     // C^order, at most the degree; -1: a jump
    int geometric; // G^geometric, at most 2; -1: a jump
    double position_gap;
    double angle;
    double curvature_gap;
};

struct KnotContinuity {
    double knot;
    int knot_order; // degree - multiplicity of the knot; -1 at the seam if not periodic
    Continuity found;
};

// Compares the derivatives on the two sides of a place, both in the same direction of travel.
Continuity continuity(const closest::CurveSide &before, const closest::CurveSide &after,
                      const ContinuityRule &rule);

// The continuity at the distinct knots inside the domain of an axis, and at its seam, reported with the upper
// end of the domain, if the axis is periodic or its ends meet. For a surface or volume: the worst over
// samples at degree + 1 places in each span of every other axis. Cost: for a curve O(degree^2) per knot.
std::vector<KnotContinuity> continuity(const SplinePtr &spline, int axis, const ContinuityRule &rule);

// The continuity from an end of curve a (its upper one if upper_a) to an end of curve b, with the direction
// of travel from a to b. Throws Status::axes, incompatible.
Continuity continuity_between(const Spline &a, bool upper_a, const Spline &b, bool upper_b,
                              const ContinuityRule &rule);

} // namespace nrb::analysis
