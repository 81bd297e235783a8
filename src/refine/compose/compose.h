// SPDX-License-Identifier: MIT
// Splines of splines: a curve over another parameter, and curves that lie on surfaces and in volumes.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// The curve g(f(t)) for a curve f in the parameter space of g. f is polynomial or has positive weights. The
// result has degree q * (the sum of the degrees of g) and is clamped. It has knots where f has knots and
// where f crosses knots of g, as often as the continuity requires.
//
// Let G be the polar form of g and F that of f. A control point is the mean of G(F(t_I1), F(t_I2), ...) over
// all ways to distribute the knots that belong to it among the arguments of G, q to each (T. DeRose, R.
// Goldman, H. Hagen, S. Mann, "Functional composition algorithms via blossoming", ACM Trans. Graphics 12
// (1993)). A knot of f of multiplicity m inside the window occurs d - q + m times in it, so that each choice
// of q has m of its copies. Where f crosses a knot of g of multiplicity m on an axis of degree p, the
// crossing occurs d - p + m times, so that m of the p choices consist of it alone. Hence (as K. Morken shows
// for products, common_knots.h) the arguments of both polar forms contain the knots between them. All values
// are then combinations of control points with factors in [0, 1], as far as polar values of f stay between
// the knots of g around them.
//
// A polar value of a rational f is a point and a weight. G at points with weights is G at the points times
// the product of the weights, and the result is a rational curve.
//
// A preimage of a knot c is rounded, and f there equals c to within CurvePiece::uncertainty(). F of that knot
// alone counts as c bit for bit; at a knot of f it does so if it equals c to within the smaller
// CurvePiece::uncertainty_at() of the pieces on both sides. So the arguments of G are those of f moved by at
// most that uncertainty u, and control points move by u times the largest control point of the derivative of
// g. Knots of g at most u apart can share a preimage. With the sum of their multiplicities as m no span
// between them is left in the result, and each of its pieces is that of one piece of G, whose derivative
// alone counts. A piece of f may be so short that a rounding of t takes it from end to end; it may then lie
// on both sides of c. In that case m copies of c are missing among the arguments, and control points that it
// shares with longer pieces are those of the longer pieces. In addition, on each axis, rows of G have
// relative errors of 3 p eps, their shares (distributed_rows.h) of 3 p eps too, two contractions add
// (p + 2) eps, and the number of ways, in which each of p choices has at most q + 2 roundings, adds
// (q + 2) p eps after the division by their sum; the sums are compensated.
//
// On periodic axes of g f may run over 65536 periods, up to 2^52 periods away. Throws Status::dimension,
// axes, rational, degree, not_monotone, outside_domain, not_representable, periodic_knots, weights_vanish,
// overflow. Cost: between any two or three neighbouring knots of the result, for each axis the ways to give
// their copies to p arguments, p operations each, and for each control point the product of the numbers of
// copies that the axes can share out; and the knots of the periods that f runs over.
SplinePtr compose(const SplinePtr &g, const SplinePtr &f);

} // namespace nrb::refine
