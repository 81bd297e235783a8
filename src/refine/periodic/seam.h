// SPDX-License-Identifier: MIT
// The seam of a periodic axis: where it lies, and whether the axis has one.
#pragma once

#include "refine/knots/axis_table.h"

namespace nrb::refine {

// The same knots and layers, no longer declared periodic.
SplinePtr open_axis(const SplinePtr &spline, int axis);

// The same shape on a periodic axis with the domain [seam, seam + period]; the seam becomes a knot if it is
// not one. Preconditions: the axis is periodic, domain.lower <= seam <= domain.upper. Throws
// Status::periodic_knots if rounding would merge distinct knots, and what refine_axis() throws.
SplinePtr move_seam(const SplinePtr &spline, int axis, double seam);

} // namespace nrb::refine
