// SPDX-License-Identifier: MIT
// Curves projected onto surfaces, along a direction or normally.
#pragma once

#include "intersect/levels/level_meet.h"
#include "numeric/vector3.h"

namespace nrb::intersect {

// Where lines along a direction through the points of a curve meet a surface: its common points with the ruled surface of these
// lines, (t, h) -> C(t) + h d / |d|, over the box of the surface. Branches are sheets: on each of them t rises, and where the surface
// folds as seen along d one ends and another one begins, in two nodes of the kind fold that go on in each other. The second domain
// is that of (t, h). Preconditions: a curve and a surface in space; d is finite and not 0; tolerance > 0, of the curves. Throws
// Status::not_representable.
Meet projected_along(const SplinePtr &curve, const Spline &surface, const Vector3 &direction,
                     double tolerance);

// All orthogonal feet of the points of a curve on a surface: S with S - C = h n, n the unit normal, likewise in sheets, which
// fold where C is in a centre of curvature. The second domain is that of (t, h). Throws Status::degree and not_representable.
Meet projected_normally(const SplinePtr &curve, const Spline &surface, double tolerance);

} // namespace nrb::intersect
