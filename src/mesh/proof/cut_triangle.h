// SPDX-License-Identifier: MIT
// A triangle of the domain cut along lines u = const and v = const.
#pragma once

#include "mesh/proof/triangle_bound.h"

#include <vector>

namespace nrb::mesh {

// Part of a triangle: a convex polygon.
struct CutPolygon {
    std::vector<std::array<double, 2>> places;
    std::vector<int>
        sides; // of the triangle: that on which the side from place i to the next one lies, -1: none
};

// What a triangle has of a rectangle; fewer than three places: nothing.
CutPolygon cut_triangle(const std::array<std::array<double, 2>, 3> &triangle, const Rectangle &part);

} // namespace nrb::mesh
