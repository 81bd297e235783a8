// SPDX-License-Identifier: MIT
// Euclidean norms without spurious overflow or underflow, and dot products, which may overflow or underflow.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace nrb::inline numeric {

// Whether a sum of squares is so far from overflow and underflow that no significant part is lost.
constexpr bool safe_square(double sum) noexcept {
    return sum > 1e-280 && sum < 1e300;
}

// The Euclidean norm of a vector with components x(c), with a relative error within (n / 2 + 2) eps at any
// size; not finite if a component is not. Cost: one square root, and a second pass where the squares are not
// safe.
template <class Component>
double norm_of(int n, Component &&x) noexcept {
    double sum = 0;
    for (int c = 0; c < n; ++c) {
        sum += x(c) * x(c);
    }
    if (safe_square(sum)) {
        return std::sqrt(sum);
    }
    double largest = 0;
    for (int c = 0; c < n; ++c) {
        largest = std::max(largest, std::abs(x(c)));
    }
    if (!(largest > 0) || !std::isfinite(largest)) {
        return std::isnan(sum) ? sum : largest;
    }
    const double scale =
        std::ldexp(1.0, -std::ilogb(largest) / 2); // applied twice, because its square may overflow
    sum = 0;
    for (int c = 0; c < n; ++c) {
        const double y = x(c) * scale * scale;
        sum += y * y;
    }
    return std::sqrt(sum) / scale / scale;
}

// The norms of many vectors, where vector i has the components x(i, c). The first loops are free of branches,
// so that the processor can overlap their iterations; unsafe sums are redone afterwards.
template <class Size, class Component>
void norms_of(Size n, Component &&x, std::span<double> lengths) noexcept {
    for (size_t i = 0; i < lengths.size(); ++i) {
        double sum = 0;
        for (int c = 0; c < n; ++c) {
            sum += x(i, c) * x(i, c);
        }
        lengths[i] = sum;
    }
    int64_t unsafe = 0;
    for (double &length : lengths) {
        unsafe += safe_square(length) ? 0 : 1;
        length = std::sqrt(length);
    }
    for (size_t i = 0; unsafe > 0 && i < lengths.size(); ++i) {
        lengths[i] = norm_of(static_cast<int>(n), [&](int c) { return x(i, c); });
    }
}

inline double norm(const double *x, int n) noexcept {
    return norm_of(n, [x](int c) { return x[c]; });
}

inline double distance(const double *a, const double *b, int n) noexcept {
    return norm_of(n, [a, b](int c) { return a[c] - b[c]; });
}

inline double dot(const double *a, const double *b, int n) noexcept {
    double sum = 0;
    for (int c = 0; c < n; ++c) {
        sum += a[c] * b[c];
    }
    return sum;
}

// Precondition: both have the same size.
inline double dot(std::span<const double> a, std::span<const double> b) noexcept {
    return dot(a.data(), b.data(), static_cast<int>(a.size()));
}

} // namespace nrb::inline numeric
