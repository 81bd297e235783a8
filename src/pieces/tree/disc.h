// SPDX-License-Identifier: MIT
// Construction of the bounding disc of a patch.
#pragma once

#include "pieces/tree/piece_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace nrb::pieces {

inline constexpr double far_away = 1e30;  // limit of the coordinates of centres
inline constexpr double unbounded = 1e36; // stands for the radius of patches without bounds

// Rounds up to single precision; at most `unbounded`.
inline float above(double x) noexcept {
    x = std::min(x, unbounded);
    const auto rounded = static_cast<float>(x);
    return rounded < x ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

// The set of points whose component perpendicular to the normal is within the radius of the line through the
// centre along the normal, and whose heights over the centre are in [low, high]: a cylinder. The normal is no
// longer than 1; if it is 0, the disc is a ball.
struct Disc {
    std::vector<double> centre;
    std::array<double, 3> normal{};
    double radius = 0, low = 0, high = 0;

    // Around the point in the middle of a patch, with the normal there.
    Disc(const PatchShape &shape, const double *patch, bool with_normal);
    // Rounds the centre and the normal to single precision; to be called before points are added.
    void make_single() noexcept;
    // Enlarges the disc to contain all control points, including their absolute rounding errors divided by
    // the weights. Where errors are relative to the weights, they are not included, and control points of
    // weight 0 do not count.
    void add(const PieceGrid &pieces, const double *patch) noexcept;

private:
    void set_normal(const PatchShape &shape, const double *jet) noexcept;
    void add_point(int dim, const double *point, double weight, double moved) noexcept;
};

// Enlarges a box [2][dim], upper ends after lower ones, to contain the same points.
void add_to_box(const PieceGrid &pieces, const double *patch, double *box) noexcept;

} // namespace nrb::pieces
