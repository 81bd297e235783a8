// SPDX-License-Identifier: MIT
// A fill-reducing elimination order for the unknowns of a grid, each coupled with its neighbours.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace nrb::inline numeric {

struct GridAxis {
    int64_t count = 1;
    int64_t reach = 0;     // coupled points are at most this far apart
    bool periodic = false; // the last points are coupled with the first
};

// Nested dissection (A. George, SIAM J. Numer. Anal. 10 (1973)): a separator of as many layers as the reach
// divides the grid into two uncoupled parts, and is eliminated after both. Points are numbered with the last
// axis fastest.
std::vector<int64_t> grid_order(const std::array<GridAxis, 3> &axes);

} // namespace nrb::inline numeric
