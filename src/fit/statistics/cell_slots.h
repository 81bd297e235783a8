// SPDX-License-Identifier: MIT
// Numbers for cells, in the order in which data reach them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace nrb::fit {

// The cells that were reached so far.
class CellSlots {
public:
    CellSlots(int64_t cells, int64_t points) {
        constexpr int64_t few = 1024;
        if (cells <= std::max(few, 4 * points)) {
            dense_.assign(static_cast<size_t>(cells), -1);
        }
    }
    // The number of a cell, by the order of arrival.
    int64_t of(int64_t cell) {
        int64_t &slot =
            dense_.empty() ? sparse_.try_emplace(cell, -1).first->second : dense_[static_cast<size_t>(cell)];
        if (slot < 0) {
            slot = std::ssize(cells_);
            cells_.push_back(cell);
        }
        return slot;
    }
    [[nodiscard]] const std::vector<int64_t> &cells() const noexcept { return cells_; }

private:
    std::vector<int64_t> dense_;
    std::unordered_map<int64_t, int64_t> sparse_;
    std::vector<int64_t> cells_;
};

} // namespace nrb::fit
