// SPDX-License-Identifier: MIT
#include "mesh/cells/box_table.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

constexpr size_t fewest_slots = 64, most_slots = 4096;

} // namespace

// Until there are as many as there may be, cells are at their numbers.
BoxTable::Slot &BoxTable::slot(int32_t cell) {
    const auto number = static_cast<size_t>(cell);
    while (number >= slots_.size() && slots_.size() < most_slots) {
        slots_.resize(std::max(fewest_slots, 2 * slots_.size()));
    }
    return slots_[number % slots_.size()];
}

void BoxTable::keep(int32_t cell, const HessianBox &box) {
    slot(cell) = {cell, box};
}

const HessianBox &BoxTable::box(int32_t cell, const Rectangle &part) {
    Slot &own = slot(cell);
    if (own.cell != cell) {
        own = {cell, nets_.box(part, nets_.pieces_in(part), steps_)};
    }
    return own.box;
}

} // namespace nrb::mesh
