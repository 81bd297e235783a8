// SPDX-License-Identifier: MIT
// Pairs of parts in which curves are not told, as what hangs together.
#pragma once

#include "intersect/surfaces/cross_search.h"
#include "intersect/surfaces/cross_spot.h"
#include "intersect/surfaces/cross_touch.h"

namespace nrb::intersect {

struct CrossGroup {
    std::array<Interval, 4>
        ranges; // of parameters, which may run beyond the upper ends of domains that close
    bool touch; // TouchTest::is_touch() of all of it
};

// Clusters that touch on both surfaces are one, with those that are no farther from it than it is large. Larger ones come first.
std::vector<CrossGroup> cross_groups(const CrossSurface &a, const CrossSurface &b, const TouchTest &touch,
                                     const std::vector<CrossCluster> &clusters);

} // namespace nrb::intersect
