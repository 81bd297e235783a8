// SPDX-License-Identifier: MIT
// Derivatives of splines by a knot, as splines.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// The derivative of a polynomial spline by knot k of an axis, with its copies in other periods if the axis is
// periodic. D. Jupp, "Approximation to data by splines with free knots", SIAM J. Numer. Anal. 15 (1978): over
// the knots with t_k once more, control points
//
//     -(P_i - P_(i-1)) / (t_(i+p) - t_i),   i = k - p, ..., k,
//
// and zeros. Layers without influence on the domain are left out with their knots: the first one for k <= p,
// the last one for k >= count, and the one whose support would be empty where t_k occurs p + 1 times already.
// On a periodic axis the sum for all copies. Degree 0: zeros. Throws Status::not_representable,
// periodic_knots.
SplinePtr polynomial_knot_derivative(const SplinePtr &spline, int axis, int64_t k);

// The same of a rational spline A / w, by the quotient rule: (A_k w - A w_k) / w^2, of degree 2 p on every
// axis. Throws Status::degree, periodic_knots, not_representable, overflow.
SplinePtr rational_knot_derivative(const Spline &given, int axis, int64_t k);

} // namespace nrb::refine
