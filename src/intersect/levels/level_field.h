// SPDX-License-Identifier: MIT
// A function over a surface, piece by piece in Bernstein form.
#pragma once

#include "intersect/levels/level_net.h"
#include "pieces/tree/piece_grid.h"

#include <array>
#include <span>
#include <vector>

namespace nrb::intersect {

// f(u, v) = h(u, v) / w(u, v), both of degrees degree(0), degree(1); without weights w = 1. Coefficients are
// [degree(0) + 1][degree(1) + 1]; noise() says to within what those of h are known.
class LevelField {
public:
    explicit LevelField(const pieces::PieceGrid &grid) : grid_(grid) {}
    virtual ~LevelField() = default;
    LevelField(const LevelField &) = delete;
    LevelField &operator=(const LevelField &) = delete;

    [[nodiscard]] const pieces::PieceGrid &grid() const noexcept { return grid_; }
    [[nodiscard]] virtual int degree(int axis) const noexcept = 0;
    [[nodiscard]] virtual Noise noise() const noexcept = 0;
    // Whether weights are there.
    [[nodiscard]] virtual bool weighted() const noexcept = 0;
    // Weights above this are known to be positive.
    [[nodiscard]] double least_weight() const noexcept {
        return grid_.positive() ? 0 : 64 * grid_.rounding().weight;
    }
    virtual void net(int64_t piece, std::span<double> values, std::span<double> weights) = 0;

    [[nodiscard]] size_t coefficients() const noexcept {
        return static_cast<size_t>(degree(0) + 1) * static_cast<size_t>(degree(1) + 1);
    }

private:
    const pieces::PieceGrid &grid_;
};

// x . n in the frame of the pieces, n a unit vector. Precondition: a surface in space.
class PlaneField final : public LevelField {
public:
    PlaneField(const pieces::PieceGrid &grid, const std::array<double, 3> &normal);

    [[nodiscard]] int degree(int axis) const noexcept override;
    [[nodiscard]] Noise noise() const noexcept override { return noise_; }
    [[nodiscard]] bool weighted() const noexcept override { return grid().shape().weighted; }
    void net(int64_t piece, std::span<double> values, std::span<double> weights) override;

private:
    std::array<double, 3> normal_;
    std::array<int, 2> degrees_{};
    Noise noise_;
    std::vector<double> work_, patch_;
};

} // namespace nrb::intersect
