// SPDX-License-Identifier: MIT
// Composition of splines: a curve over another parameter, and curves that lie on surfaces and in volumes.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// The curve g(f(t)), where f is a curve in the parameter space of g. f is polynomial or has positive weights.
// The result is clamped. Its degree is d = q (p_0 + p_1 + ...), with q the degree of f and p_k those of g. It
// has knots where f has knots and where f crosses knots of g, with the multiplicities that the continuity
// requires.
//
// Method. Let G be the polar form of g and F that of f. A control point is the mean of G(F(t_I1), F(t_I2),
// ...) over all ways to distribute the d knots that belong to it among the arguments of G, q to each (T.
// DeRose, R. Goldman, H. Hagen, S. Mann, "Functional composition algorithms via blossoming", ACM Trans.
// Graphics 12 (1993)). A knot of f of multiplicity m inside the window occurs d - q + m times in it, so each
// choice of q knots contains at least m of its copies. Where f crosses a knot of g of multiplicity m, on an
// axis of degree p, the crossing occurs d - p + m times, so at least m of the p choices consist of it alone.
// Hence (as K. Morken shows for products, common_knots.h) the arguments of both polar forms contain the knots
// between them. All values are then combinations of control points with factors in [0, 1], provided that
// polar values of f stay between the knots of g around them.
//
// Rational f. A polar value of f is a point with a weight. G at such points is G at the points, times the
// product of the weights, and the result is a rational curve.
//
// Rounding of crossings. The preimage of a knot c of g is rounded, and f there equals c to within
// CurvePiece::uncertainty(). F with this knot as its only argument is taken to be c, bit for bit; at a knot
// of f this is done if the value equals c to within the smaller CurvePiece::uncertainty_at() of the pieces on
// both sides. So the arguments of G are those of f moved by at most this uncertainty u, and control points
// move by at most u times the largest control point of the derivative of g. Knots of g that are at most u
// apart can share a preimage. Their multiplicities then add up to m; no span between them is left in the
// result, and each piece of the result is that of one piece of G, whose derivative alone counts. A piece of f
// may be so short that a rounding of t takes it from end to end, and may then lie on both sides of c. In that
// case m copies of c are missing among the arguments, and the control points that the piece shares with
// longer pieces are those of the longer pieces.
//
// Further errors, for each axis: rows of G have relative errors of 3 p eps; their weights as combinations of
// A and B (distributed_rows.h) contribute 3 p eps as well; two contractions add (p + 2) eps; and the number
// of ways, in which each of p choices has at most q + 2 roundings, adds (q + 2) p eps after the division by
// their sum. The sums are compensated.
//
// On a periodic axis of g, f may run over up to 65536 periods, none of them more than 2^52 periods away.
// Throws Status::dimension, axes, rational, degree, not_monotone, outside_domain, not_representable,
// periodic_knots, weights_vanish, overflow. Cost: for every two or three neighbouring knots of the result and
// each axis, the number of ways to give copies of them to p arguments, p operations each; for each control
// point, the product of the numbers of sets of copies that the axes can take; and the knots of the periods
// that f runs over.
SplinePtr compose(const SplinePtr &g, const SplinePtr &f);

} // namespace nrb::refine
