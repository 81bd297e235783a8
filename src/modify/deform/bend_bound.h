// SPDX-License-Identifier: MIT
// How far a spline is at most from the exact bend of another one.
#pragma once

#include "modify/deform/bend.h"

namespace nrb::modify {

// A bound of |image(t) - F(g(t))| for an image over the knots and with the weights of g; infinite where the
// weights are not shown to be positive. Spans of cells that cross an end of the bent part and have a bound
// above the tolerance are to be cut.
//
// On a cell, one span of every axis, with numerators A, w of g and B of the image, E = w F(A / w) - B is
// interpolated at the nodes of each axis (LocalNodes): along one axis of degree p
//
//     |E| <= Lambda max |E(node)| + max|omega| sup |E^(p+1)| / (p + 1)!,
//
// with the Lebesgue constant Lambda <= 1 + 2 / pi log(p + 1) of Chebyshev's points with the ends (L.
// Trefethen, "Approximation theory and approximation practice", theorem 15.2) and |omega| <= 4^-p on a span
// of length 1; the kernel of the remainder has one sign, so that this holds for vectors. On several axes the
// remainders of the later ones are multiplied by the Lambda of those before. B and the coordinates that stay
// drop out of the derivative, and that of the two others is the derivative of (w / k + w b) exp(i k a) along
// the axis. Its Taylor coefficients are at most those of a product of series of which each bounds a factor at
// every point of the cell: the differences of Bernstein coefficients bound derivatives of polynomials, a - a0
// = ((A - a0 w) / w) has coefficients at most those of the quotient with a series for w of least value minus
// the rest, and those of exp(i k (a - a0)) are at most those of exp(|k| ...). Beyond the ends of the bent
// part F is affine and there is no remainder; where a cell crosses an end by d, one formula is bounded on the
// whole cell and their difference added, |k| d (|b| + d / 2) at most. For the rounding of all this 2^12 eps
// of the largest distance from the origin of the bend is added. Cost: of the order of the evaluation at the
// nodes.
double bend_bound(const Spline &g, const Spline &image, const Bend &bend, double tolerance, fit::Cuts &cuts);

} // namespace nrb::modify
