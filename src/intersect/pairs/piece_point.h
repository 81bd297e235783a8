// SPDX-License-Identifier: MIT
// Points and derivatives of Bezier curve pieces, with memory that is reused.
#pragma once

#include "pieces/bezier_piece.h"

#include <vector>

namespace nrb::intersect {

class PiecePoint {
public:
    // Precondition: piece.positive().
    void evaluate(const pieces::BezierPiece &piece, double place);

    [[nodiscard]] const double *value() const noexcept { return value_.data(); }
    // With respect to the local parameter.
    [[nodiscard]] const double *derivative() const noexcept { return derivative_.data(); }

private:
    std::vector<double> records_, value_, derivative_;
};

} // namespace nrb::intersect
