// SPDX-License-Identifier: MIT
// What a scalar spline of several axes does where it jumps.
#pragma once

#include "intersect/extrema/fields/stratum.h"

namespace nrb::intersect {

// A jump is seen as a wall between both limits, steep and straight, and where two of them cross as the bilinear function of
// the four limits. Such a function is stationary inside at most where its slopes change their signs.
class Walls {
public:
    Walls(const Spline &spline, const GradientField &field);

    // 1 or -1: f is larger or smaller above the joint of axis k than below it, on all of a piece of a stratum; 0: not certain.
    [[nodiscard]] int sign(const Stratum &stratum, const PieceIndex &index, int k) const;
    // Whether nothing is stationary inside of the walls that meet in a piece of a stratum.
    [[nodiscard]] bool regular(const Stratum &stratum, const PieceIndex &index) const;

private:
    [[nodiscard]] bool is_jump(const Stratum &stratum, int k) const noexcept;
    [[nodiscard]] int common_sign(const Stratum &stratum, const PieceIndex &index, int along, int k) const;

    const GradientField &field_;
    pieces::PieceMaker maker_; // of pieces about one centre
};

} // namespace nrb::intersect
