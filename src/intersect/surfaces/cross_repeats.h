// SPDX-License-Identifier: MIT
// Removes repeated arcs: those along borders of pieces are found from both sides.
#pragma once

#include "intersect/surfaces/cross_search.h"
#include "intersect/surfaces/cross_spot.h"

namespace nrb::intersect {

// Keeps of each arc along a border only what no other arc covers. Where that is beyond the piece of the arc,
// although nothing was found there, the pair of parts is left open as a cluster.
void remove_repeats(const CrossSurface &a, const CrossSurface &b, CrossParts &found);

} // namespace nrb::intersect
