// SPDX-License-Identifier: MIT
// Knot refinement of periodic axes. Layers and knots form endless sequences, and what is done to one period
// is done to all of them.
#pragma once

#include "refine/knots/axis_table.h"

namespace nrb::refine {

// Inserts knots, and their copies in all periods. The result is periodic over the same domain, and its
// wrapped layers are equal bit for bit. Preconditions: the axis is periodic; the knots are sorted, lie in
// [lower, upper) of the domain, and leave all multiplicities within degree + 1. Throws Status::periodic_knots
// if rounding makes too many copies equal, not_representable if knots of the next period overflow.
AxisTable refine_periodic(const KnotVector &axis, std::span<const double> knots);

} // namespace nrb::refine
