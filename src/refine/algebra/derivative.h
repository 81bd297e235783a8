// SPDX-License-Identifier: MIT
// Derivatives of splines as splines.
#pragma once

#include "spline/spline.h"

#include <cstdint>

namespace nrb::refine {

// The derivative of a polynomial spline along an axis: control points p (P_(i+1) - P_i) / (t_(i+p+1) -
// t_(i+1)) over the knots without the first and the last one (de Boor 1972; Piegl & Tiller 3.3), each within
// 2 eps of itself. Where a knot occurs p + 1 times one copy and the layer between the two pieces drop out.
// Beyond the degree: zeros over the same breaks, of degree 0. Throws Status::not_representable,
// periodic_knots. Preconditions: polynomial, order >= 0. Cost: linear in the number of points, for each
// order.
SplinePtr polynomial_derivative(const SplinePtr &spline, int axis, int order);

} // namespace nrb::refine
