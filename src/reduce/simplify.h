// SPDX-License-Identifier: MIT
// Lowest degrees and fewest knots within a tolerance.
#pragma once

#include "reduce/reduce_knots.h"

namespace nrb::reduce {

// Removes weights first, then lowers the degree of each axis, then removes knots. Throws as reduce_knots().
Reduced simplify(const SplinePtr &spline, double tolerance);

} // namespace nrb::reduce
