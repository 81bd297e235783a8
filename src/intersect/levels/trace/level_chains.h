// SPDX-License-Identifier: MIT
// Arcs of levels, one after the other.
#pragma once

#include "intersect/levels/level_meet.h"
#include "intersect/levels/trace/level_trace.h"

namespace nrb::intersect {

struct LevelChain {
    std::vector<size_t> arcs; // f > 0 on their left
    bool closed = false;
    std::array<int32_t, 2> nodes{-1, -1}; // of a chain that is not closed
    int32_t loop = -1;                    // the closed way that it is part of, or all of
};

struct LevelChains {
    std::vector<MeetNode> nodes; // of level 0
    std::vector<LevelChain> chains;
};

// Clusters that touch are one node. The chains of a loop follow each other.
LevelChains chains_of(const pieces::PieceGrid &grid, const SurfaceBorders &borders, const LevelPieces &found);

} // namespace nrb::intersect
