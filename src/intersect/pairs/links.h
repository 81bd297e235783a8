// SPDX-License-Identifier: MIT
// Which parts of two curves touch each other on both.
#pragma once

#include "intersect/pairs/near_cells.h"
#include "intersect/pairs/periods.h"

#include <functional>
#include <span>

namespace nrb::intersect {

// How many periods of both curves a part is moved by.
struct Turns {
    int a = 0, b = 0;
};

// Cell `to`, moved, touches cell `from`.
struct Link {
    size_t from, to;
    Turns turns;
};

// All of them, across the seams of periodic curves too, but not across jumps.
std::vector<Link> links_of(const Spline &a, const Spline &b, std::span<const NearCell> cells);

// Cells that hang together.
struct NearGroup {
    struct Member {
        size_t cell;
        Turns turns; // which bring it to the first one
    };
    std::vector<Member> members;
};

// The groups that links make, in the order of their first cells.
std::vector<NearGroup> groups_of(size_t cells, std::span<const Link> links,
                                 const std::function<bool(const Link &)> &counts);

} // namespace nrb::intersect
