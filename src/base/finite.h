// Whether numbers are finite, and how large, many at once.
#pragma once

#include <span>

namespace nrb::inline base {

bool all_finite(std::span<const double> values) noexcept;

// Whether all |value| are below 2^961, so that sums of binomial multiples do not overflow.
inline constexpr double moderate_limit = 0x1p961;
inline constexpr double moderate_product = 0x1p1001; // of one with a weight: leaves room for these sums, too
bool all_moderate(std::span<const double> values) noexcept;

// The largest |value| that is a number; 0 without any.
double largest_magnitude(std::span<const double> values) noexcept;

struct Extremes {
    double smallest;
    double largest;
};
// Of those that are numbers, and the first one. Precondition: there is one.
Extremes extremes(std::span<const double> values) noexcept;

} // namespace nrb::inline base
