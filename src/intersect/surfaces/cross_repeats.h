// SPDX-License-Identifier: MIT
// Arcs along borders of pieces, which are found on both sides.
#pragma once

#include "intersect/surfaces/cross_search.h"
#include "intersect/surfaces/cross_spot.h"

namespace nrb::intersect {

// Of each arc along a border what no other arc has is left. What is then beyond its piece, although nothing was found there, is a
// part of which it is left open what is in it.
void remove_repeats(const CrossSurface &a, const CrossSurface &b, CrossParts &found);

} // namespace nrb::intersect
