// SPDX-License-Identifier: MIT
// Derivatives of rational splines as rational splines, by the quotient rule.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// The derivative of order n of A / w along an axis. It is N_n / w^(n+1) with N_0 = A and
//
//     N_(n+1) = N_n' w - (n + 1) N_n w',
//
// of degree (n + 1) p on every axis. Numerator and denominator are written over the same knots, which on the
// axis of differentiation have n more copies than w^(n+1) needs. If the degree on that axis is 0, the result
// is a polynomial spline that is zero. Throws Status::degree, periodic_knots, not_representable, overflow.
// Preconditions: the spline is rational, order >= 1.
SplinePtr rational_derivative(const Spline &given, int axis, int order);

} // namespace nrb::refine
