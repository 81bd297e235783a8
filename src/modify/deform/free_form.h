// SPDX-License-Identifier: MIT
// Free-form deformation (T. Sederberg, S. Parry, "Free-form deformation of solid geometric models", SIGGRAPH
// 1986).
#pragma once

#include "modify/deform/bend.h"

namespace nrb::modify {

// The image of g under x -> V(A x), where A maps the box affinely to the domain of the volume V. If g is a
// polynomial curve in the plane or in space, and the exact image has a degree of at most max_degree, the
// exact image is computed by composition (refine/compose/compose.h). The bound of the distance from it is
// then proven, apart from the rounding of its control points, for which 64 eps of the size of the volume are
// added for each degree, and that of parameters, for which 8 eps of theirs are added for each degree, times
// the derivatives of V. Otherwise the distance is that of samples. Throws Status::outside_domain if a point
// is outside the box, and what fit_image() and compose() throw. Preconditions: the volume has as many axes as
// both have dimensions; lower < upper.
DeformedShape free_form_deform(const SplinePtr &spline, const SplinePtr &volume, const double *lower,
                               const double *upper, double tolerance);

} // namespace nrb::modify
