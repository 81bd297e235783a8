// SPDX-License-Identifier: MIT
// Snaps nearly equal knots of one spline together.
#pragma once

#include "refine/knots/axis_table.h"

namespace nrb::reduce {

struct Snapped {
    SplinePtr spline;
    double deviation; // an upper bound, see deviation_bound(); 0 if no knot moved
};

// Clusters of knots of a width of at most tolerance * (length of the domain), see KnotClusters, become single
// knots. Control points stay, except those that moved_axis() drops. Throws Status::tolerance unless 0
// <= tolerance < 1; multiplicity, and what refinement throws.
Snapped snap_knots(const SplinePtr &spline, int axis, double tolerance);

// Throws Status::tolerance unless 0 <= tolerance < 1.
void check_relative_tolerance(double tolerance);

// Puts the layers of a moved axis over that axis; the caller has to run check_spline().
SplinePtr over_axis(const Spline &spline, int k, const refine::AxisTable &moved);

} // namespace nrb::reduce
