// SPDX-License-Identifier: MIT
// Knot insertion: one knot, a list of knots, or knots that divide all spans equally.
#pragma once

#include "refine/knots/axis_table.h"

namespace nrb::refine {

// Inserts a knot `times` times along an axis. Throws Status::parameter_not_finite, outside_domain, times,
// multiplicity, overflow, and what refine_axis() and with_axis() throw.
SplinePtr insert_knot(const SplinePtr &spline, int axis, double knot, int64_t times);

// Checks that a knot is finite and lies in the domain; else throws Status::parameter_not_finite or
// outside_domain. Messages call it "knot", or knots[index] for index >= 0.
void check_knot(const KnotVector &axis, int k, double knot, int64_t index = -1);

// Checks a list of knots to be inserted, in any order, as insert_knot() does; messages call them knots[i],
// and the axis k. Returns the sorted list, in which the end of a periodic domain is replaced by its start.
std::vector<double> checked_new_knots(const KnotVector &axis, int k, std::span<const double> knots);

// The knots that divide every non-empty span of the domain into `parts` equal parts. Throws Status::count,
// overflow, and not_representable if a span contains too few doubles.
std::vector<double> uniform_new_knots(const KnotVector &axis, int k, int64_t parts);

// Inserts knots along an axis. Each new layer is a value of the polar form of old layers. rows_of() computes
// the coefficients (by append_argument() of basis/bspline.h), apply_along() applies them. Precondition: the
// list comes from checked_new_knots() or uniform_new_knots().
SplinePtr refine(const SplinePtr &spline, int axis, std::span<const double> sorted_knots);

} // namespace nrb::refine
