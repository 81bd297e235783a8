// SPDX-License-Identifier: MIT
// The places of a domain where cells have corners, sorted along the lines of both axes.
#pragma once

#include "mesh/cells/cell_tree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::mesh {

// Which lines coincide in space: the two lines at a kink, and both ends of a closed axis.
struct LineTwins {
    // For each line the first of those that coincide with it, or itself.
    std::array<std::vector<int32_t>, 2> first;
    // Whether a line is a single point in space.
    std::array<std::vector<char>, 2> collapsed;

    // Only the two lines at a kink coincide, unless the surface jumps there.
    LineTwins(const CellTree &tree, const pieces::PieceGrid &grid);
    // Both ends of an axis coincide.
    void close(size_t k);
};

class PlaceTable {
public:
    // The corners of all cells. Those on a line are places on all lines that coincide with it.
    PlaceTable(const CellTree &tree, const LineTwins &twins);
    // The places of another table, whose lines have new numbers, which rise, and the corners of some cells.
    PlaceTable(const CellTree &tree, const LineTwins &twins, const PlaceTable &old,
               const std::array<std::vector<int32_t>, 2> &lines, const std::vector<int32_t> &cells);

    struct Place {
        std::array<int32_t, 2> lines;
    };
    [[nodiscard]] int32_t count() const noexcept { return static_cast<int32_t>(keys_.size()); }
    [[nodiscard]] Place place(int32_t i) const noexcept {
        const uint64_t key = keys_[static_cast<size_t>(i)];
        return {{static_cast<int32_t>(key >> 32), static_cast<int32_t>(key & 0xffffffffU)}};
    }
    // The first of the places that are one point in space with place i.
    [[nodiscard]] int32_t point_of(int32_t i) const;
    // The place on two lines. Precondition: there is one.
    [[nodiscard]] int32_t find(int32_t u, int32_t v) const noexcept;
    // The places on a line of axis k, rising.
    [[nodiscard]] std::vector<int32_t> on_line(size_t k, int32_t line) const;
    // The corners of a cell, counterclockwise from its lower left one on; and all places on its border, in
    // the same order.
    [[nodiscard]] std::array<int32_t, 4> corners(const Cell &cell) const noexcept {
        return {find(cell.lower[0], cell.lower[1]), find(cell.upper[0], cell.lower[1]),
                find(cell.upper[0], cell.upper[1]), find(cell.lower[0], cell.upper[1])};
    }
    void border(const std::array<int32_t, 4> &corners, std::vector<int32_t> &places) const;
    void border(const Cell &cell, std::vector<int32_t> &places) const { border(corners(cell), places); }
    // The number of places on its border.
    [[nodiscard]] int32_t border_count(const std::array<int32_t, 4> &corners) const noexcept;

private:
    void add_corners(const Cell &cell, std::vector<uint64_t> &keys) const;
    void set_others();
    void index(const CellTree &tree);

    const LineTwins &twins_;
    std::array<std::vector<int32_t>, 2> others_; // for each line the one that coincides with it, or itself
    std::vector<uint64_t> keys_;      // of the places, sorted: line u in the upper half, v in the lower one
    std::vector<int32_t> across_;     // places sorted by v, then u
    std::vector<int32_t> where_;      // where each place is in across_
    std::vector<int32_t> first_on_u_; // where the places on each line of axis 0 begin in keys_
    std::vector<int32_t> first_on_v_; // where those on each line of axis 1 begin in across_
};

} // namespace nrb::mesh
