// SPDX-License-Identifier: MIT
// Numbers and vectors of which bounds are known, and their arithmetic.
#pragma once

#include "base/numbers.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::fit::boxes {

// All numbers between two, after the rounding of what was done to them.
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
// By numbers above 0.
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
inline Box operator/(const Box &a, Bounds b) {
    return each([&](size_t c) { return a[c] / b; });
}
inline Vector3 middle_of(const Box &a) noexcept {
    return {a[0].lower / 2 + a[0].upper / 2, a[1].lower / 2 + a[1].upper / 2,
            a[2].lower / 2 + a[2].upper / 2};
}
// Of the lengths; nothing is known if the box is not on one side of a plane.
inline Bounds length_of(const Box &a) {
    const Vector3 middle = middle_of(a);
    const double l = length(middle);
    if (!(l > 0)) {
        return {0, infinity};
    }
    const Vector3 m = (1 / l) * middle;
    const Box way{Bounds{m.x, m.x}, Bounds{m.y, m.y}, Bounds{m.z, m.z}};
    double most = 0;
    for (const Bounds &x : a) {
        most = std::hypot(most, std::max(-x.lower, x.upper));
    }
    return {dot(a, way).lower * (1 - 8 * eps), most * (1 + 8 * eps)};
}

} // namespace nrb::fit::boxes
