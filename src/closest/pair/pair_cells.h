// SPDX-License-Identifier: MIT
// Nodes of the tree of pieces of a spline, and below them parts of its pieces, each made when it is first
// asked for.
#pragma once

#include "pieces/tree/framed_pieces.h"

#include <optional>
#include <vector>

namespace nrb::closest {

struct PairCell {
    int level = 0;
    int64_t node = 0; // of the tree
    int halvings = 0; // of the piece of a node
    size_t mark = 0;  // for what a search knows about it; 0: nothing
    std::optional<pieces::BezierPiece> piece;
    const double *box = nullptr; // [2][dim]; infinite where the piece is not sound()
    double moved = 0; // what rounding does to a piece; 0 for other cells, whose boxes have room for it
    double size = 0;
    std::vector<PairCell> children; // which stay where they are
    std::vector<double> boxes;      // of children that are no pieces yet
};

class PairCells {
public:
    PairCells(const Spline &spline, const pieces::Frame &frame);

    [[nodiscard]] PairCell &root() noexcept { return root_; }
    // Makes the children; false if there can be none.
    bool split(PairCell &cell);
    // Makes the piece of a cell that is one, whose box is smaller than that of its disc.
    void tighten(PairCell &cell);
    // The most that rounding does to a piece whose weights are positive, of those made so far where no bound of
    // all is known.
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
