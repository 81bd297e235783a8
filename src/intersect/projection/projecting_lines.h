// SPDX-License-Identifier: MIT
// The ruled surface of the lines along one direction through the points of a curve.
#pragma once

#include "numeric/vector3.h"
#include "spline/spline.h"

namespace nrb::intersect {

struct ProjectingLines {
    Vector3 direction; // of length 1
    // (t, h) -> C(t) + h direction; axis 1 covers, with a margin, all h that lead into the bounding box of
    // the other surface.
    SplinePtr surface;
    double rounding; // how far rounding of the control points may move its points
};

// Preconditions: as for projected_along(). Throws Status::not_representable.
ProjectingLines projecting_lines(const SplinePtr &curve, const Spline &surface, const Vector3 &direction);

// A ruled surface over (t, h) that serves as the second domain of normal projection: the range of h covers
// all signed distances between points of the curve and of the surface. The direction of its lines is
// arbitrary. Throws Status::not_representable.
SplinePtr distance_lines(const SplinePtr &curve, const Spline &surface);

} // namespace nrb::intersect
