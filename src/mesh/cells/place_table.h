// SPDX-License-Identifier: MIT
// The places where cells have corners, sorted along the lines of both axes.
#pragma once

#include "mesh/cells/cell_tree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::mesh {

// Which lines are one in space.
struct LineTwins {
    // For each line the first of those that are one with it, or itself.
    std::array<std::vector<int32_t>, 2> first;
    // Whether a line is a single point.
    std::array<std::vector<char>, 2> collapsed;

    // Those that each line is by itself, but for the two sides of kinks, at which nothing jumps.
    LineTwins(const CellTree &tree, const pieces::PieceGrid &grid);
    // Both ends of an axis are one.
    void close(size_t k);
};

class PlaceTable {
public:
    // Corners on a line are places on all lines that are one with it.
    PlaceTable(const CellTree &tree, const LineTwins &twins);
    // Of another table, with other numbers of lines, rising, and the corners of some cells.
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
    // The first of those that are one in space with it.
    [[nodiscard]] int32_t point_of(int32_t i) const;
    // That on two lines.
    [[nodiscard]] int32_t find(int32_t u, int32_t v) const noexcept;
    // Those of a line of an axis, rising.
    [[nodiscard]] std::vector<int32_t> on_line(size_t k, int32_t line) const;
    // The corners of a cell, counterclockwise from its lower left one on, and all places on its border.
    [[nodiscard]] std::array<int32_t, 4> corners(const Cell &cell) const noexcept {
        return {find(cell.lower[0], cell.lower[1]), find(cell.upper[0], cell.lower[1]),
                find(cell.upper[0], cell.upper[1]), find(cell.lower[0], cell.upper[1])};
    }
    void border(const std::array<int32_t, 4> &corners, std::vector<int32_t> &places) const;
    void border(const Cell &cell, std::vector<int32_t> &places) const { border(corners(cell), places); }
    // How many that are.
    [[nodiscard]] int32_t border_count(const std::array<int32_t, 4> &corners) const noexcept;

private:
    void add_corners(const Cell &cell, std::vector<uint64_t> &keys) const;
    void set_others();
    void index(const CellTree &tree);

    const LineTwins &twins_;
    std::array<std::vector<int32_t>, 2> others_; // of each line, that which is one with it, or itself
    std::vector<uint64_t> keys_;                 // u, then v
    std::vector<int32_t> across_;                // places by v, then u
    std::vector<int32_t> where_;                 // of places in across_
    std::vector<int32_t> first_on_u_;            // keys of a line of axis 0
    std::vector<int32_t> first_on_v_;            // of across_ of a line of axis 1
};

} // namespace nrb::mesh
