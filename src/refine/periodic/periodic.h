// SPDX-License-Identifier: MIT
// Refinement of periodic axes: the layers and knots of a period continue without end, and an operation on one
// period acts on all of them.
#pragma once

#include "refine/knots/axis_table.h"

namespace nrb::refine {

// Inserts knots and their copies in all periods; the result is periodic over the same domain, its wrapped
// layers equal bit for bit. Preconditions: the axis is periodic, the knots are sorted, lie in [lower, upper)
// of the domain and leave all multiplicities within degree + 1. Throws Status::periodic_knots if copies
// cannot be told from their neighbours, not_representable if those of the next period overflow.
AxisTable refine_periodic(const KnotVector &axis, std::span<const double> knots);

} // namespace nrb::refine
