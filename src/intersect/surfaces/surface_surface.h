// SPDX-License-Identifier: MIT
// Where two surfaces meet.
#pragma once

#include "intersect/levels/level_meet.h"

namespace nrb::intersect {

// Preconditions: surfaces in space; tolerance > 0, of the curves.
Meet surface_intersections(const Spline &a, const Spline &b, double tolerance);

} // namespace nrb::intersect
