// SPDX-License-Identifier: MIT
// The pieces of a spline in a tree of boxes, each halved when it is first asked for.
#pragma once

#include "pieces/bezier_piece.h"

#include <memory>

namespace nrb::closest {

struct PairCell {
    std::optional<pieces::BezierPiece> piece; // none: a group
    std::vector<double> box;                  // [2][dim]; infinite where weights are not positive
    double moved = 0;                         // of all pieces in it, at most
    double size = 0;
    std::array<std::unique_ptr<PairCell>, 2> children;

    // Makes the children; false if there can be none.
    bool split();
};

// Precondition: there is a piece.
std::unique_ptr<PairCell> pair_cells(std::vector<pieces::BezierPiece> pieces);

} // namespace nrb::closest
