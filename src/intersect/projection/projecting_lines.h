// SPDX-License-Identifier: MIT
// The ruled surface of the lines along a direction through the points of a curve.
#pragma once

#include "numeric/vector3.h"
#include "spline/spline.h"

namespace nrb::intersect {

struct ProjectingLines {
    Vector3 direction; // of length 1
    SplinePtr
        surface; // (t, h) -> C(t) + h direction, axis 1 over all h that may lead into the box of the other surface, and more
    double rounding; // how far its points are from that
};

// Throws Status::not_representable. Preconditions as for projected_along().
ProjectingLines projecting_lines(const SplinePtr &curve, const Spline &surface, const Vector3 &direction);

// Lines through the points of a curve, all along one direction: (t, h) with all h that may be a distance from the other surface,
// of either sign. Throws Status::not_representable.
SplinePtr distance_lines(const SplinePtr &curve, const Spline &surface);

} // namespace nrb::intersect
