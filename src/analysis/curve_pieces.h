// SPDX-License-Identifier: MIT
// The pieces of a curve, and what its knots guarantee.
#pragma once

#include "pieces/derivative_pieces.h"

#include <optional>
#include <vector>

namespace nrb::analysis {

// Pieces, with the seam of a periodic curve as a knot. Each is asked for more than once: those of usual curves are
// kept, and of long ones those of the neighbourhood, because it takes long to free many.
class CurvePieces {
public:
    explicit CurvePieces(const Spline &curve);

    [[nodiscard]] bool periodic() const noexcept { return curve_.axis(0).periodic(); }
    [[nodiscard]] size_t count() const noexcept { return maker_.breaks(0).size() - 1; }
    [[nodiscard]] double start(size_t e) const noexcept { return maker_.breaks(0)[e]; }
    [[nodiscard]] double end(size_t e) const noexcept { return maker_.breaks(0)[e + 1]; }
    // Valid until others are asked for, but for the one before.
    [[nodiscard]] const pieces::HomogeneousPiece &piece(size_t e);
    // The piece before piece e, or null.
    [[nodiscard]] const pieces::HomogeneousPiece *before(size_t e);
    // The order of continuity that the knot at the start of piece e guarantees.
    [[nodiscard]] int order(size_t e) const noexcept;
    // The distance of the two limits at the start of piece e; 0 if rounding may have caused it.
    [[nodiscard]] double jump(size_t e) const;

private:
    struct Kept {
        size_t index = 0;
        std::optional<pieces::HomogeneousPiece> piece;
    };

    const Spline &curve_;
    pieces::PieceMaker maker_;
    std::vector<Kept> kept_; // piece e in place e modulo their number
    Kept last_;
};

} // namespace nrb::analysis
