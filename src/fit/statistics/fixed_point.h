// SPDX-License-Identifier: MIT
// Bernstein functions in integers: the same bits on every machine.
#pragma once

#include "fit/statistics/statistics.h"

namespace nrb::fit {

inline constexpr int64_t function_unit = int64_t{1} << function_bits;

// A place in a cell, 0 to 1, in units of 2^-62. Both differences are rounded once, and their quotient is.
inline int64_t place_in_cell(double t, double lower, double upper) noexcept {
    const double u = (t - lower) / (upper - lower);
    return static_cast<int64_t>((u < 1 ? u : 1) * static_cast<double>(function_unit));
}

// From the functions of degree n - 1 at u those of degree n. A function is divided in two parts, of which one is rounded, so
// that the sum of all stays 2^62.
inline void raise_functions(int n, int64_t u, int64_t *values) noexcept {
    int64_t carried = 0;
    for (int k = 0; k < n; ++k) {
        const int64_t part = Int128::product(values[k], u).rounded_shift(function_bits);
        const int64_t rest = values[k] - part;
        values[k] = carried + rest;
        carried = part;
    }
    values[n] = carried;
}

// The product of two functions.
inline int64_t function_product(int64_t a, int64_t b) noexcept {
    return Int128::product(a, b).rounded_shift(function_bits);
}

// Times 2^(53 - exponent), rounded to the nearest integer, away from 0 in the middle. Precondition: |x| <= 2^exponent.
int64_t in_units(double x, int exponent) noexcept;

} // namespace nrb::fit
