// SPDX-License-Identifier: MIT
// Triangles in a cell with places on its border.
#pragma once

#include "mesh/cells/place_table.h"

#include <array>
#include <vector>

namespace nrb::mesh {

// Cuts off ears, first those over which the surface bends least, and none that would leave nothing but one side.
class CellTriangles {
public:
    explicit CellTriangles(const CellTree &tree) : tree_(tree) {}

    // Border: as of a PlaceTable; `out` takes the triangles.
    void make(const PlaceTable &table, const Cell &cell, const std::vector<int32_t> &border,
              std::vector<std::array<int32_t, 3>> &out);

private:
    struct Stop {
        int32_t place;
        unsigned sides; // of the cell on which it lies, as bits
        double u, v;    // in the cell
    };
    void make_two(const Cell &cell, const std::vector<int32_t> &border,
                  std::vector<std::array<int32_t, 3>> &out) const;
    void set_stops(const PlaceTable &table, const Cell &cell, const std::vector<int32_t> &border);
    [[nodiscard]] bool is_ear(size_t i) const noexcept;
    [[nodiscard]] bool flat_without(size_t i) const noexcept;

    const CellTree &tree_;
    std::vector<Stop> stops_;
};

} // namespace nrb::mesh
