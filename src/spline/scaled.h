// SPDX-License-Identifier: MIT
// Splines scaled by powers of two.
#pragma once

#include "spline/spline.h"

#include <span>

namespace nrb::inline spline {

// The exponents: for the stored coordinates (homogeneous ones contain their weight), for the weights, and for
// the knots of each axis.
struct Powers {
    int coordinates = 0;
    int weights = 0;
    std::array<int, max_axes> knots{};

    bool operator==(const Powers &) const = default;
    // The exponent by which lengths are scaled.
    [[nodiscard]] int size(const Spline &spline) const noexcept {
        return spline.form() == Form::homogeneous ? coordinates - weights : coordinates;
    }
};

// The exponent nearest to the given one with which no knot overflows and no two knots become equal.
int kept_apart(std::span<const KnotVectorPtr> axes, int exponent) noexcept;

// Exact except for numbers that leave the range of doubles, which become infinite or lose bits. The caller
// has to know whether these matter.
SplinePtr scaled(const Spline &spline, const Powers &powers);

} // namespace nrb::inline spline
