// SPDX-License-Identifier: MIT
// The kinds of splines that operations take.
#pragma once

#include "spline/spline.h"

namespace nrb::inline spline {

// The spline is argument `name`, or element `index` of it.

// A curve (1), surface (2) or volume (3), else Status::axes.
void check_kind(const Spline &spline, int axes, const char *name = "g", int64_t index = -1);
// Coordinates from `least` to `most`, else Status::dimension.
void check_dimension(const Spline &spline, int least, int most, const char *name = "g", int64_t index = -1);
// As many coordinates as `a` has, else Status::incompatible.
void check_same_dimension(const Spline &a, const Spline &b);

} // namespace nrb::inline spline
