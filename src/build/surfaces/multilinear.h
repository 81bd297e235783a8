// SPDX-License-Identifier: MIT
// Patches that are straight along every axis.
#pragma once

#include "base/records.h"
#include "spline/spline.h"

namespace nrb::build {

// The patch of degree 1 on all axes over 2^axes corners, last axis fastest. Throws
// Status::point_not_finite.
SplinePtr multilinear(int axes, const ConstRecords &corners);

// origin + s u + t v, with corners rounded once; origin may be null. Throws Status::dimension and
// point_not_finite; direction for sides that are 0, not finite or, to within 4 eps of the angle's sine,
// parallel; not_representable.
SplinePtr parallelogram(int dim, const double *origin, const double *u, const double *v);

} // namespace nrb::build
