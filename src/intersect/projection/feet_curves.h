// SPDX-License-Identifier: MIT
// Curves of the orthogonal feet of a curve on a surface.
#pragma once

#include "intersect/levels/level_meet.h"

namespace nrb::intersect {

// The branches along which C(t) - S(u, v) is orthogonal to the surface, over (u, v) and (t, h), where h is
// the signed distance. They are not yet cut into sheets: t may rise and fall along a branch.
// lines: distance_lines() of the curve. Preconditions: as for projected_normally().
Meet feet_curves(const SplinePtr &curve, const Spline &surface, const Spline &lines, double tolerance);

} // namespace nrb::intersect
