// SPDX-License-Identifier: MIT
// Vectors in space; those of the plane have z = 0.
#pragma once

#include <algorithm>
#include <cmath>

namespace nrb::inline numeric {

inline constexpr int space_dim = 3;

struct Vector3 {
    double x = 0;
    double y = 0;
    double z = 0;
};

// The coordinates of a point of dimension `dim` up to 3, padded with zeros.
inline Vector3 vector_of(const double *x, int dim) noexcept {
    return {x[0], dim > 1 ? x[1] : 0, dim > 2 ? x[2] : 0};
}

inline Vector3 operator+(const Vector3 &a, const Vector3 &b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector3 operator-(const Vector3 &a, const Vector3 &b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector3 operator*(double s, const Vector3 &a) noexcept {
    return {s * a.x, s * a.y, s * a.z};
}
inline double dot(const Vector3 &a, const Vector3 &b) noexcept {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector3 cross(const Vector3 &a, const Vector3 &b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double largest(const Vector3 &a) noexcept {
    return std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
}

// The binary exponent of the largest coordinate; 0 for the zero vector, infinities and NaN.
inline int size_exponent(const Vector3 &a) noexcept {
    const double size = largest(a);
    return size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
}

inline Vector3 times_power(const Vector3 &a, int exponent) noexcept {
    return {std::ldexp(a.x, exponent), std::ldexp(a.y, exponent), std::ldexp(a.z, exponent)};
}

// The vector times the power of two that brings its largest coordinate into [1, 2), so that squares and
// products neither overflow nor underflow. Zero, infinities and NaN are left unchanged.
inline Vector3 scaled_to_one(const Vector3 &a) noexcept {
    const int exponent = size_exponent(a);
    return exponent == 0 ? a : times_power(a, -exponent);
}

// Squared lengths between these lose nothing; other vectors are scaled first, which does not change a single
// bit of results that are independent of scale.
inline constexpr double least_square = 0x1p-900;
inline constexpr double largest_square = 0x1p900;
inline bool in_range(double squared) noexcept {
    return squared > least_square && squared < largest_square;
}

inline double length(const Vector3 &a) noexcept {
    const double squared = dot(a, a);
    return in_range(squared) ? std::sqrt(squared) : std::hypot(a.x, a.y, a.z);
}

// a / |a|; NaN for the zero vector.
inline Vector3 unit(const Vector3 &a) noexcept {
    const double squared = dot(a, a);
    if (in_range(squared)) {
        return (1 / std::sqrt(squared)) * a;
    }
    const Vector3 b = scaled_to_one(a);
    return (1 / std::sqrt(dot(b, b))) * b;
}

// The unit vector along the component of a perpendicular to the unit vector t. The second pass removes what
// cancellation leaves along t when the two are nearly parallel.
inline Vector3 unit_across(const Vector3 &a, const Vector3 &t) noexcept {
    const Vector3 once = unit(a - dot(a, t) * t);
    return unit(once - dot(once, t) * t);
}

// The coordinate axis i with the smallest |t_i|, the first of several, made perpendicular to the unit vector
// t.
inline Vector3 any_normal(const Vector3 &t) noexcept {
    const double least = std::min({std::fabs(t.x), std::fabs(t.y), std::fabs(t.z)});
    const Vector3 axis = std::fabs(t.x) == least   ? Vector3{1, 0, 0}
                         : std::fabs(t.y) == least ? Vector3{0, 1, 0}
                                                   : Vector3{0, 0, 1};
    return unit(axis - dot(axis, t) * t);
}

} // namespace nrb::inline numeric
