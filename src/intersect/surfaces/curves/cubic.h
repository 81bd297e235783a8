// SPDX-License-Identifier: MIT
// Evaluates the cubics of segments.
#pragma once

#include "numeric/vector3.h"

#include <cstddef>

namespace nrb::intersect {

// A cubic, by reference to its four Bezier points.
template <class Points>
class Cubic {
public:
    explicit Cubic(const Points &points) noexcept : points_(points) {}
    [[nodiscard]] double coordinate(size_t c, double t) const noexcept {
        const double s = 1 - t;
        return s * s * s * points_[0][c] + 3 * s * s * t * points_[1][c] + 3 * s * t * t * points_[2][c] +
               t * t * t * points_[3][c];
    }
    [[nodiscard]] Vector3 at(double t) const noexcept {
        return {coordinate(0, t), coordinate(1, t), coordinate(2, t)};
    }

private:
    const Points &points_;
};

} // namespace nrb::intersect
