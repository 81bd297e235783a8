// SPDX-License-Identifier: MIT
// Clips a triangle of the domain to a rectangle (Sutherland-Hodgman algorithm).
#pragma once

#include "mesh/proof/triangle_bound.h"

#include <span>

namespace nrb::mesh {

// A vertex of a polygon. side: the side of the triangle on which the edge to the next vertex lies; -1: none.
struct CutPlace {
    std::array<double, 2> at;
    int side;
};

// A part of a triangle: a convex polygon. Clipping at each of four lines adds one vertex. Where rounding
// makes a polygon cross a line more often, n vertices become at most 3 n / 2: from 3 at most 4, 6, 9 and 13.
class CutPolygon {
public:
    [[nodiscard]] std::span<const CutPlace> places() const &noexcept { return {all_.data(), count_}; }
    void places() && = delete; // would dangle
    void add(const CutPlace &place) noexcept { all_[count_++] = place; }

private:
    std::array<CutPlace, 13> all_{};
    size_t count_ = 0;
};

// The intersection of a triangle and a rectangle; empty if it has fewer than three vertices.
CutPolygon cut_triangle(const std::array<std::array<double, 2>, 3> &triangle, const Rectangle &part) noexcept;

} // namespace nrb::mesh
