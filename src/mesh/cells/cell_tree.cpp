// SPDX-License-Identifier: MIT
#include "mesh/cells/cell_tree.h"

#include "base/watch.h"
#include "mesh/cells/cell_builder.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

CellBends CellBends::of(const HessianBox &box) noexcept {
    CellBends result;
    for (size_t c = 0; c < 3; ++c) {
        const Hessian &own = box.of(c);
        result.uu[c] = static_cast<float>(own.uu.middle);
        result.uv[c] = static_cast<float>(own.uv.middle);
        result.vv[c] = static_cast<float>(own.vv.middle);
    }
    return result;
}

CellTree::CellTree(const pieces::PieceGrid &grid, const CellRule &rule)
    : grid_(grid), rule_(rule), boxes_(std::make_unique<BoxTable>(grid, rule.wants_steps())) {
    constexpr int most_attempts = 3;
    for (int attempt = 1; true; ++attempt) {
        const bool was_ended = work_ended();
        const double done = Builder(grid, rule_, *this).build();
        if (done == 1 || was_ended || attempt == most_attempts) {
            return;
        }
        // The next attempt has half as much work as this one, and has to make do with less than that.
        coarsen(2.5 / std::max(done, 1e-4));
    }
}

// The number of cells is about inversely proportional to the chord error.
void CellTree::coarsen(double factor) {
    coarsening_ *= factor;
    rule_.chord *= factor;
    rule_.longest *= std::sqrt(factor);
    rule_.angle *= std::sqrt(factor);
    cells_.clear();
    nodes_.clear();
    roots_.clear();
    for (size_t k = 0; k < 2; ++k) {
        lines_[k].clear();
        blocks_[k].clear();
        block_ends_[k].clear();
    }
    boxes_ = std::make_unique<BoxTable>(grid_, rule_.wants_steps());
}

void CellTree::leave_to_border(const std::vector<int32_t> &cells) noexcept {
    for (const int32_t cell : cells) {
        cells_[static_cast<size_t>(cell)].side = Side::border;
    }
}

void CellTree::clear() noexcept {
    std::vector<Cell>().swap(cells_); // {} would keep the memory
    std::vector<Node>().swap(nodes_);
    boxes_.reset();
}

namespace {

// Makes room for so many more, and for the few of later rounds. Moving all elements takes time; but in large
// meshes spare capacity is a good part of all memory.
template <class T>
void make_room(std::vector<T> &values, size_t more) {
    if (values.capacity() < values.size() + more) {
        values.reserve(values.size() + std::max(more, values.size() / 32));
    }
}

} // namespace

void CellTree::cut(const std::vector<int32_t> &cells) {
    Builder builder(grid_, rule_, *this);
    make_room(cells_, cells.size());
    make_room(nodes_, 3 * cells.size());
    for (const int32_t cell : cells) {
        builder.cut(cell);
    }
    builder.sort_lines();
}

int32_t CellTree::block_at(const std::array<double, 2> &x) const noexcept {
    std::array<int64_t, 2> at{};
    for (size_t k = 0; k < 2; ++k) {
        const auto &ends = block_ends_[k];
        at[k] = std::upper_bound(ends.begin() + 1, ends.end() - 1, x[k]) - ends.begin() - 1;
    }
    return static_cast<int32_t>(at[0] * (std::ssize(block_ends_[1]) - 1) + at[1]);
}

Rectangle CellTree::block(int32_t number) const noexcept {
    const int64_t across = std::ssize(block_ends_[1]) - 1;
    Rectangle result;
    for (size_t k = 0; k < 2; ++k) {
        const auto at = static_cast<size_t>(k == 0 ? number / across : number % across);
        result.lower[k] = block_ends_[k][at];
        result.upper[k] = block_ends_[k][at + 1];
    }
    return result;
}

Rectangle CellTree::rectangle(const Cell &cell) const noexcept {
    Rectangle result;
    for (size_t k = 0; k < 2; ++k) {
        result.lower[k] = lines_[k][static_cast<size_t>(cell.lower[k])].t;
        result.upper[k] = lines_[k][static_cast<size_t>(cell.upper[k])].t;
    }
    return result;
}

} // namespace nrb::mesh
