// SPDX-License-Identifier: MIT
// The seam of a periodic axis: removing it, and moving it.
#pragma once

#include "refine/knots/axis_table.h"

namespace nrb::refine {

// The same knots and layers on an axis that is no longer declared periodic.
SplinePtr open_axis(const SplinePtr &spline, int axis);

// The same shape on a periodic axis with the domain [seam, seam + period]. The seam becomes a knot if it is
// not one. Preconditions: the axis is periodic, domain.lower <= seam <= domain.upper. Throws
// Status::periodic_knots if rounding would make distinct knots equal or equal ones distinct, and what
// refine_axis() throws.
SplinePtr move_seam(const SplinePtr &spline, int axis, double seam);

} // namespace nrb::refine
