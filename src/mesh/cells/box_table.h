// SPDX-License-Identifier: MIT
// A cache of bounds of the second derivatives of a surface over cells.
#pragma once

#include "mesh/cells/cell_nets.h"

#include <vector>

namespace nrb::mesh {

// A box takes 700 bytes, and about as long to compute again as to write to distant memory and read back. So
// only some are kept, in a slot by the number of the cell: all of a small mesh, and of a large one those of
// cells whose numbers are close.
class BoxTable {
public:
    // `steps`: as for HessianBox::add().
    BoxTable(const pieces::PieceGrid &grid, bool steps) : nets_(grid), steps_(steps) {}

    void keep(int32_t cell, const HessianBox &box);
    // The box of a cell over this part of the domain. The reference is valid until the next call.
    [[nodiscard]] const HessianBox &box(int32_t cell, const Rectangle &part);

private:
    struct Slot {
        int32_t cell;
        HessianBox box;
    };

    CellNets nets_;
    bool steps_;
    std::vector<Slot> slots_;
};

} // namespace nrb::mesh
