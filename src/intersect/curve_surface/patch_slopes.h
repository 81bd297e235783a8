// SPDX-License-Identifier: MIT
// The partial derivatives of a surface piece.
#pragma once

#include "pieces/slopes.h"

#include <array>
#include <optional>

namespace nrb::intersect {

// The hulls of both partial derivatives are made on demand: those of rational pieces have many vectors, and
// the derivatives at the corners are often enough.
class PatchSlopes {
public:
    // Precondition: piece.positive(), of two axes, in space. The piece stays where it is.
    explicit PatchSlopes(const pieces::BezierPiece &piece);

    // The derivatives along an axis at the four corners, and their mean.
    [[nodiscard]] const double *corner(int axis, int i) const noexcept {
        return corners_[static_cast<size_t>(axis)].data() + 3 * i;
    }
    [[nodiscard]] const double *mean(int axis) const noexcept { return corner(axis, 4); }
    [[nodiscard]] const pieces::Slopes &along(int axis);

private:
    const pieces::BezierPiece *piece_;
    std::array<std::array<double, 15>, 2> corners_{}; // the mean is the last one
    std::array<std::optional<pieces::Slopes>, 2> along_;
};

} // namespace nrb::intersect
