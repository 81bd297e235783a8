// SPDX-License-Identifier: MIT
#include "closest/pair/pair_cells.h"

#include "base/numbers.h"

#include <algorithm>

namespace nrb::closest {

void PairCell::set_piece(pieces::BezierPiece made) {
    const auto dim = static_cast<size_t>(made.dim());
    if (made.sound()) {
        box.assign(made.lower(), made.lower() + 2 * dim);
        size = made.size();
        moved = made.moved();
    } else {
        box.assign(dim, -infinity);
        box.insert(box.end(), dim, infinity);
        size = infinity;
    }
    piece = std::move(made);
}

void PairCell::set_size() noexcept {
    const size_t dim = box.size() / 2;
    size = 0;
    for (size_t c = 0; c < dim; ++c) {
        size = std::max(size, box[dim + c] - box[c]);
    }
}

PairCells::PairCells(const Spline &spline, const pieces::Frame &frame)
    : pieces_(pieces::piece_tree_of(spline), frame), moved_(pieces_.moved()) {
    root_.box.resize(2 * static_cast<size_t>(spline.dim()));
    pieces_.box(0, 0, root_.box.data());
    root_.set_size();
    skip_single_children(root_);
}

// A node is the same set of pieces as its only child.
void PairCells::skip_single_children(PairCell &cell) const {
    while (!of_pieces(cell.level) && pieces_.tree().family(cell.level, cell.node).count == 1) {
        cell.node = pieces_.tree().family(cell.level++, cell.node).first;
    }
}

void PairCells::make_piece(PairCell &cell) {
    cell.set_piece(pieces_.piece(pieces_.tree().order()[static_cast<size_t>(cell.node)]));
    moved_ = std::max(moved_, cell.moved);
}

void PairCells::tighten(PairCell &cell) {
    if (!cell.piece && of_pieces(cell.level)) {
        make_piece(cell);
    }
}

bool PairCells::halve(PairCell &cell) {
    pieces::BezierPiece upper = *cell.piece;
    std::optional<pieces::BezierPiece> lower = upper.halve();
    if (!lower) {
        return false;
    }
    for (pieces::BezierPiece *half : {&*lower, &upper}) {
        cell.children.push_back(std::make_unique<PairCell>());
        cell.children.back()->halvings = cell.halvings + 1;
        cell.children.back()->set_piece(std::move(*half));
    }
    return true;
}

void PairCells::add_children(PairCell &cell) const {
    const pieces::PieceTree::Family family = pieces_.tree().family(cell.level, cell.node);
    for (int64_t i = 0; i < family.count; ++i) {
        auto child = std::make_unique<PairCell>();
        child->level = cell.level + 1;
        child->node = family.first + i;
        child->box.resize(cell.box.size());
        if (of_pieces(child->level)) {
            pieces_.disc_box(cell.level, cell.node, i, child->box.data());
        } else {
            pieces_.box(child->level, child->node, child->box.data());
        }
        child->set_size();
        skip_single_children(*child);
        cell.children.push_back(std::move(child));
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
