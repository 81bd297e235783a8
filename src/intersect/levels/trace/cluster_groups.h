// SPDX-License-Identifier: MIT
// Parts of a surface's domain that hang together.
#pragma once

#include "intersect/levels/fields/surface_borders.h"

#include <array>
#include <cstddef>
#include <vector>

namespace nrb::intersect {

using ParameterRanges = std::array<Interval, 2>;

// Those that touch, with as much around each as it is large, across seams and at poles too. Both the groups and the parts of each
// are in the order in which parts begin along the first axis.
std::vector<std::vector<size_t>> touching_groups(const std::vector<ParameterRanges> &parts,
                                                 const pieces::PieceGrid &grid,
                                                 const SurfaceBorders &borders);

// Of the whole grid along an axis.
Interval domain_along(const pieces::PieceGrid &grid, size_t axis) noexcept;

// Places in the order of their first parameters.
class SortedPlaces {
public:
    explicit SortedPlaces(std::vector<std::array<double, 2>> places);

    // Whether one of them is in a part, to within `room` of the periods, or is so one period away.
    [[nodiscard]] bool any_in(const ParameterRanges &part, const SurfaceBorders &borders, double room) const;

private:
    std::vector<std::array<double, 2>> places_;
};

} // namespace nrb::intersect
