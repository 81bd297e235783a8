// SPDX-License-Identifier: MIT
// What the second derivatives of a surface can be over the cells that were looked at last.
#pragma once

#include "mesh/cells/cell_nets.h"

#include <vector>

namespace nrb::mesh {

// A box takes 700 bytes, and as long to make anew as to write and read it far away, so that only some are kept: all of a small mesh,
// and of a large one those that are near to each other in the order of cells.
class BoxTable {
public:
    // `steps`: as of HessianBox::add().
    BoxTable(const pieces::PieceGrid &grid, bool steps) : nets_(grid), steps_(steps) {}

    void keep(int32_t cell, const HessianBox &box);
    // Of a cell over this part of the domain; until the next call.
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
