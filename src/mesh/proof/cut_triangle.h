// SPDX-License-Identifier: MIT
// A triangle of the domain cut along lines u = const and v = const.
#pragma once

#include "mesh/proof/triangle_bound.h"

#include <span>

namespace nrb::mesh {

struct CutPlace {
    std::array<double, 2> at;
    int side; // of the triangle: that on which the side from here to the next place lies, -1: none
};

// Part of a triangle: a convex polygon. Each of four lines adds one place; where rounding makes a polygon cross a line more often, 3 places
// become 4, 6, 9 and 13 at most.
class CutPolygon {
public:
    [[nodiscard]] std::span<const CutPlace> places() const &noexcept { return {all_.data(), count_}; }
    void places() && = delete; // they would be gone
    void add(const CutPlace &place) noexcept { all_[count_++] = place; }

private:
    std::array<CutPlace, 13> all_{};
    size_t count_ = 0;
};

// What a triangle has of a rectangle; fewer than three places: nothing.
CutPolygon cut_triangle(const std::array<std::array<double, 2>, 3> &triangle, const Rectangle &part) noexcept;

} // namespace nrb::mesh
