// SPDX-License-Identifier: MIT
// Functions over a surface whose zeros are asked for, piece by piece in Bernstein form.
#pragma once

#include "intersect/levels/trace/level_net.h"
#include "pieces/tree/piece_grid.h"

#include <array>
#include <optional>

namespace nrb::intersect {

class LevelField {
public:
    explicit LevelField(const pieces::PieceGrid &grid) : grid_(grid) {}
    virtual ~LevelField() = default;
    LevelField(const LevelField &) = delete;
    LevelField &operator=(const LevelField &) = delete;

    [[nodiscard]] const pieces::PieceGrid &grid() const noexcept { return grid_; }
    // Of all nets.
    [[nodiscard]] virtual std::array<int, 2> degrees() const = 0;
    // Whether there may be zeros on a piece: a quick look.
    [[nodiscard]] virtual bool may_vanish(int64_t piece) = 0;
    virtual LevelNet net(int64_t piece) = 0;
    // f w as a linear form of (x, y, z, w), if it is one.
    [[nodiscard]] virtual std::optional<std::array<double, 4>> form() const { return std::nullopt; }
    // Whether a zero counts, at a place on a piece.
    [[nodiscard]] virtual bool counts(int64_t, const std::array<double, 2> &) { return true; }
    // Whether the zeros of a piece may end at a side behind which the surface goes on.
    [[nodiscard]] virtual bool may_jump() const noexcept = 0;
    // Weights of the surface above this are known to be positive.
    [[nodiscard]] double least_weight() const noexcept {
        return grid_.positive() ? 0 : 64 * grid_.rounding().weight;
    }
    // Up to which |f| zeros need not be told apart if they matter to within a tolerance in space; 0: at none.
    [[nodiscard]] virtual double resolution(double tolerance) const noexcept = 0;

private:
    const pieces::PieceGrid &grid_;
};

} // namespace nrb::intersect
