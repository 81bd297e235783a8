// SPDX-License-Identifier: MIT
// The order in which points are inserted into a triangulation: in rounds, along a Hilbert curve.
#pragma once

#include "mesh/delaunay/grid_point.h"

#include <span>
#include <vector>

namespace nrb::mesh {

struct DistinctPoints {
    std::vector<GridPoint> points; // along a Hilbert curve, so that near ones have near numbers
    std::vector<int32_t> place;    // of each given point, its number in `points`
};
// Throws Status::overflow for more points than there may be vertices.
DistinctPoints distinct_points(std::span<const GridPoint> points);

// The numbers 0, ..., count - 1 in rounds: every 4^k-th one, then every 4^(k-1)-th one that is left, and so
// on. If they number points along a curve that fills the plane, the points of each round lie evenly along it,
// four times as densely as those before, so that no vertex has many triangles for long. In plain order, all
// points on one side of the plane may come before those on the other side: for 10^5 points on two lines, that
// takes 2000 times as long.
std::vector<int32_t> order_in_rounds(int32_t count);

} // namespace nrb::mesh
