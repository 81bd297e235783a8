// SPDX-License-Identifier: MIT
// Chains the edges of overlaps to closed loops, and finds the regions that these bound in the domain of the
// first surface.
#pragma once

#include "intersect/surfaces/overlap/overlap_edges.h"

namespace nrb::intersect {

// The indices of consecutive edges.
using OverlapLoop = std::vector<size_t>;

struct OverlapRegion {
    std::vector<OverlapLoop> loops;
    // A polygon along each loop, with continuous parameters of the first surface.
    std::vector<std::vector<std::array<double, 2>>> polygons;
};

// The winding number of a polygon about a place.
int winding_of(const std::vector<std::array<double, 2>> &polygon, const std::array<double, 2> &at) noexcept;

struct OverlapRegions {
    std::vector<OverlapRegion> list;
    // Whether a region contains the side of the domain to which the rays of hold() lead, or all of a surface
    // without borders but for its holes.
    bool far_inside = false;

    // Whether a place is in one of the regions, by the crossings of a ray with their polygons. Precondition:
    // no edge runs through the place.
    [[nodiscard]] bool hold(const OverlapGround &ground, const std::array<double, 2> &at) const noexcept;
};

// None: the edges do not make closed loops, or it is left open what they bound.
std::optional<OverlapRegions> overlap_regions(const OverlapGround &ground, const OverlapEdges &edges);

} // namespace nrb::intersect
