// Between a rational spline and the polynomial one of its homogeneous points.
#pragma once

#include "spline/spline.h"

namespace nrb {

// (w x, w y, ..., w) of every control point, unscaled; w = 1 in a polynomial spline.
std::vector<double> homogeneous_points(const Spline &spline);

// A polynomial spline with weights of 1, any other as it is.
SplinePtr make_rational(const SplinePtr &spline);

// Throws NURBS_ERROR_DIMENSION, _OVERFLOW.
SplinePtr to_homogeneous(const Spline &spline);

// Throws NURBS_ERROR_RATIONAL, _DIMENSION, _WEIGHTS_VANISH.
SplinePtr from_homogeneous(const Spline &spline);

} // namespace nrb
