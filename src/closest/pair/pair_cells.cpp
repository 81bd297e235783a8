// SPDX-License-Identifier: MIT
#include "closest/pair/pair_cells.h"

#include "base/numbers.h"

#include <algorithm>

namespace nrb::closest {

PairCells::PairCells(const Spline &spline, const pieces::Frame &frame)
    : pieces_(pieces::piece_tree_of(spline), frame), root_box_(2 * static_cast<size_t>(spline.dim())),
      whole_space_(root_box_.size(), infinity), moved_(pieces_.moved()) {
    std::fill_n(whole_space_.begin(), spline.dim(), -infinity);
    pieces_.box(0, 0, root_box_.data());
    set_box(root_, root_box_.data());
    skip_single_children(root_);
}

void PairCells::set_box(PairCell &cell, const double *box) const noexcept {
    cell.box = box;
    cell.size = 0;
    for (int c = 0; c < pieces_.dim(); ++c) {
        cell.size = std::max(cell.size, box[pieces_.dim() + c] - box[c]);
    }
}

void PairCells::set_piece(PairCell &cell, pieces::BezierPiece made) const {
    cell.piece = std::move(made);
    if (cell.piece->sound()) {
        cell.box = cell.piece->lower();
        cell.size = cell.piece->size();
        cell.moved = cell.piece->moved();
    } else {
        cell.box = whole_space_.data();
        cell.size = infinity;
    }
}

// A node with an only child represents the same pieces as the child.
void PairCells::skip_single_children(PairCell &cell) const {
    while (!of_pieces(cell.level) && pieces_.tree().family(cell.level, cell.node).count == 1) {
        cell.node = pieces_.tree().family(cell.level++, cell.node).first;
    }
}

void PairCells::make_piece(PairCell &cell) {
    set_piece(cell, pieces_.piece(pieces_.tree().order()[static_cast<size_t>(cell.node)]));
    moved_ = std::max(moved_, cell.moved);
}

void PairCells::tighten(PairCell &cell) {
    if (!cell.piece && of_pieces(cell.level)) {
        make_piece(cell);
    }
}

bool PairCells::halve(PairCell &cell) const {
    pieces::BezierPiece upper = *cell.piece;
    std::optional<pieces::BezierPiece> lower = upper.halve();
    if (!lower) {
        return false;
    }
    cell.children.reserve(2);
    for (pieces::BezierPiece *half : {&*lower, &upper}) {
        PairCell &child = cell.children.emplace_back();
        child.halvings = cell.halvings + 1;
        set_piece(child, std::move(*half));
    }
    return true;
}

void PairCells::add_children(PairCell &cell) const {
    const pieces::PieceTree::Family family = pieces_.tree().family(cell.level, cell.node);
    const auto count = static_cast<size_t>(family.count), width = root_box_.size();
    cell.children.reserve(count);
    cell.boxes.resize(count * width);
    for (size_t i = 0; i < count; ++i) {
        PairCell &child = cell.children.emplace_back();
        child.level = cell.level + 1;
        child.node = family.first + static_cast<int64_t>(i);
        double *const box = &cell.boxes[i * width];
        if (of_pieces(child.level)) {
            pieces_.disc_box(cell.level, cell.node, static_cast<int64_t>(i), box);
        } else {
            pieces_.box(child.level, child.node, box);
        }
        set_box(child, box);
        skip_single_children(child);
    }
}

bool PairCells::split(PairCell &cell) {
    if (!cell.children.empty()) {
        return true;
    }
    tighten(cell);
    if (cell.piece) {
        return halve(cell);
    }
    add_children(cell);
    return true;
}

} // namespace nrb::closest
