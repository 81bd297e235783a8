// SPDX-License-Identifier: MIT
// Divides a cell with places on its border into triangles, by ear clipping.
#pragma once

#include "mesh/cells/place_table.h"

#include <array>
#include <vector>

namespace nrb::mesh {

// Ears over which the surface bends least are cut off first, but none such that all remaining places would
// lie on one side of the cell. Cells with many places are cut in two before that, since ear clipping takes
// quadratic time.
class CellTriangles {
public:
    explicit CellTriangles(const CellTree &tree) : tree_(tree) {}

    // `border`: the places on the border of the cell, as from PlaceTable::border(). Triangles are appended to
    // `out`.
    void make(const PlaceTable &table, const Cell &cell, const std::vector<int32_t> &border,
              std::vector<std::array<int32_t, 3>> &out);

private:
    // A place on the border of the cell.
    struct Stop {
        int32_t place;
        unsigned sides; // the sides of the cell on which it lies, as bits
        double u, v;    // where it is in the cell, from 0 to 1
    };
    using Stops = std::vector<Stop>;
    static void make_two(const Cell &cell, const std::vector<int32_t> &border,
                         std::vector<std::array<int32_t, 3>> &out);
    [[nodiscard]] Stops stops_of(const PlaceTable &table, const Cell &cell,
                                 const std::vector<int32_t> &border) const;
    static void cut_poles(const PlaceTable &table, Stops &stops, std::vector<std::array<int32_t, 3>> &out);
    static void make_in_parts(Stops stops, const Cell &cell, std::vector<std::array<int32_t, 3>> &out);
    static void cut_ears(Stops stops, const Cell &cell, std::vector<std::array<int32_t, 3>> &out);
    [[nodiscard]] static size_t best_ear(const Stops &stops, const Cell &cell);

    const CellTree &tree_;
};

} // namespace nrb::mesh
