// SPDX-License-Identifier: MIT
// Products with powers of two.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace nrb::inline numeric {

// x 2^exponent with the result of std::ldexp: where the power is a normal number, a product with it is
// rounded once, as the result is.
inline double times_power_of_two(double x, int exponent) noexcept {
    constexpr int bias = 1023, mantissa_bits = 52;
    if (exponent > -bias && exponent <= bias) {
        return x * std::bit_cast<double>(static_cast<uint64_t>(exponent + bias) << mantissa_bits);
    }
    return std::ldexp(x, exponent);
}

} // namespace nrb::inline numeric
