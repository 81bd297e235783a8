// Whether numbers are finite, and how large, many at once.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace nrb {

// 0 x is 0 for finite x and NaN for others; four sums, so that they run side by side.
inline bool all_finite(std::span<const double> values) noexcept {
    double sums[4] = {0, 0, 0, 0};
    size_t i = 0;
    for (; i + 4 <= values.size(); i += 4) {
        for (size_t l = 0; l < 4; ++l) {
            sums[l] += 0 * values[i + l];
        }
    }
    for (; i < values.size(); ++i) {
        sums[0] += 0 * values[i];
    }
    return sums[0] + sums[1] + (sums[2] + sums[3]) == 0;
}

// The largest |value| that is a number; 0 without any.
inline double largest_magnitude(std::span<const double> values) noexcept {
    double largest[4] = {0, 0, 0, 0};
    size_t i = 0;
    for (; i + 4 <= values.size(); i += 4) {
        for (size_t l = 0; l < 4; ++l) {
            largest[l] = std::max(largest[l], std::abs(values[i + l]));
        }
    }
    for (; i < values.size(); ++i) {
        largest[0] = std::max(largest[0], std::abs(values[i]));
    }
    return std::max(std::max(largest[0], largest[1]), std::max(largest[2], largest[3]));
}

} // namespace nrb
