// SPDX-License-Identifier: MIT
// Tests and extremes of arrays of doubles: finiteness and magnitude.
#pragma once

#include <span>

namespace nrb::inline base {

bool all_finite(std::span<const double> values) noexcept;

// Whether all |value| are below 2^961, so that sums of their binomial multiples do not overflow.
inline constexpr double moderate_limit = 0x1p961;
inline constexpr double moderate_product =
    0x1p1001; // the limit for a coordinate times its weight; leaves room for such sums, too
bool all_moderate(std::span<const double> values) noexcept;

// The largest |value|; NaNs are ignored. 0 if there are no other values.
double largest_magnitude(std::span<const double> values) noexcept;

struct Extremes {
    double smallest;
    double largest;
};
// The smallest and the largest value; NaNs are ignored. Precondition: values is not empty and its first
// element is not NaN.
Extremes extremes(std::span<const double> values) noexcept;

} // namespace nrb::inline base
