// SPDX-License-Identifier: MIT
// A test for C1 continuity where one cubic follows another.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace nrb::intersect {

// Whether the Bezier cubic `a` ends with the first derivative, to rounding, with which `b` begins. The
// lengths are those of their parameter intervals.
template <size_t N>
bool is_smooth_joint(const std::array<std::array<double, N>, 4> &a, double length_a,
                     const std::array<std::array<double, N>, 4> &b, double length_b) noexcept {
    double apart = 0, size = 0;
    for (size_t c = 0; c < N; ++c) {
        const double before = (a[3][c] - a[2][c]) / length_a, after = (b[1][c] - b[0][c]) / length_b;
        apart = std::max(apart, std::abs(before - after));
        size = std::max({size, std::abs(before), std::abs(after)});
    }
    return apart <= 1e-9 * size;
}

} // namespace nrb::intersect
