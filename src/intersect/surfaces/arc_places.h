// SPDX-License-Identifier: MIT
// Places of two surfaces as arcs that are near see them.
#pragma once

#include "intersect/surfaces/cross_spot.h"

#include <map>
#include <vector>

namespace nrb::intersect {

// Of arcs, by the pieces that they are in.
using NumbersOfPieces = std::map<std::array<int64_t, 4>, std::vector<size_t>>;

class ArcPlaces {
public:
    ArcPlaces(const CrossSurface &a, const CrossSurface &b) : surfaces_{&a, &b} {}

    // The numbers of what is in pieces, or in their neighbours.
    [[nodiscard]] std::vector<size_t> near(const std::array<int64_t, 4> &index,
                                           const NumbersOfPieces &numbers) const;
    // Whether a spot is one of the zeros in the wide box of an arc, at z there.
    [[nodiscard]] bool is_zero_of(const CrossArc &arc, const CrossSpot &spot, CrossPlace &z) const;

private:
    [[nodiscard]] double place_in(const CrossBox &box, const CrossSpot &spot, size_t i) const noexcept;
    [[nodiscard]] bool wraps(size_t i) const noexcept { return surfaces_[i / 2]->borders.wraps(i % 2); }
    [[nodiscard]] int64_t count(size_t i) const noexcept {
        return surfaces_[i / 2]->grid.count(static_cast<int>(i % 2));
    }
    [[nodiscard]] double length(size_t i, int64_t index) const noexcept;

    std::array<const CrossSurface *, 2> surfaces_;
};

} // namespace nrb::intersect
