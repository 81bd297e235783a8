// SPDX-License-Identifier: MIT
// Parts of the pieces of a spline on which a determinant of first derivatives is examined.
#pragma once

#include "pieces/derivative_pieces.h"

#include <deque>

namespace nrb::analysis {

// A polynomial on a part of a piece; from and to are places between 0 and 1 on the axes of the spline.
struct JacobianPart {
    RoundedPolynomial f;
    size_t piece = 0;
    std::array<double, max_axes> from{};
    std::array<double, max_axes> to{1, 1, 1};
};

// The boundaries of a piece that a polynomial was divided by, lower and upper of each axis.
using BoundaryZeros = std::array<std::array<bool, 2>, max_axes>;
// Divides by the boundaries on which all coefficients vanish to rounding, as often as they do.
BoundaryZeros divide_boundaries(RoundedPolynomial &f, int axes);

// Halves a part along the axis on which it is longest, in units of `scale`, among the axes with a degree;
// false if no side is longer than `least`. The part becomes the upper half.
bool halve_longest(JacobianPart &part, int axes, const std::array<double, max_axes> &scale, double least,
                   JacobianPart &lower);

// Parts are examined from the largest to the smallest, as many as `halvings` and memory allow.
int64_t halvings_for(const RoundedPolynomial &f) noexcept;

} // namespace nrb::analysis
