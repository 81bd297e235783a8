// SPDX-License-Identifier: MIT
// Which parts of two curves adjoin each other on both curves.
#pragma once

#include "intersect/pairs/near_cells.h"
#include "intersect/pairs/periods.h"

#include <functional>
#include <span>

namespace nrb::intersect {

// The numbers of periods by which a part is moved on both curves.
struct Turns {
    int a = 0, b = 0;
};

// Cell `to`, moved by the turns, touches cell `from`.
struct Link {
    size_t from, to;
    Turns turns;
};

// All links, also across the seams of periodic curves, but not across jumps.
std::vector<Link> links_of(const Spline &a, const Spline &b, std::span<const NearCell> cells);

// A connected component of cells.
struct NearGroup {
    struct Member {
        size_t cell;
        Turns turns; // which move it to where it adjoins the others
    };
    std::vector<Member> members;
};

// The connected components by the links that count, in the order of their first cells.
std::vector<NearGroup> groups_of(size_t cells, std::span<const Link> links,
                                 const std::function<bool(const Link &)> &counts);

} // namespace nrb::intersect
