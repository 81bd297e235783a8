// SPDX-License-Identifier: MIT
// Connected groups of the pairs of parts that are left open.
#pragma once

#include "intersect/surfaces/cross_search.h"
#include "intersect/surfaces/cross_spot.h"
#include "intersect/surfaces/cross_touch.h"

namespace nrb::intersect {

struct CrossGroup {
    // Of parameters, which may run beyond the upper ends of domains that close.
    std::array<Interval, 4> ranges;
    bool touch; // TouchTest::is_touch() of all of it
};

// Groups clusters that touch each other on both surfaces, together with what is near: no farther from the
// group than twice its width or, if it is not a touch, than twice the width of its largest cluster. Larger
// groups come first.
std::vector<CrossGroup> cross_groups(const CrossSurface &a, const CrossSurface &b, const TouchTest &touch,
                                     const std::vector<CrossCluster> &clusters);

} // namespace nrb::intersect
