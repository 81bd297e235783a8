// SPDX-License-Identifier: MIT
// Knot removal within a tolerance.
#pragma once

#include "bounds/deviation.h"
#include "refine/knots/axis_table.h"

namespace nrb::reduce {

// The axis with one copy of a knot less (on a periodic axis: and of its copies a period away), and the layers
// of the closest spline, computed locally. The pointer is empty if there is none: on a periodic axis with at
// most degree - multiplicity + 1 distinct layers. Preconditions: the knot lies inside the domain, or is the
// start of a periodic domain and occurs there more than once. Throws Status::periodic_knots.
refine::AxisTable without_knot(const KnotVector &axis, double knot);

// The spline over the new axis; weights that are 0 up to rounding become 0. Null if its weights are not
// allowed. Throws Status::not_representable, overflow.
SplinePtr with_axis_if_valid(const Spline &spline, int k, const refine::AxisTable &made);

struct KnotRemoval {
    SplinePtr spline;
    int64_t removed;
    double bound; // proven bound of the distance to the given spline
};

// Removes up to `times` copies, as long as the bound is at most the tolerance. Throws
// Status::parameter_not_finite, outside_domain, not_a_knot, end_knot, times, tolerance.
KnotRemoval remove_knot(const SplinePtr &spline, int axis, double knot, int64_t times, double tolerance);

} // namespace nrb::reduce
