// SPDX-License-Identifier: MIT
// Whether many numbers are finite, and how large they are.
#pragma once

#include <span>

namespace nrb::inline base {

bool all_finite(std::span<const double> values) noexcept;

// Whether all |value| are below 2^961, so that sums of binomial multiples do not overflow.
inline constexpr double moderate_limit = 0x1p961;
inline constexpr double moderate_product =
    0x1p1001; // the same for a point with a weight: leaves room for these sums, too
bool all_moderate(std::span<const double> values) noexcept;

// The largest |value| among the values that are numbers; 0 if there are none.
double largest_magnitude(std::span<const double> values) noexcept;

struct Extremes {
    double smallest;
    double largest;
};
// The extremes of the values that are numbers, and the first of these values. Precondition: there is one.
Extremes extremes(std::span<const double> values) noexcept;

} // namespace nrb::inline base
