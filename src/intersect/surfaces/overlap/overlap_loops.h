// SPDX-License-Identifier: MIT
// Closed loops of edges, and the regions that they bound.
#pragma once

#include "intersect/surfaces/overlap/overlap_edges.h"

namespace nrb::intersect {

// Edges one after the other, as indices.
using OverlapLoop = std::vector<size_t>;

struct OverlapRegion {
    std::vector<OverlapLoop> loops;
    // A polygon along each loop in the domain of the first surface, in which parameters run on.
    std::vector<std::vector<std::array<double, 2>>> polygons;
};

// How often a polygon winds around a place.
int winding_of(const std::vector<std::array<double, 2>> &polygon, const std::array<double, 2> &at) noexcept;

struct OverlapRegions {
    std::vector<OverlapRegion> list;
    // Whether the side of the domain to which rays lead, or all of a surface without borders, is in one of them.
    bool far_inside = false;

    // Whether a place, through which no edge runs, is in one of them: by the edges that a ray across crosses.
    [[nodiscard]] bool hold(const OverlapGround &ground, const std::array<double, 2> &at) const noexcept;
};

// None: edges make no loops, or it is left open what they bound.
std::optional<OverlapRegions> overlap_regions(const OverlapGround &ground, const OverlapEdges &edges);

} // namespace nrb::intersect
