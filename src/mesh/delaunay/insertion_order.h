// SPDX-License-Identifier: MIT
// In which order points become vertices.
#pragma once

#include "mesh/delaunay/grid_point.h"

#include <span>
#include <vector>

namespace nrb::mesh {

struct DistinctPoints {
    std::vector<GridPoint> points; // along a Hilbert curve, so that near ones have near numbers
    std::vector<int32_t> place;    // of each point that was given
};
// Refuses more points than there may be vertices.
DistinctPoints distinct_points(std::span<const GridPoint> points);

// The numbers from 0 to count in rounds: every 4^k-th one, then every 4^(k-1)-th one of the others, and so on. Each round
// lies evenly among the points of a curve that fills the plane, and four times as densely as those before. In plain
// order the triangles between all that came before and its hull are long, and points along a circle or a
// parabola change as many of them as there are points.
std::vector<int32_t> order_in_rounds(int32_t count);

} // namespace nrb::mesh
