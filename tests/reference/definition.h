// The textbook definitions, word for word, in reduced rational numbers: slow, and the judge of the fast
// reference.
#pragma once

#include "reference/exact_spline.h"

namespace reference {

// N_(i,p)(t) by the recursive definition; `span` names the piece whose polynomial is meant (N_(i,0) = 1 if i
// = span, else 0).
Rational defined_basis(const std::vector<double> &knots, int64_t span, int64_t i, int degree,
                       const Rational &t);
// Its k-th derivative.
Rational defined_basis_derivative(const std::vector<double> &knots, int64_t span, int64_t i, int degree,
                                  const Rational &t, int k);

// sum_i R_i(t) P_i over all control points, not only the active ones.
std::vector<Rational> defined_point(const support::SplineData &data, const double *param, Sides left = {});

// Polar form of the piece on span s at `degree` arguments, by affine combinations of its degree + 1 active
// points.
std::vector<Rational> blossom_at(const std::vector<double> &knots, int degree, int64_t s,
                                 std::vector<std::vector<Rational>> points,
                                 const std::vector<Rational> &arguments);
std::vector<Rational> defined_blossom(const std::vector<double> &knots, int degree, int64_t s,
                                      std::vector<std::vector<Rational>> points,
                                      const std::vector<double> &arguments);

// Control points (w x, w y, ..., w) after inserting `knot` `times` times on an axis, each by its polar form:
// point j of the refined spline is the blossom of the old one at the p new knots that follow new knot j
// (Ramshaw 1989). Only layers first .. last of that axis are computed, packed with the axes in their order.
// Indices count the refined spline's layers.
struct InsertedLayers {
    std::vector<double> knots; // the refined vector
    int64_t first = 0;         // layers below are old ones, layers above are old ones moved up by `times`
    int64_t last = 0;
    std::vector<std::vector<Rational>> records; // one per point of the layers first .. last
};
InsertedLayers defined_insertion(const support::SplineData &data, int axis, double knot, int times);

// All control points (w x, w y, ..., w) of the spline over `knots` on an axis of degree p + times, packed
// with the last axis fastest. Each is the mean of the old polar form over all choices of p of the p + times
// new knots that follow new knot j (Ramshaw 1989).
std::vector<std::vector<Rational>> defined_elevation(const support::SplineData &data, int axis, int times,
                                                     const std::vector<double> &knots);

// The same for any knots that include the old ones, on an axis that is not periodic: all layers, packed.
// Points whose functions vanish in the domain are left empty, as the shape does not define them.
std::vector<std::vector<Rational>> defined_refinement(const support::SplineData &data, int axis,
                                                      const std::vector<double> &knots);

} // namespace reference
