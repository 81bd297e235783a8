// Degree elevation.
#pragma once

#include "refine/axis_table.h"

namespace nrb {

// The axis with its degree raised, and the table for all stored layers. Throws NURBS_ERROR_PERIODIC_KNOTS,
// _NOT_REPRESENTABLE. Precondition: 0 < times <= NURBS_MAX_DEGREE - degree.
AxisTable elevate_axis(const KnotVector &axis, int64_t times);

// The same shape with the degree of an axis raised by `times`. The tables of the steps are composed and
// applied once. Throws NURBS_ERROR_TIMES, _DEGREE beyond NURBS_MAX_DEGREE, _PERIODIC_KNOTS,
// _NOT_REPRESENTABLE, _WEIGHTS_VANISH, _OVERFLOW. Cost: linear in the number of points.
SplinePtr elevate(const SplinePtr &spline, int axis, int64_t times);

} // namespace nrb
