// SPDX-License-Identifier: MIT
// Common arcs of two surfaces, one after the other.
#pragma once

#include "intersect/levels/level_meet.h"
#include "intersect/surfaces/cross_clusters.h"
#include "intersect/surfaces/cross_search.h"
#include "intersect/surfaces/cross_spot.h"

namespace nrb::intersect {

struct CrossChain {
    std::vector<size_t> arcs; // along N_b x N_a
    bool closed = false;
    std::array<int64_t, 2> nodes{-1, -1}; // of a chain that is not closed
    int64_t loop = -1;                    // the closed way that it is part of, or all of
};

struct CrossChains {
    std::vector<MeetNode> nodes; // of level 0
    std::vector<CrossChain> chains;
};

// An end goes on in the beginning next to it, no farther away than what rounding, and kinks beside the sides of boxes, make of
// one place. Ends that do not go on are nodes: borders, groups of clusters, or undecided.
CrossChains cross_chains(const CrossSurface &a, const CrossSurface &b, std::vector<CrossGroup> groups,
                         const CrossParts &found);

} // namespace nrb::intersect
