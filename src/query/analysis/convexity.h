// Whether a plane curve is convex.
#pragma once

#include "spline/spline.h"

#include <cstdint>

namespace nrb {

// One of the NURBS_CONVEXITY_ constants, to rounding: from the sign of the curvature, the turns at knots, the
// zeros of the tangent, and the angle that it turns through, piece by piece. Throws
// NURBS_ERROR_NOT_REPRESENTABLE. Precondition: a curve of dimension 2.
int32_t convexity(const Spline &curve);

} // namespace nrb
