// SPDX-License-Identifier: MIT
// Bernstein polynomials in fixed-point arithmetic: the same bits on every machine.
#pragma once

#include "fit/statistics/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::fit {

inline constexpr int64_t function_unit = int64_t{1} << function_bits;

// A place in a cell: its distance from the nearer end, in units of 2^-64 of the cell, at most 2^63. The
// quotient of two differences is rounded as IEEE arithmetic does, and then down to a multiple of 2^-62.
struct CellPlace {
    uint64_t distance;
    bool from_end;
};
inline CellPlace place_in_cell(double t, double lower, double upper) noexcept {
    const double u = (t - lower) / (upper - lower), nearer = u <= 0.5 ? u : u < 1 ? 1 - u : 0;
    return {static_cast<uint64_t>(static_cast<int64_t>(nearer * 0x1p62)) << 2, u > 0.5};
}

// From the Bernstein polynomials of degree n - 1 those of degree n, numbered from the nearer end. Each one is
// divided into two parts, one of which is rounded down, so that the sum of all stays 2^62.
[[gnu::always_inline]] inline void raise_functions(int n, uint64_t distance, int64_t *values) noexcept {
    int64_t carried = 0;
    for (int k = 0; k < n; ++k) {
        const auto part =
            static_cast<int64_t>(Int128::high_product(static_cast<uint64_t>(values[k]), distance));
        const int64_t rest = values[k] - part;
        values[k] = carried + rest;
        carried = part;
    }
    values[n] = carried;
}
// The same in steps of one degree, beginning with those of degree `from`.
template <class From, class To>
[[gnu::always_inline]] inline void raise_functions(From from, To to, uint64_t distance,
                                                   int64_t *values) noexcept {
    for (int n = from + 1; n <= to; ++n) {
        raise_functions(n, distance, values);
    }
}

// The product of two functions.
inline int64_t function_product(int64_t a, int64_t b) noexcept {
    return Int128::product(a, b).rounded_shift(function_bits);
}

// Numbers up to a scale 2^exponent as integers in units of 2^-53 of it.
class ScaledUnits {
public:
    explicit ScaledUnits(int exponent) noexcept
        : scale_(std::min(std::ldexp(1.0, exponent), std::numeric_limits<double>::max())),
          first_(std::ldexp(1.0, (value_bits - exponent) / 2)),
          second_(std::ldexp(1.0, value_bits - exponent - (value_bits - exponent) / 2)) {}

    [[nodiscard]] double scale() const noexcept { return scale_; }
    // Rounded to the nearest integer, ties to even. Precondition: |x| <= scale(). It takes two products,
    // because 2^(53 - exponent) may not be a normal number; the first one rounds nothing that counts.
    [[nodiscard]] int64_t operator()(double x) const noexcept { return std::llrint(x * first_ * second_); }

private:
    double scale_, first_, second_;
};

} // namespace nrb::fit
