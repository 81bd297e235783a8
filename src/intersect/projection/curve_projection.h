// SPDX-License-Identifier: MIT
// Curves projected onto surfaces, along a direction or normally.
#pragma once

#include "intersect/levels/level_meet.h"
#include "numeric/vector3.h"

namespace nrb::intersect {

// Projection along a direction d: the intersection of the surface with the ruled surface
// (t, h) -> C(t) + h d / |d| of the lines along d through the points of the curve C, for all h that lead into
// the bounding box of the surface. The branches are sheets: t rises along each of them. Where the surface
// folds as seen along d, one sheet ends and another begins, in two nodes of kind fold, each the continuation
// of the other. The second domain of the meet is that of (t, h). Preconditions: the curve and the surface are
// in space; d is finite and not 0; tolerance > 0, for the deviation of the resulting curves. Throws
// Status::not_representable.
Meet projected_along(const SplinePtr &curve, const Spline &surface, const Vector3 &direction,
                     double tolerance);

// Normal projection: all orthogonal feet S of the points C(t) of a curve on a surface, S - C = h n with n the
// unit normal of the surface and h the signed distance. The branches are sheets here too; they fold where
// C(t) is a centre of curvature of the surface at the foot. The second domain is that of (t, h). Throws
// Status::degree and not_representable.
Meet projected_normally(const SplinePtr &curve, const Spline &surface, double tolerance);

} // namespace nrb::intersect
