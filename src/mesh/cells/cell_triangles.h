// SPDX-License-Identifier: MIT
// Triangles in a cell with places on its border.
#pragma once

#include "mesh/cells/place_table.h"

#include <array>
#include <vector>

namespace nrb::mesh {

// Cuts off ears, first those over which the surface bends least, and none that would leave nothing but one side. Cells with many
// places are halved before, since ears take time in proportion to the square of their number.
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
    using Stops = std::vector<Stop>;
    static void make_two(const Cell &cell, const std::vector<int32_t> &border,
                         std::vector<std::array<int32_t, 3>> &out);
    [[nodiscard]] Stops stops_of(const PlaceTable &table, const Cell &cell,
                                 const std::vector<int32_t> &border) const;
    static void make_in_parts(Stops stops, const Cell &cell, std::vector<std::array<int32_t, 3>> &out);
    static void cut_ears(Stops stops, const Cell &cell, std::vector<std::array<int32_t, 3>> &out);
    [[nodiscard]] static size_t best_ear(const Stops &stops, const Cell &cell);

    const CellTree &tree_;
};

} // namespace nrb::mesh
