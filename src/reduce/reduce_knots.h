// SPDX-License-Identifier: MIT
// Data reduction: as few knots as a tolerance allows.
#pragma once

#include "bounds/deviation.h"

namespace nrb::reduce {

struct Reduced {
    SplinePtr spline;
    double bound; // proven bound of the distance to the given spline
};

// Removes knots of one axis, or of all (-1), which share the tolerance evenly. The result is certified
// against the given spline, the measured errors replace the accumulated estimates, and the removal is
// repeated until no knot can be removed. Throws Status::tolerance, periodic_knots, not_representable. Cost:
// nearly linear in the number of points.
Reduced reduce_knots(const SplinePtr &spline, int axis, double tolerance);

} // namespace nrb::reduce
