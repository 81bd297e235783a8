// SPDX-License-Identifier: MIT
// Degree elevation.
#pragma once

#include "refine/knots/axis_table.h"

namespace nrb::refine {

// The axis with its degree raised by `times`, and the table for all stored layers. Throws
// Status::periodic_knots, not_representable. Precondition: 0 < times <= max_degree - degree.
AxisTable elevate_axis(const KnotVector &axis, int64_t times);

// The same shape with the degree of an axis raised by `times`. Several steps of one degree are composed to
// one table, which is applied once. Throws Status::times (negative), degree (beyond max_degree),
// periodic_knots, not_representable, weights_vanish, overflow. Cost: linear in the number of points.
SplinePtr elevate(const SplinePtr &spline, int axis, int64_t times);

} // namespace nrb::refine
