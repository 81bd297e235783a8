// SPDX-License-Identifier: MIT
// On which side of a surface a curve lies.
#pragma once

#include "intersect/curve_surface/meet_groups.h"

namespace nrb::intersect {

// Whether the curve is on different sides of the surface before and after a group, each time at the first
// sample that is farther from it than rounding can tell. reach: how far the curve goes in the group.
bool changes_side(const Spline &curve, const Spline &surface, const Seams &seams, const MeetGroup &group,
                  double reach, double noise);

} // namespace nrb::intersect
