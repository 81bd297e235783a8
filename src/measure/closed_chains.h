// SPDX-License-Identifier: MIT
// Whether curves follow one another in closed chains.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::measure {

// Checks that the curves form closed chains: throws Status::gap unless every end of a curve, and every limit
// from below at a jump inside one, can be given a start within the tolerance that no other end has been
// given. Cost: n log n for n ends, if few of them are within the tolerance of each other in x; at most n^2
// for each end whose nearest start has been given away.
void check_closed(const std::vector<SplinePtr> &curves, double tolerance);

} // namespace nrb::measure
