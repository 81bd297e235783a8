// SPDX-License-Identifier: MIT
#include "mesh/cells/box_table.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

constexpr size_t fewest_slots = 64, most_slots = 4096;
// The factor by which the room for slots grows: boxes are rarely moved then, and pages of memory without
// boxes are never touched.
constexpr size_t growth = 8;

} // namespace

// New cells come in the order of their numbers: until all slots are in use, each cell has its own.
void BoxTable::keep(int32_t cell, const HessianBox &box) {
    const size_t at = static_cast<size_t>(cell) % most_slots;
    if (at == slots_.size()) {
        if (at == slots_.capacity()) {
            slots_.reserve(std::max(fewest_slots, growth * at));
        }
        slots_.push_back({cell, box});
    } else {
        slots_[at] = {cell, box};
    }
}

const HessianBox &BoxTable::box(int32_t cell, const Rectangle &part) {
    Slot &own = slots_[static_cast<size_t>(cell) % most_slots];
    if (own.cell != cell) {
        own = {cell, nets_.box(part, nets_.pieces_in(part), steps_)};
    }
    return own.box;
}

} // namespace nrb::mesh
