// SPDX-License-Identifier: MIT
// Parts of the domain in which a shape is changed.
#pragma once

#include "spline/part.h"

namespace nrb::modify {

// The spline refined so that the ends of the part are knots. Along each axis of which the part is not the
// whole domain, it also has a knot in each of cells_per_degree (degree + 1) equal parts of the range. Throws
// what refine() throws.
SplinePtr refined_to(const SplinePtr &spline, const Part &part, int cells_per_degree);

// Whether the basis function of a layer vanishes on the domain outside the range.
bool inside(const KnotVector &axis, int64_t layer, Interval range) noexcept;

} // namespace nrb::modify
