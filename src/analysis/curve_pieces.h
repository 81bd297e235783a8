// SPDX-License-Identifier: MIT
// The Bezier pieces of a curve, and the continuity that its knots guarantee.
#pragma once

#include "pieces/derivative_pieces.h"

#include <optional>
#include <vector>

namespace nrb::analysis {

// The pieces, with the seam of a periodic curve as a knot. Each piece is requested more than once. Up to some
// thousand pieces all are kept; of longer curves only those in the neighbourhood, because freeing many takes
// long.
class CurvePieces {
public:
    explicit CurvePieces(const Spline &curve);

    [[nodiscard]] bool periodic() const noexcept { return curve_.axis(0).periodic(); }
    [[nodiscard]] size_t count() const noexcept { return maker_.breaks(0).size() - 1; }
    [[nodiscard]] double start(size_t e) const noexcept { return maker_.breaks(0)[e]; }
    [[nodiscard]] double end(size_t e) const noexcept { return maker_.breaks(0)[e + 1]; }
    // Valid until another piece except the one before is requested.
    [[nodiscard]] const pieces::HomogeneousPiece &piece(size_t e);
    // The piece before piece e, across the seam if the axis is periodic; null if there is none.
    [[nodiscard]] const pieces::HomogeneousPiece *before(size_t e);
    // The order of continuity that the knot at the start of piece e guarantees.
    [[nodiscard]] int order(size_t e) const noexcept;
    // The distance of the two limits at the start of piece e; 0 if it may be due to rounding.
    [[nodiscard]] double jump(size_t e) const;

private:
    struct Kept {
        size_t index = 0;
        std::optional<pieces::HomogeneousPiece> piece;
    };

    const Spline &curve_;
    pieces::PieceMaker maker_;
    std::vector<Kept> kept_; // piece e is at e modulo their number
    Kept last_;
};

} // namespace nrb::analysis
