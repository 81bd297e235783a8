// SPDX-License-Identifier: MIT
// The distance from planes, over a surface.
#pragma once

#include "intersect/levels/fields/level_field.h"

#include <vector>

namespace nrb::intersect {

// x . n - level in the frame of the pieces, n a unit vector. Precondition: a surface in space.
class PlaneField final : public LevelField {
public:
    PlaneField(const pieces::PieceGrid &grid, const std::array<double, 3> &normal);

    // Known to within an error. Pieces are compared with it first by the ranges of their coefficients.
    void set_level(double level, double error) noexcept;

    [[nodiscard]] std::array<int, 2> degrees() const override { return degrees_; }
    [[nodiscard]] bool may_vanish(int64_t piece) override;
    LevelNet net(int64_t piece) override;
    [[nodiscard]] bool may_jump() const noexcept override { return false; }
    [[nodiscard]] std::optional<std::array<double, 4>> form() const override {
        return std::array<double, 4>{normal_[0], normal_[1], normal_[2], -level_};
    }
    [[nodiscard]] double resolution(double tolerance) const noexcept override { return tolerance; }

private:
    LevelNet distances(int64_t piece);
    [[nodiscard]] double absolute_noise() const noexcept;

    std::array<double, 3> normal_;
    std::array<int, 2> degrees_{};
    double level_ = 0;
    Noise noise_;
    std::vector<double> work_, patch_;
    std::vector<Interval> ranges_; // of x . n on the pieces
};

} // namespace nrb::intersect
