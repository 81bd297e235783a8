// Several periods of a periodic axis as a plain one.
#pragma once

#include "spline/spline.h"

#include <cstdint>

namespace nrb {

// The spline over its domain and `periods` periods on either side of it, not clamped. Preconditions: the axis is
// periodic, periods >= 0. Throws NURBS_ERROR_PERIODIC_KNOTS if rounding makes too many knots equal,
// _NOT_REPRESENTABLE, _OVERFLOW.
SplinePtr unrolled(const SplinePtr &spline, int axis, int64_t periods);

} // namespace nrb
