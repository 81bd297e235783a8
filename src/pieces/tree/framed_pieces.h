// SPDX-License-Identifier: MIT
// The piece tree of a spline seen in another frame, which several splines share.
#pragma once

#include "pieces/bezier_piece.h"
#include "pieces/tree/piece_tree.h"

namespace nrb::pieces {

// A point x of the tree is x 2^exponent + shift in the frame. The rounding of the change of frame is included
// in the boxes, and in the rounding of the pieces.
class FramedPieces {
public:
    FramedPieces(const PieceTree &tree, const Frame &frame);

    [[nodiscard]] const PieceTree &tree() const noexcept { return tree_; }
    [[nodiscard]] int dim() const noexcept { return static_cast<int>(shift_.size()); }
    // The boxes of the tree in the frame.
    void box(int level, int64_t node, double *out) const;
    void disc_box(int level, int64_t node, int64_t i, double *out) const noexcept;
    [[nodiscard]] BezierPiece piece(int64_t index) const;
    // An upper bound of moved() over all pieces, if errors are relative to the weights; otherwise 0.
    [[nodiscard]] double moved() const noexcept { return moved_; }

private:
    void set_rounding() noexcept;
    void move(double *box) const noexcept;

    const PieceTree &tree_;
    int exponent_;
    std::vector<double> shift_;
    BernsteinShape shape_; // of a piece, with the weight: (A, w)
    Rounding rounding_;
    double moved_ = 0;
};

} // namespace nrb::pieces
