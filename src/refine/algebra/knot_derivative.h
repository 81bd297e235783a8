// SPDX-License-Identifier: MIT
// Derivatives of splines with respect to a knot, as splines.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// The derivative of a polynomial spline with respect to knot k of an axis; on a periodic axis the copies of
// the knot in all periods move with it. By D. Jupp, "Approximation to data by splines with free knots", SIAM
// J. Numer. Anal. 15 (1978), it is a spline over the knots with t_k doubled, with the control points
//
//     -(P_i - P_(i-1)) / (t_(i+p) - t_i),   i = k - p, ..., k,
//
// and zeros elsewhere. Layers without influence on the domain are omitted together with a knot: the first
// layer for k <= p, the last layer for k >= count, or the layer whose support is empty because t_k already
// occurs p + 1 times. On a periodic axis the result is the sum over all copies of the knot. At degree 0 it is
// zero. Throws Status::not_representable, periodic_knots.
SplinePtr polynomial_knot_derivative(const SplinePtr &spline, int axis, int64_t k);

// The same for a rational spline A / w, by the quotient rule: (A_k w - A w_k) / w^2, where A_k and w_k are
// the derivatives with respect to the knot. The degree is 2 p on every axis. Throws Status::degree,
// periodic_knots, not_representable, overflow.
SplinePtr rational_knot_derivative(const Spline &given, int axis, int64_t k);

} // namespace nrb::refine
