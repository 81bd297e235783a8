// SPDX-License-Identifier: MIT
// Places on two surfaces in the local coordinates of the common arcs near them.
#pragma once

#include "intersect/surfaces/cross_spot.h"

#include <map>
#include <vector>

namespace nrb::intersect {

// Numbers of arcs, by the indices (u, v of the first surface, s, t of the second one) of the pieces that they
// are in.
using NumbersOfPieces = std::map<std::array<int64_t, 4>, std::vector<size_t>>;

// Finds the arcs in and around a pair of pieces, and tests whether a spot lies on one of them.
class ArcPlaces {
public:
    ArcPlaces(const CrossSurface &a, const CrossSurface &b) : surfaces_{&a, &b} {}

    // The arcs in a pair of pieces and in the pairs next to it, across seams too, by rising numbers.
    [[nodiscard]] std::vector<size_t> near(const std::array<int64_t, 4> &index,
                                           const NumbersOfPieces &numbers) const;
    // Whether a spot is a zero of F in the wide box of an arc (cross_chart.h), up to what neighbouring pieces
    // differ by. z: its place there.
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
