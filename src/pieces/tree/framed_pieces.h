// SPDX-License-Identifier: MIT
// The tree of pieces of a spline as it is seen in another frame, which several splines have in common.
#pragma once

#include "pieces/bezier_piece.h"
#include "pieces/tree/piece_tree.h"

namespace nrb::pieces {

// A point x of the tree is x 2^exponent + shift in the frame. What the change of frame rounds is in the
// boxes, and in the rounding of the pieces.
class FramedPieces {
public:
    FramedPieces(const PieceTree &tree, const Frame &frame);

    [[nodiscard]] const PieceTree &tree() const noexcept { return tree_; }
    [[nodiscard]] int dim() const noexcept { return static_cast<int>(shift_.size()); }
    // A box [2][dim] around child i of a node, with all that rounding does to its pieces; infinite where
    // weights are not positive for certain.
    void box(int level, int64_t node, int64_t i, double *out) const noexcept;
    [[nodiscard]] BezierPiece piece(int64_t index) const;

private:
    void set_rounding() noexcept;

    const PieceTree &tree_;
    int exponent_;
    std::vector<double> shift_;
    BernsteinShape shape_; // of a piece, (A, w)
    Rounding rounding_;
};

} // namespace nrb::pieces
