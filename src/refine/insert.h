// Knot insertion, and what follows from it alone.
#pragma once

#include "spline/spline.h"

namespace nrb {

// Inserts `knot` `times` times along an axis (Boehm 1980). Throws Error: NURBS_ERROR_PARAMETER_NOT_FINITE,
// _OUTSIDE_DOMAIN, _TIMES, _MULTIPLICITY, _OVERFLOW. Cost O(degree * times) for the coefficients and
// O(points) to copy the rest.
SplinePtr insert_knot(const SplinePtr &spline, int axis, double knot, int64_t times);

// The part of a spline over [lower, upper] of an axis, clamped at both new ends; an end that is an end of the
// domain is left as it is. Precondition: domain.lower <= lower < upper <= domain.upper.
SplinePtr restrict_axis(const SplinePtr &spline, int axis, double lower, double upper);

} // namespace nrb
