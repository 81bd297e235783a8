// SPDX-License-Identifier: MIT
// The misfit: what a spline leaves of the data.
#pragma once

#include <cmath>
#include <limits>

namespace nrb::fit {

// Sums in units of powers of two, because a sum of squares may leave the range of doubles where its root does
// not.
struct Misfit {
    double weight = 0;  // sum w, in units of 2^weight_exponent
    double squares = 0; // sum w |y - s|^2, in units of 2^(weight_exponent + 2 value_exponent)
    int weight_exponent = 0, value_exponent = 0;

    [[nodiscard]] double given_weight() const noexcept { return std::ldexp(weight, weight_exponent); }
    [[nodiscard]] double given_squares() const noexcept {
        return std::ldexp(squares, weight_exponent + 2 * value_exponent);
    }
    [[nodiscard]] double rms() const noexcept {
        return weight > 0 ? std::ldexp(std::sqrt(squares / weight), value_exponent) : 0;
    }
    // The standard deviation of a coordinate of weight 1; NaN where no degrees of freedom are left over to
    // estimate it.
    [[nodiscard]] double sigma(double left_over) const noexcept {
        const int odd = weight_exponent & 1;
        return left_over > 0 ? std::ldexp(std::sqrt(std::ldexp(squares, odd) / left_over),
                                          value_exponent + (weight_exponent - odd) / 2)
                             : std::numeric_limits<double>::quiet_NaN();
    }
};

} // namespace nrb::fit
