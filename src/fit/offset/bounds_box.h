// SPDX-License-Identifier: MIT
// Interval arithmetic for numbers and vectors.
#pragma once

#include "base/numbers.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace nrb::fit::boxes {

// An interval that contains the exact result of operations despite their rounding.
struct Bounds {
    double lower, upper;

    [[nodiscard]] int sign() const noexcept { return lower > 0 ? 1 : upper < 0 ? -1 : 0; }
};

inline Bounds widened(double lower, double upper) noexcept {
    const double by = 2 * eps * std::max(std::abs(lower), std::abs(upper));
    return by < infinity ? Bounds{lower - by, upper + by} : Bounds{-infinity, infinity};
}
inline Bounds operator+(Bounds a, Bounds b) noexcept {
    return widened(a.lower + b.lower, a.upper + b.upper);
}
inline Bounds operator-(Bounds a, Bounds b) noexcept {
    return widened(a.lower - b.upper, a.upper - b.lower);
}
inline Bounds operator*(Bounds a, Bounds b) noexcept {
    const auto [least, most] =
        std::minmax({a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper});
    return widened(least, most);
}
// Precondition: all numbers of b are above 0.
inline Bounds operator/(Bounds a, Bounds b) noexcept {
    return a * widened(1 / b.upper, 1 / b.lower);
}
inline Bounds operator*(double s, Bounds a) noexcept {
    return Bounds{s, s} * a;
}

using Box = std::array<Bounds, 3>;

template <class Of>
Box each(Of &&of) {
    return {of(0), of(1), of(2)};
}
inline Bounds dot(const Box &a, const Box &b) noexcept {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Box cross(const Box &a, const Box &b) {
    return each([&](size_t c) {
        const size_t d = (c + 1) % 3, e = (c + 2) % 3;
        return a[d] * b[e] - a[e] * b[d];
    });
}
inline Vector3 middle_of(const Box &a) noexcept {
    return {a[0].lower / 2 + a[0].upper / 2, a[1].lower / 2 + a[1].upper / 2,
            a[2].lower / 2 + a[2].upper / 2};
}
// An upper bound of the lengths.
inline double most_length(const Box &a) noexcept {
    double most = 0;
    for (const Bounds &x : a) {
        most = std::hypot(most, std::max(-x.lower, x.upper));
    }
    return most * (1 + 8 * eps);
}

// a / |a|, if the box lies on one side of a plane through 0; nothing otherwise. Let m be the direction of the
// middle of the box, and t the largest angle between m and a vector a of the box. Then
//     |a / |a| - m| <= tan t = |a x m| / (a.m)
// Vectors of very different lengths may have nearly the same direction.
inline std::optional<Box> unit_of(const Box &a) {
    const Vector3 middle = middle_of(a);
    const double l = length(middle);
    if (!(l > 0)) {
        return std::nullopt;
    }
    const Vector3 m = (1 / l) * middle;
    const Box way{Bounds{m.x, m.x}, Bounds{m.y, m.y}, Bounds{m.z, m.z}};
    const double along = dot(a, way).lower * (1 - 8 * eps);
    if (!(along > 0)) {
        return std::nullopt;
    }
    const Bounds size{along, most_length(a)};
    const double off = (most_length(cross(a, way)) / along + eps) * (1 + 8 * eps);
    return each([&](size_t c) {
        const Bounds quotient = a[c] / size;
        return Bounds{std::max(quotient.lower, way[c].lower - off),
                      std::min(quotient.upper, way[c].upper + off)};
    });
}

} // namespace nrb::fit::boxes
