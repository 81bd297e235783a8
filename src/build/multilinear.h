// Patches that are straight along every axis.
#pragma once

#include "base/records.h"
#include "spline/spline.h"

namespace nrb {

// The patch of degree 1 on all axes over 2^axes corners, last axis fastest. Throws
// NURBS_ERROR_POINT_NOT_FINITE.
SplinePtr multilinear(int axes, const ConstRecords &corners);

// origin + s u + t v, its corners rounded once; origin may be null. Throws NURBS_ERROR_DIMENSION,
// _POINT_NOT_FINITE, _DIRECTION for sides that are 0, not finite or, to within 4 eps of the angle's sine,
// parallel, _NOT_REPRESENTABLE.
SplinePtr parallelogram(int dim, const double *origin, const double *u, const double *v);

} // namespace nrb
