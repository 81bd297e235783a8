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

// What is joined of an arc, whatever it is of.
struct JoinedArc {
    std::array<CrossSpot, 2> spots;
    std::array<bool, 2> open{};    // a surface ends there
    std::array<bool, 2> creased{}; // it may have a crease there, at which what goes on in nothing ends
};

// An end goes on in the beginning next to it, no farther away than what rounding, and kinks beside the sides of boxes, make of
// one place. Ends that do not go on are nodes: borders, clusters, which are one if they touch, or undecided.
CrossChains joined_chains(const CrossSurface &a, const CrossSurface &b, const std::vector<JoinedArc> &arcs,
                          std::vector<CrossGroup> groups);
CrossChains cross_chains(const CrossSurface &a, const CrossSurface &b, std::vector<CrossGroup> groups,
                         const CrossParts &found);

} // namespace nrb::intersect
