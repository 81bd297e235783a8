// SPDX-License-Identifier: MIT
// Derivatives of polynomial splines as splines (hodographs).
#pragma once

#include "spline/spline.h"

#include <cstdint>

namespace nrb::refine {

// The derivative of a polynomial spline along an axis. Its control points are p (P_(i+1) - P_i) / (t_(i+p+1)
// - t_(i+1)), over the knots without the first and the last one (de Boor 1972; Piegl & Tiller 3.3), each with
// a relative error of at most 2 eps. Where a knot occurs p + 1 times, one of its copies is dropped, with the
// layer whose support would be empty, between the two pieces. If the order exceeds the degree, the result is
// zero, of degree 0 over the same breaks. Throws Status::not_representable, periodic_knots. Preconditions:
// the spline is polynomial, order >= 0. Cost: for each order, linear in the number of points.
SplinePtr polynomial_derivative(const SplinePtr &spline, int axis, int order);

} // namespace nrb::refine
