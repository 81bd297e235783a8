// SPDX-License-Identifier: MIT
// Where a function of one variable changes its sign between ends whose signs are given.
#pragma once

#include "intersect/levels/trace/level_net.h"

#include <vector>

namespace nrb::intersect {

// Places in [0, 1], rising, at each of which the sign changes: as many as the signs at the ends demand, but for an even
// number. What is nearer to 0 than the noise has no sign of its own: it takes that of what is around it. By halving
// until coefficients change their sign once at most, then secants.
std::vector<double> edge_roots(const LevelNet::Edge &edge, bool above_at_start, bool above_at_end);

} // namespace nrb::intersect
