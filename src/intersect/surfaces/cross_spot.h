// SPDX-License-Identifier: MIT
// Where common arcs of two surfaces begin and end, as positions that can be compared between boxes: the index
// of a piece along each axis, and the place in it.
#pragma once

#include "intersect/surfaces/cross_arc.h"

namespace nrb::intersect {

// How the pieces of a surface are arranged and joined.
struct CrossSurface {
    const pieces::PieceGrid &grid;
    const SurfaceBorders &borders;
};

// A position on both surfaces: u, v of the first one, s, t of the second one.
struct CrossSpot {
    std::array<int64_t, 4> index{}; // of pieces
    std::array<double, 4> place{}, parameter{};
    std::array<double, 4> noise{}; // errors of places, as noise_of_end() estimates them
};
CrossSpot spot_of(const CrossArc &arc, const CrossEnd &end) noexcept;

// The length of an arc between two spots in the same pieces: the largest over the coordinates, relative to
// `room` plus the noise of both spots.
double length_of(const CrossSpot &a, const CrossSpot &b, double room) noexcept;

// The same in lengths of pieces.
double length_of(const CrossSpot &a, const CrossSpot &b) noexcept;

// Distances of spots that may be in neighbouring pieces.
class CrossDistances {
public:
    CrossDistances(const CrossSurface &a, const CrossSurface &b) : surfaces_{&a, &b} {}

    // The largest distance over the coordinates, relative to `room` plus the noise of both spots; at least 64
    // if they are neither in one piece nor in neighbouring ones. Across a border it is measured in lengths of
    // the shorter piece. Results from 64 on are lower bounds only.
    [[nodiscard]] double apart(const CrossSpot &a, const CrossSpot &b, double room) const noexcept;
    // Of a piece along coordinate i, in parameters.
    [[nodiscard]] double length(size_t i, int64_t index) const noexcept;

private:
    [[nodiscard]] double along(const CrossSpot &a, const CrossSpot &b, size_t i) const noexcept;

    std::array<const CrossSurface *, 2> surfaces_;
};

} // namespace nrb::intersect
