// SPDX-License-Identifier: MIT
// Polynomial pieces continued beyond the ends of the domain: extension, unclamping, and periodic forms of
// closed splines.
#pragma once

#include "refine/parts/cut.h"

namespace nrb::refine {

// Adds a row for a control point that is a value of the polar form of an end piece. Of its arguments, some
// are the old knots shared_first, ..., shared_end - 1; the others are `arguments`. Rows are over the layers
// of `axis`. An entry is a product of factors that leave [0, 1] with the arguments beyond the end: the
// rounding is that many eps of the sum of |coefficient * point|. Cost: O(number^2) for each row.
void add_continued_row(const KnotVector &axis, int64_t shared_first, int64_t shared_end,
                       std::span<const double> arguments, LayerTable &table);

// The axis, clamped at its upper end, over a longer domain: up to `end` it is the Taylor polynomial of an
// order of the last piece at its end (C^order means that the polar forms agree at all arguments of which
// degree - order are that knot, Ramshaw 1989). The old end stays as a knot of multiplicity degree - order.
// Its multiplicity is degree if the control points that reach across it would become much larger than those
// of the old domain, because the old domain would then be evaluated with the rounding of the large ones.
// Preconditions: 0 <= order <= degree, end > domain.upper.
AxisTable extended_axis(const KnotVector &axis, double end, int order);

// The upper end, or with upper false the lower one, extended by a length of the parameter. Orders from the
// degree on continue the polynomial piece itself. Throws Status::periodic, empty_domain,
// parameter_not_finite, not_representable, and weight_negative unless all weights stay positive.
SplinePtr extend(const SplinePtr &spline, int axis, bool upper, double amount, int order);

// The chosen clamped ends become unclamped: the knots beyond them repeat those of the domain with its length
// as the period. Other ends stay. Throws as extend() does, and Status::knots_merge.
SplinePtr unclamp(const SplinePtr &spline, int axis, AxisEnds ends);

// The same for an axis with clamped ends, over given knots beyond the domain: `degree` of them, not decreasing, on either
// side.
SplinePtr with_end_knots(const SplinePtr &spline, int axis, std::span<const double> below,
                         std::span<const double> above);

} // namespace nrb::refine
