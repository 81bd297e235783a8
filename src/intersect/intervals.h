// SPDX-License-Identifier: MIT
// Interval arithmetic without directed rounding: sums and products of numbers that are known to lie in
// intervals.
#pragma once

#include "basis/knot_vector.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

inline Interval operator+(const Interval &a, const Interval &b) noexcept {
    return {a.lower + b.lower, a.upper + b.upper};
}
inline Interval operator-(const Interval &a, const Interval &b) noexcept {
    return {a.lower - b.upper, a.upper - b.lower};
}
inline Interval operator*(const Interval &a, const Interval &b) noexcept {
    const auto [least, most] =
        std::minmax({a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper});
    return {least, most};
}
inline Interval operator*(double s, const Interval &a) noexcept {
    return s < 0 ? Interval{s * a.upper, s * a.lower} : Interval{s * a.lower, s * a.upper};
}
inline double magnitude_of(const Interval &x) noexcept {
    return std::max(std::abs(x.lower), std::abs(x.upper));
}
inline double width_of(const Interval &x) noexcept {
    return x.upper - x.lower;
}
// The interval of all numbers of magnitude at most `most`.
inline Interval around(double most) noexcept {
    return {-most, most};
}

} // namespace nrb::intersect
