// SPDX-License-Identifier: MIT
// Derivatives of rational splines as rational splines.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// The derivative of order n = order of A / w along an axis is N_n / w^(n+1) with N_0 = A and
//
//     N_(n+1) = N_n' w - (n + 1) N_n w',
//
// of degree (n + 1) p on every axis. Numerator and denominator are brought to the same knots, on the axis of
// differentiation n more copies of each than w^(n+1) needs. Degree 0: a polynomial spline of zeros. Throws
// Status::degree, periodic_knots, not_representable, overflow. Preconditions: rational, order >= 1.
SplinePtr rational_derivative(const Spline &given, int axis, int order);

} // namespace nrb::refine
