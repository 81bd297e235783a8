// SPDX-License-Identifier: MIT
// A proven bound of the distance between a spline and the exact bend of another one.
#pragma once

#include "modify/deform/bend.h"

namespace nrb::modify {

// A bound of |image(t) - F(g(t))|, F being the bend, for an image over the knots and with the weights of g;
// infinite where the weights are not shown to be positive. `cuts` receives the spans to be cut: those of
// cells that cross an end of the bent part and have a bound above the tolerance.
//
// A cell is one span of every axis. On a cell let A, w be the numerators and the weight of g, and B the
// numerators of the image. E = w F(A / w) - B is compared with its interpolant at the nodes of each axis
// (LocalNodes). Along one axis of degree p,
//
//     |E| <= Lambda max |E(node)| + max|omega| sup |E^(p+1)| / (p + 1)!,
//
// where the Lebesgue constant of the Chebyshev-Lobatto points is Lambda <= 1 + 2 / pi log(p + 1) (L.
// Trefethen, "Approximation theory and approximation practice", theorem 15.2), and the node polynomial omega
// has |omega| <= 4^-p on a span of length 1. The kernel of the remainder has one sign, so this holds for
// vectors. On several axes, the remainders of the later axes are multiplied by the Lambda of those before.
//
// It remains to bound the derivative of order p + 1 along an axis. B and the coordinates that the bend does
// not change drop out of it. That of the other two coordinates is the derivative of (w / k + w b) exp(i k a),
// whose Taylor coefficients are at most those of a product of series, each of which bounds one factor at
// every point of the cell. Differences of Bernstein coefficients bound the derivatives of polynomials. For a
// - a0 = (A_a - a0 w) / w, A_a being the numerator of a, the series is a quotient: that of A_a - a0 w over
// the least value of w minus the other terms of the series of w. For exp(i k (a - a0)) it is exp of |k| times
// that quotient.
//
// Beyond the ends of the bent part F is affine, and there is no remainder. Where a cell crosses an end by a
// distance d, the formula of one part is bounded on the whole cell, and a bound of the difference of the
// formulas, |k| d (|b| + d / 2), is added. For the rounding of all this, 2^12 eps of the size of the
// coordinates is added, times the ratio of the weights of the cell and 1 + |k| times the distance of g from
// the curve b = 0 bent. Cost: of the order of the evaluation at the nodes.
double bend_bound(const Spline &g, const Spline &image, const Bend &bend, double tolerance, fit::Cuts &cuts);

} // namespace nrb::modify
