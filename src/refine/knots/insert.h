// SPDX-License-Identifier: MIT
// Knot insertion: one knot, a list of knots, or all spans in equal parts.
#pragma once

#include "refine/knots/axis_table.h"

namespace nrb::refine {

// Inserts `knot` `times` times along an axis. Throws Error: Status::parameter_not_finite,
// outside_domain, times, multiplicity, overflow, and what refine_axis() and with_axis() throw.
SplinePtr insert_knot(const SplinePtr &spline, int axis, double knot, int64_t times);

// Finite and in the domain, else Status::parameter_not_finite or outside_domain; messages name "knot",
// or knots[index].
void check_knot(const KnotVector &axis, int k, double knot, int64_t index = -1);

// A list of knots to insert, in any order, checked as for insert_knot() with messages that name knots[i]: the
// sorted list, the end of a periodic domain replaced by its start. k is the axis of messages.
std::vector<double> checked_new_knots(const KnotVector &axis, int k, std::span<const double> knots);

// The knots that divide every non-empty span of the domain into `parts` equal parts. Throws Status::count,
// overflow; not_representable if a span has too few doubles for its parts.
std::vector<double> uniform_new_knots(const KnotVector &axis, int k, int64_t parts);

// Each new layer is a polar form of old ones: rows_of() makes the coefficients (append_argument() of
// basis/bspline.h is the arithmetic), apply_along() applies them to the net. Precondition:
// checked_new_knots() or uniform_new_knots() made the list.
SplinePtr refine(const SplinePtr &spline, int axis, std::span<const double> sorted_knots);

} // namespace nrb::refine
