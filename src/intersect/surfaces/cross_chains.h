// SPDX-License-Identifier: MIT
// Joins common arcs of two surfaces, end to beginning, into chains.
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
    int64_t loop = -1;                    // number of the closed way that it is part of, or all of; -1: none
};

struct CrossChains {
    std::vector<MeetNode> nodes; // of level 0
    std::vector<CrossChain> chains;
};

// What joining needs to know about an arc, whichever equations it comes from.
struct JoinedArc {
    std::array<CrossSpot, 2> spots;
    std::array<bool, 2> open{};    // [end]: a surface ends there
    std::array<bool, 2> creased{}; // [end]: it may have a crease there, so that the curve may really end
};

// Joins each end of an arc to the nearest beginning of one, if they are no farther apart than rounding, and
// kinks next to the shifted sides of boxes, may move one and the same place. Ends that are joined to nothing
// become nodes: borders, groups of clusters (one node each), or undecided.
CrossChains joined_chains(const CrossSurface &a, const CrossSurface &b, const std::vector<JoinedArc> &arcs,
                          std::vector<CrossGroup> groups);
CrossChains cross_chains(const CrossSurface &a, const CrossSurface &b, std::vector<CrossGroup> groups,
                         const CrossParts &found);

} // namespace nrb::intersect
