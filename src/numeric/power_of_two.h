// SPDX-License-Identifier: MIT
// Products with powers of two.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace nrb::inline numeric {

// x 2^exponent as std::ldexp has it: a product with a power that is a normal number is rounded once, as the
// result is.
inline double times_power_of_two(double x, int exponent) noexcept {
    constexpr int bias = 1023, mantissa_bits = 52;
    if (exponent > -bias && exponent <= bias) {
        return x * std::bit_cast<double>(static_cast<uint64_t>(exponent + bias) << mantissa_bits);
    }
    return std::ldexp(x, exponent);
}

} // namespace nrb::inline numeric
