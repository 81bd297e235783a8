// SPDX-License-Identifier: MIT
// Polynomial pieces continued beyond the ends of the domain, for extending and unclamping splines and for
// periodic forms of closed ones.
#pragma once

#include "refine/parts/cut.h"

namespace nrb::refine {

// Adds a row over the layers of `axis` for a control point that is a value of the polar form of an end piece:
// its arguments are the old knots shared_first, ..., shared_end - 1, and `arguments`. With arguments beyond
// the end the factors leave [0, 1]; with n of them, the rounding error is n eps times the sum of |coefficient
// * point|. Cost: O(n^2).
void add_continued_row(const KnotVector &axis, int64_t shared_first, int64_t shared_end,
                       std::span<const double> arguments, LayerTable &table);

// Extends an axis, which is clamped at its upper end, to a longer domain. Up to `end` the spline is continued
// by the Taylor polynomial of order `order` of the last piece at its end. (Contact of that order means that
// the polar forms agree whenever degree - order arguments are that knot, Ramshaw 1989.) The old end becomes a
// knot of multiplicity degree - order. If the control points that act on both sides of it would become much
// larger than those of the old domain, its multiplicity is `degree` instead: otherwise the old domain would
// be evaluated with the rounding errors of the large ones. Preconditions: 0 <= order <= degree, end >
// domain.upper.
AxisTable extended_axis(const KnotVector &axis, double end, int order);

// Extends the upper end of an axis, or the lower one if `upper` is false, by a length of the parameter.
// Orders of at least the degree continue the polynomial piece itself. Throws Status::periodic, empty_domain,
// parameter_not_finite, not_representable, and weight_negative or weights_vanish unless all weights stay
// positive.
SplinePtr extend(const SplinePtr &spline, int axis, bool upper, double amount, int order);

// Unclamps the chosen ends that are clamped: the knots beyond them repeat those of the domain, with its
// length as the period. Other ends stay. Throws Status::knots_merge, not_representable, weight_negative,
// weights_vanish.
SplinePtr unclamp(const SplinePtr &spline, int axis, AxisEnds ends);

// The same for an axis with clamped ends, with given knots beyond the domain: `degree` of them on either
// side, not decreasing.
SplinePtr with_end_knots(const SplinePtr &spline, int axis, std::span<const double> below,
                         std::span<const double> above);

} // namespace nrb::refine
