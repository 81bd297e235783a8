// SPDX-License-Identifier: MIT
// The hierarchy that a pair search descends on each spline: the nodes of the tree of its pieces and, below
// them, parts of the pieces. All are made on demand.
#pragma once

#include "pieces/tree/framed_pieces.h"

#include <optional>
#include <vector>

namespace nrb::closest {

struct PairCell {
    int level = 0;
    int64_t node = 0; // index in its level of the tree
    int halvings = 0; // how often the piece of the node was halved
    size_t mark = 0;  // refers to what a search knows about the cell; 0: nothing
    std::optional<pieces::BezierPiece> piece;
    const double *box = nullptr; // [2][dim]; infinite where the piece is not sound()
    double moved = 0; // how far rounding may have moved a piece; 0 for other cells, whose boxes allow for it
    double size = 0;
    std::vector<PairCell> children; // stable addresses
    std::vector<double> boxes;      // of children that are not pieces yet
};

class PairCells {
public:
    PairCells(const Spline &spline, const pieces::Frame &frame);

    [[nodiscard]] PairCell &root() noexcept { return root_; }
    // Makes the children; false if the cell cannot be divided.
    bool split(PairCell &cell);
    // If the cell is a node with a single piece, makes that piece; its box is smaller than that of its disc.
    void tighten(PairCell &cell);
    // The most that rounding moves a piece with positive weights; if no bound for all pieces is known, the
    // maximum over those made so far.
    [[nodiscard]] double moved() const noexcept { return moved_; }

private:
    void skip_single_children(PairCell &cell) const;
    void make_piece(PairCell &cell);
    void set_piece(PairCell &cell, pieces::BezierPiece made) const;
    void set_box(PairCell &cell, const double *box) const noexcept;
    bool halve(PairCell &cell) const;
    void add_children(PairCell &cell) const;
    [[nodiscard]] bool of_pieces(int level) const noexcept { return level + 1 == pieces_.tree().levels(); }

    pieces::FramedPieces pieces_;
    std::vector<double> root_box_, whole_space_;
    PairCell root_;
    double moved_;
};

} // namespace nrb::closest
