// SPDX-License-Identifier: MIT
// One of the surfaces that a search looks for common points of.
#pragma once

#include "closest/pair/pair_cells.h"
#include "intersect/surfaces/cross_cell.h"

#include <deque>
#include <memory_resource>
#include <vector>

namespace nrb::intersect {

constexpr int64_t work_of_a_kept_part = 4000; // memory ends with the work
// Of pairs of pieces that are to be looked at: where there are more than the work is enough for, groups of them are left open.
constexpr int64_t work_of_a_pair = 1000;

// Its pieces in a tree of boxes, and those that were asked for in parts.
struct CrossSide {
    CrossSide(const Spline &surface, const pieces::Frame &frame, const SurfaceBorders &ends,
              const SideShifts &shifts_of_axes);
    // All of a piece with positive weights.
    CrossCell &root(closest::PairCell &cell);

    CrossGround ground;
    closest::PairCells cells;
    std::deque<CrossPiece> pieces;
    std::pmr::monotonic_buffer_resource memory; // of the parts, which are many: it is given back at once
    std::deque<CrossCell> parts;
    std::vector<CrossCell *> roots; // by marks of cells
};

inline bool is_positive(const closest::PairCell &cell) noexcept {
    return cell.piece && cell.piece->positive();
}

} // namespace nrb::intersect
