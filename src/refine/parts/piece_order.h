// SPDX-License-Identifier: MIT
// The pieces of a net in which every axis is decomposed: side by side, as an operation along the axes makes them, or one
// after the other, as callers want them.
#pragma once

#include "spline/spline.h"

#include <array>
#include <span>

namespace nrb::refine {

// The pieces along every axis, and the layers of each piece. Missing axes come first, with one of each.
class PieceOrder {
public:
    // `piece` axes: the number of pieces and of the layers of one.
    struct Axis {
        int64_t pieces;
        int64_t layers;
    };
    explicit PieceOrder(std::span<const Axis> axes);

    // pieces: the records of `net`, which has all layers of each axis side by side, one piece after the other; last
    // axis fastest. Both have room for `width` doubles a record.
    void take_apart(int width, const double *net, double *pieces) const noexcept;
    // The way back.
    void put_together(int width, const double *pieces, double *net) const noexcept;

private:
    // Whether both orders are the same, as for curves.
    [[nodiscard]] bool same() const noexcept {
        return pieces_[0] * layers_[0] == 1 && pieces_[1] * layers_[1] == 1;
    }
    // Calls body(place in the net) for every row of the pieces in turn, the records along the last axis of one.
    template <class Body>
    void for_each_row(Body &&body) const noexcept;

    std::array<int64_t, max_axes> layers_{1, 1, 1};
    std::array<int64_t, max_axes> pieces_{1, 1, 1};
};

} // namespace nrb::refine
