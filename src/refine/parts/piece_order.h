// SPDX-License-Identifier: MIT
// Two orders of the control points of a net in which every axis is decomposed: as one net, in which the
// pieces lie side by side along each axis, or one piece after the other, as callers want them.
#pragma once

#include "spline/spline.h"

#include <array>
#include <span>

namespace nrb::refine {

// The numbers of pieces and of layers of a piece along every axis. Missing axes come first, with one piece of
// one layer.
class PieceOrder {
public:
    // One axis: the number of its pieces, and the number of layers of each.
    struct Axis {
        int64_t pieces;
        int64_t layers;
    };
    explicit PieceOrder(std::span<const Axis> axes);

    // From `net`, which has all layers of each axis side by side, to one piece after the other, last axis
    // fastest in both. Records have `width` doubles.
    void take_apart(int width, const double *net, double *pieces) const noexcept;
    // The inverse of take_apart().
    void put_together(int width, const double *pieces, double *net) const noexcept;

private:
    // Whether both orders are the same, as for curves.
    [[nodiscard]] bool same() const noexcept {
        return pieces_[0] * layers_[0] == 1 && pieces_[1] * layers_[1] == 1;
    }
    // Calls body(index of a row in the net) for the rows of one piece after the other. A row is the records
    // of a piece along the last axis; its index counts rows of that length.
    template <class Body>
    void for_each_row(Body &&body) const noexcept;

    std::array<int64_t, max_axes> layers_{1, 1, 1};
    std::array<int64_t, max_axes> pieces_{1, 1, 1};
};

} // namespace nrb::refine
