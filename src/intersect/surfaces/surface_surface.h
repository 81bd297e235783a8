// SPDX-License-Identifier: MIT
// Where two surfaces meet, or one meets itself.
#pragma once

#include "intersect/levels/level_meet.h"

namespace nrb::intersect {

// Whether regions in which surfaces are one are told as such; if not, they are left open.
enum class Regions : bool { open, told };

// Preconditions: surfaces in space; tolerance > 0, of the curves.
Meet surface_intersections(const Spline &a, const Spline &b, double tolerance,
                           Regions regions = Regions::open);

// At places that are not one and the same: either there is nothing and the meet is complete, so that the surface is simple, or
// branches are along all of that, each told once. Regions are left open.
Meet surface_self_intersections(const Spline &g, double tolerance);

// The domains of axes that are periodic.
std::array<std::optional<Interval>, 2> periodic_axes_of(const Spline &surface);

} // namespace nrb::intersect
