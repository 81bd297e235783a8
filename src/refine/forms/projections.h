// SPDX-License-Identifier: MIT
// Reflections and projections, as affine and projective maps.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// All arrays have the dimension of the spline. Throws Status::direction for a normal of 0, a direction
// parallel to the plane, or an eye in the plane, the latter two to within rounding, and what the functions in
// transform.h throw.
SplinePtr mirror(const Spline &spline, const double *point, const double *normal);
// With a null direction, the projection is along the normal.
SplinePtr project_to_plane(const Spline &spline, const double *point, const double *normal,
                           const double *direction);
SplinePtr project_from(const Spline &spline, const double *eye, const double *point, const double *normal);

} // namespace nrb::refine
