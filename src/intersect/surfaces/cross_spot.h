// SPDX-License-Identifier: MIT
// Where common arcs of two surfaces begin and end, in parts of pieces.
#pragma once

#include "intersect/surfaces/cross_arc.h"

namespace nrb::intersect {

// What joins the pieces of a surface.
struct CrossSurface {
    const pieces::PieceGrid &grid;
    const SurfaceBorders &borders;
};

// A place on both surfaces.
struct CrossSpot {
    std::array<int64_t, 4> index{}; // of pieces
    std::array<double, 4> place{}, parameter{};
    std::array<double, 4> noise{}; // of places
};
CrossSpot spot_of(const CrossArc &arc, const CrossEnd &end) noexcept;

// Of an arc between spots of one piece each, in parts of a room and of the noise of both.
double length_of(const CrossSpot &a, const CrossSpot &b, double room) noexcept;

// In parts of pieces, along the coordinate along which it is longest.
double length_of(const CrossSpot &a, const CrossSpot &b) noexcept;

class CrossDistances {
public:
    CrossDistances(const CrossSurface &a, const CrossSurface &b) : surfaces_{&a, &b} {}

    // In parts of a room and of the noise of both; pieces side by side are measured in parts of the smaller one.
    [[nodiscard]] double apart(const CrossSpot &a, const CrossSpot &b, double room) const noexcept;
    // Of a piece along coordinate i.
    [[nodiscard]] double length(size_t i, int64_t index) const noexcept;

private:
    [[nodiscard]] double along(const CrossSpot &a, const CrossSpot &b, size_t i) const noexcept;

    std::array<const CrossSurface *, 2> surfaces_;
};

} // namespace nrb::intersect
