// SPDX-License-Identifier: MIT
// One disc around a patch, in the making.
#pragma once

#include "pieces/tree/piece_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace nrb::pieces {

inline constexpr double far_away = 1e30;  // of centres
inline constexpr double unbounded = 1e36; // of patches without bounds

// In single precision, not below x; at most `unbounded`.
inline float above(double x) noexcept {
    x = std::min(x, unbounded);
    const auto rounded = static_cast<float>(x);
    return rounded < x ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

// Points whose component across the normal is within the radius of the line through the centre, and whose
// heights over the centre are in an interval. The normal is no longer than 1; without it, the disc is a ball.
struct Disc {
    std::vector<double> centre;
    std::array<double, 3> normal{};
    double radius = 0, low = 0, high = 0;

    // Around the point in the middle of a patch, with the normal there.
    Disc(const PatchShape &shape, const double *patch, bool with_normal);
    // Rounds the centre and the normal to single precision, before there is room for points.
    void make_single() noexcept;
    // Makes room for all control points, and for what rounding may have made of them by their weights. Where
    // it is relative to these, those of weight 0 do not count.
    void add(const PieceGrid &pieces, const double *patch) noexcept;

private:
    void set_normal(const PatchShape &shape, const double *jet) noexcept;
    void add_point(int dim, const double *point, double weight, double moved) noexcept;
};

// A box [2][dim], the upper ends after the lower ones, grows to hold the same points.
void add_to_box(const PieceGrid &pieces, const double *patch, double *box) noexcept;

} // namespace nrb::pieces
