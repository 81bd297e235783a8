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
    // Of lengths.
    [[nodiscard]] int size(const Spline &spline) const noexcept {
        return spline.form() == Form::homogeneous ? coordinates - weights : coordinates;
    }
};

// The exponent nearest to the one that is wanted by which no knot overflows and no two become one.
int kept_apart(const Spline::Axes &axes, int exponent) noexcept;

// Exact but for numbers that leave double precision, which become infinite, or lose bits: whether they matter
// is for the caller to know.
SplinePtr scaled(const Spline &spline, const Powers &powers);

} // namespace nrb::inline spline
