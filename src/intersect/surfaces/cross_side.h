// SPDX-License-Identifier: MIT
// One of the two surfaces of a search for common points.
#pragma once

#include "closest/pair/pair_cells.h"
#include "intersect/surfaces/cross_cell.h"

#include <deque>
#include <memory_resource>
#include <vector>

namespace nrb::intersect {

constexpr int64_t work_of_a_kept_part = 4000; // so that the limit of work limits memory, too
// For each pair of pieces that is to be examined: where there are more pairs than the work suffices for,
// whole groups of pieces are left open.
constexpr int64_t work_of_a_pair = 1000;

// Its pieces in a tree of boxes, and the cells of the pieces that were asked for.
struct CrossSide {
    CrossSide(const Spline &surface, const pieces::Frame &frame, const SurfaceBorders &ends,
              const SideShifts &shifts_of_axes);
    // The cell of a whole piece, made at the first call. Precondition: is_positive(cell).
    CrossCell &root(closest::PairCell &cell);

    CrossGround ground;
    closest::PairCells cells;
    std::deque<CrossPiece> pieces;
    std::pmr::monotonic_buffer_resource memory; // of the parts, which are many; freed all at once
    std::deque<CrossCell> parts;
    std::vector<CrossCell *> roots; // by the marks of PairCells, from 1
};

inline bool is_positive(const closest::PairCell &cell) noexcept {
    return cell.piece && cell.piece->positive();
}

} // namespace nrb::intersect
