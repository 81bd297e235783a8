// SPDX-License-Identifier: MIT
// Intersection curves of two surfaces, and self-intersections of one.
#pragma once

#include "intersect/levels/level_meet.h"

namespace nrb::intersect {

// Whether regions in which surfaces coincide are reported as such, or left open.
enum class Regions : bool { open, told };

// Preconditions: surfaces in space; tolerance > 0, of the curves.
Meet surface_intersections(const Spline &a, const Spline &b, double tolerance,
                           Regions regions = Regions::open);

// Self-intersections are common points at two different places. Either there are none and the meet is
// complete, which proves that the surface is simple, or branches run along all of them, each reported once.
// Regions in which the surface coincides with itself are left open.
Meet surface_self_intersections(const Spline &g, double tolerance);

// [axis]: the domain, if the axis is periodic.
std::array<std::optional<Interval>, 2> periodic_axes_of(const Spline &surface);

} // namespace nrb::intersect
