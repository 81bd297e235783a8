// SPDX-License-Identifier: MIT
// Curves of feet.
#pragma once

#include "intersect/levels/level_meet.h"

namespace nrb::intersect {

// Branches along which C(t) - S(u, v) is orthogonal to S, over (u, v) and (t, h), h the signed distance; t may rise and fall on them.
// lines: distance_lines() of the curve. Preconditions: as for projected_normally().
Meet feet_curves(const SplinePtr &curve, const Spline &surface, const Spline &lines, double tolerance);

} // namespace nrb::intersect
