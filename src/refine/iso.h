// Iso-curves of surfaces and iso-surfaces of volumes.
#pragma once

#include "eval/parameters.h"

namespace nrb {

// The spline over the other axes on which `axis` is fixed at a parameter. Throws Error: NURBS_ERROR_AXES for
// a curve, NURBS_ERROR_FLAGS for a rule that gives NaN, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN,
// _NOT_REPRESENTABLE, and the statuses of check_spline() when extrapolation leaves the positive weights.
SplinePtr iso(const Spline &spline, int axis, double t, const AxisRule &rule);

} // namespace nrb
