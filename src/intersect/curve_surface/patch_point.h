// SPDX-License-Identifier: MIT
// Points and derivatives of Bezier surface pieces, with memory that is reused.
#pragma once

#include "intersect/contraction.h"
#include "pieces/bezier_piece.h"

#include <vector>

namespace nrb::intersect {

class PatchPoint {
public:
    // At any place, also beyond [0, 1]^2. Precondition: the piece has two axes.
    void evaluate(const pieces::BezierPiece &piece, const Place<2> &place);

    [[nodiscard]] const double *value() const noexcept { return value_.data(); }
    // With respect to the local parameter along an axis.
    [[nodiscard]] const double *derivative(int axis) const noexcept {
        return derivatives_.data() + axis * dim_;
    }

private:
    int dim_ = 0;
    std::vector<double> records_, along_, value_, derivatives_;
};

} // namespace nrb::intersect
