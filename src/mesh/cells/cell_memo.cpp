// SPDX-License-Identifier: MIT
#include "mesh/cells/cell_memo.h"

namespace nrb::mesh {

int32_t CellMemo::add_parts(int32_t count) {
    if (*room_ < count) {
        return unknown;
    }
    *room_ -= count;
    const auto first = static_cast<int32_t>(parts_.size());
    parts_.resize(parts_.size() + static_cast<size_t>(count));
    return first;
}

int32_t CellMemo::first(const Rectangle &part, int divisions) {
    const std::array<double, 5> key{part.lower[0], part.lower[1], part.upper[0], part.upper[1],
                                    1.0 * divisions};
    if (const auto found = firsts_.find(key); found != firsts_.end()) {
        return found->second;
    }
    const int32_t number = add_parts(1);
    if (number != unknown) {
        firsts_[key] = number;
    }
    return number;
}

std::array<int32_t, 2> CellMemo::halves(int32_t parent, size_t axis, double at) {
    if (parent == unknown) {
        return {unknown, unknown};
    }
    const int32_t newest = parts_[static_cast<size_t>(parent)].halves;
    for (int32_t i = newest; i != unknown; i = halves_[static_cast<size_t>(i)].next) {
        const Halves &own = halves_[static_cast<size_t>(i)];
        if (own.axis == axis && own.at == at) {
            return {own.first, own.first + 1};
        }
    }
    const int32_t first = add_parts(2);
    if (first == unknown) {
        return {unknown, unknown};
    }
    parts_[static_cast<size_t>(parent)].halves = static_cast<int32_t>(halves_.size());
    halves_.push_back({axis, at, first, newest});
    return {first, first + 1};
}

const LookedAt *CellMemo::find(int32_t number) const noexcept {
    const int32_t place = number == unknown ? unknown : parts_[static_cast<size_t>(number)].known;
    if (place == unknown) {
        return nullptr;
    }
    const auto at = static_cast<size_t>(place);
    return &(*known_[at / block])[at % block];
}

void CellMemo::keep(int32_t number, const LookedAt &looked) {
    if (number == unknown) {
        return;
    }
    if (count_ % block == 0) {
        known_.push_back(std::make_unique<std::array<LookedAt, block>>());
    }
    (*known_.back())[count_ % block] = looked;
    parts_[static_cast<size_t>(number)].known = static_cast<int32_t>(count_++);
}

} // namespace nrb::mesh
