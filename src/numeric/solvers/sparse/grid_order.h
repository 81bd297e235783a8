// SPDX-License-Identifier: MIT
// In which order to eliminate the unknowns of a grid, each of which is coupled with those near it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace nrb::inline numeric {

struct GridAxis {
    int64_t count = 1;
    int64_t reach = 0;     // points that are coupled lie at most so far apart
    bool periodic = false; // the last points are coupled with the first ones
};

// Nested dissection (A. George, SIAM J. Numer. Anal. 10 (1973)): layers as many as the reach divide the grid into two
// parts that are not coupled; they come after both parts. Points are numbered with the last axis fastest.
std::vector<int64_t> grid_order(const std::array<GridAxis, 3> &axes);

} // namespace nrb::inline numeric
