// SPDX-License-Identifier: MIT
// How the borders of a surface are joined.
#pragma once

#include "pieces/tree/piece_grid.h"

#include <array>
#include <vector>

namespace nrb::intersect {

// Of a surface whose axes may be periodic, or end where they begin, or have sides of one point, all to rounding.
class SurfaceBorders {
public:
    explicit SurfaceBorders(const pieces::PieceGrid &grid);

    // Whether the surface goes on beyond the lower or upper side of the pieces with index i along an axis.
    [[nodiscard]] bool goes_on(size_t axis, int64_t i, bool up) const noexcept {
        return grid_.neighbour(static_cast<int>(axis), i, up) >= 0 || (closed_[axis] && is_side(axis, i, up));
    }
    // Whether it goes on beyond the ends of the domain.
    [[nodiscard]] bool wraps(size_t axis) const noexcept { return goes_on(axis, 0, false); }
    // Whether the axis is periodic there, so that parameters go on too.
    [[nodiscard]] bool is_periodic(size_t axis) const noexcept {
        return grid_.neighbour(static_cast<int>(axis), 0, false) >= 0;
    }
    [[nodiscard]] double period(size_t axis) const noexcept;
    // Whether a side of the surface is one point.
    [[nodiscard]] bool is_collapsed(size_t axis, int64_t i, bool up) const noexcept {
        return is_side(axis, i, up) && collapsed_[axis][up ? 1 : 0];
    }
    // Whether parameters are on a side where the surface ends or jumps.
    [[nodiscard]] bool is_end(const std::array<double, 2> &at) const noexcept;

private:
    [[nodiscard]] bool is_side(size_t axis, int64_t i, bool up) const noexcept {
        return up ? i + 1 == grid_.count(static_cast<int>(axis)) : i == 0;
    }
    // Points of the coefficients on a side, piece by piece, and their weights.
    [[nodiscard]] std::vector<double> side(size_t axis, bool up) const;

    const pieces::PieceGrid &grid_;
    std::array<bool, 2> closed_{};
    std::array<std::array<bool, 2>, 2> collapsed_{};
};

} // namespace nrb::intersect
