// SPDX-License-Identifier: MIT
// Knot removal within a tolerance.
#pragma once

#include "bounds/deviation.h"
#include "refine/knots/axis_table.h"

namespace nrb::reduce {

// The axis with one copy less of a knot (on a periodic axis: of all its copies a period away), and the layers
// of the closest spline, computed from local layers. The pointer is empty if there is none: on a periodic
// axis of no more than degree - multiplicity + 1 distinct layers. Preconditions: the knot lies inside the
// domain, or is the start of a periodic one and occurs there more than once. Throws Status::periodic_knots.
refine::AxisTable without_knot(const KnotVector &axis, double knot);

// The spline over the other axis, with 0 for weights that are 0 to rounding; null if its weights are not
// allowed. Throws Status::not_representable, overflow.
SplinePtr with_axis_if_valid(const Spline &spline, int k, const refine::AxisTable &made);

struct KnotRemoval {
    SplinePtr spline;
    int64_t removed;
    double bound; // proven, of the distance to the given spline
};

// Removes up to `times` copies, as long as the bound is at most the tolerance. Throws
// Status::parameter_not_finite, outside_domain, not_a_knot, end_knot, times, tolerance.
KnotRemoval remove_knot(const SplinePtr &spline, int axis, double knot, int64_t times, double tolerance);

} // namespace nrb::reduce
