// SPDX-License-Identifier: MIT
#include "closest/pair/pair_cells.h"

#include "base/numbers.h"

#include <algorithm>
#include <span>

namespace nrb::closest {

namespace {

std::unique_ptr<PairCell> cell_of(pieces::BezierPiece piece) {
    auto cell = std::make_unique<PairCell>();
    const auto dim = static_cast<size_t>(piece.dim());
    if (piece.positive()) {
        cell->box.assign(piece.lower(), piece.lower() + 2 * dim);
        cell->size = piece.size();
        cell->moved = piece.moved();
    } else {
        cell->box.assign(dim, -infinity);
        cell->box.insert(cell->box.end(), dim, infinity);
        cell->size = infinity;
    }
    cell->piece = std::move(piece);
    return cell;
}

std::unique_ptr<PairCell> group(std::unique_ptr<PairCell> a, std::unique_ptr<PairCell> b) {
    auto cell = std::make_unique<PairCell>();
    const size_t dim = a->box.size() / 2;
    cell->box = a->box;
    for (size_t c = 0; c < dim; ++c) {
        cell->box[c] = std::min(a->box[c], b->box[c]);
        cell->box[dim + c] = std::max(a->box[dim + c], b->box[dim + c]);
        cell->size = std::max(cell->size, cell->box[dim + c] - cell->box[c]);
    }
    cell->moved = std::max(a->moved, b->moved);
    cell->children = {std::move(a), std::move(b)};
    return cell;
}

// Halves the list across the widest side of the middles.
std::unique_ptr<PairCell> tree_of(std::span<std::unique_ptr<PairCell>> cells) {
    if (cells.size() == 1) {
        return std::move(cells.front());
    }
    const size_t dim = cells.front()->box.size() / 2;
    size_t widest = 0;
    double width = -1;
    for (size_t c = 0; c < dim; ++c) {
        const auto [low, high] = std::minmax_element(
            cells.begin(), cells.end(), [c](const auto &x, const auto &y) { return x->box[c] < y->box[c]; });
        if ((*high)->box[c] - (*low)->box[c] > width) {
            width = (*high)->box[c] - (*low)->box[c];
            widest = c;
        }
    }
    const size_t half = cells.size() / 2;
    std::nth_element(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(half), cells.end(),
                     [widest](const auto &x, const auto &y) { return x->box[widest] < y->box[widest]; });
    auto lower = tree_of(cells.first(half)), upper = tree_of(cells.subspan(half));
    return group(std::move(lower), std::move(upper));
}

} // namespace

bool PairCell::split() {
    if (children[0]) {
        return true;
    }
    pieces::BezierPiece upper = *piece;
    std::optional<pieces::BezierPiece> lower = upper.halve();
    if (!lower) {
        return false;
    }
    children = {cell_of(std::move(*lower)), cell_of(std::move(upper))};
    return true;
}

std::unique_ptr<PairCell> pair_cells(std::vector<pieces::BezierPiece> pieces) {
    std::vector<std::unique_ptr<PairCell>> cells;
    cells.reserve(pieces.size());
    for (pieces::BezierPiece &piece : pieces) {
        cells.push_back(cell_of(std::move(piece)));
    }
    return tree_of(cells);
}

} // namespace nrb::closest
