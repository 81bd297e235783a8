// SPDX-License-Identifier: MIT
// Splines multiplied by powers of two.
#pragma once

#include "spline/spline.h"

namespace nrb::inline spline {

// The exponents: of the stored coordinates (homogeneous ones contain their weight), the weights and the knots
// of each axis.
struct Powers {
    int coordinates = 0;
    int weights = 0;
    std::array<int, max_axes> knots{};

    bool operator==(const Powers &) const = default;
    // The exponent of lengths.
    [[nodiscard]] int size(const Spline &spline) const noexcept {
        return spline.form() == Form::homogeneous ? coordinates - weights : coordinates;
    }
};

// The exponent nearest to the wanted one for which no knot overflows and no two knots become equal.
int kept_apart(const Spline::Axes &axes, int exponent) noexcept;

// Exact except for numbers that leave double precision: they become infinite or lose bits. The caller has to
// know whether they matter.
SplinePtr scaled(const Spline &spline, const Powers &powers);

} // namespace nrb::inline spline
