// SPDX-License-Identifier: MIT
// Checks that operations make of their arguments: the numbers of axes and of coordinates.
#pragma once

#include "spline/spline.h"

namespace nrb::inline spline {

// In messages the spline is argument `name`, or element `index` of it.

// Throws Status::axes unless the spline is a curve (1), surface (2) or volume (3), as `axes` says.
void check_kind(const Spline &spline, int axes, const char *name = "g", int64_t index = -1);
// Throws Status::dimension unless the spline has `least` to `most` coordinates.
void check_dimension(const Spline &spline, int least, int most, const char *name = "g", int64_t index = -1);
// Throws Status::incompatible unless b has as many coordinates as a.
void check_same_dimension(const Spline &a, const Spline &b);

} // namespace nrb::inline spline
