// SPDX-License-Identifier: MIT
// Integers of 128 and 192 bits, for exact sums of products, which do not depend on the order of their terms.
#pragma once

#include "numeric/double_double.h"

#include <array>
#include <cstdint>

namespace nrb::inline numeric {

// Two's complement in two limbs, for compilers without a 128-bit integer type.
class TwoLimbs {
public:
    TwoLimbs() noexcept = default;
    constexpr TwoLimbs(int64_t high, uint64_t low) noexcept : high_(high), low_(low) {}

    static constexpr TwoLimbs of(uint64_t low) noexcept { return {0, low}; }
    static constexpr TwoLimbs product(int64_t a, int64_t b) noexcept {
        const TwoLimbs size = magnitude(absolute(a), absolute(b));
        return (a < 0) != (b < 0) ? TwoLimbs{} - size : size;
    }
    // The upper half of the product of two unsigned numbers.
    static constexpr uint64_t high_product(uint64_t a, uint64_t b) noexcept {
        return static_cast<uint64_t>(magnitude(a, b).high_);
    }
    [[nodiscard]] constexpr int64_t high() const noexcept { return high_; }
    [[nodiscard]] constexpr uint64_t low() const noexcept { return low_; }
    constexpr TwoLimbs &operator+=(const TwoLimbs &other) noexcept {
        low_ += other.low_;
        high_ = wrapped(high_, other.high_, low_ < other.low_ ? 1 : 0);
        return *this;
    }
    // Divided by 2^bits and rounded to nearest, ties upwards. Preconditions: 0 < bits < 64, and the result
    // fits.
    [[nodiscard]] constexpr int64_t rounded_shift(int bits) const noexcept {
        TwoLimbs sum = *this;
        sum += TwoLimbs{0, uint64_t{1} << (bits - 1)};
        return static_cast<int64_t>(static_cast<uint64_t>(sum.high_) << (64 - bits) | sum.low_ >> bits);
    }

private:
    static constexpr uint64_t absolute(int64_t a) noexcept {
        return a < 0 ? 0 - static_cast<uint64_t>(a) : static_cast<uint64_t>(a);
    }
    static constexpr int64_t wrapped(int64_t a, int64_t b, uint64_t carry) noexcept {
        return static_cast<int64_t>(static_cast<uint64_t>(a) + static_cast<uint64_t>(b) + carry);
    }
    static constexpr TwoLimbs magnitude(uint64_t a, uint64_t b) noexcept {
        constexpr uint64_t half = 0xffffffffu;
        const uint64_t low = (a & half) * (b & half), left = (a >> 32) * (b & half) + (low >> 32);
        const uint64_t right = (a & half) * (b >> 32) + (left & half);
        return {static_cast<int64_t>((a >> 32) * (b >> 32) + (left >> 32) + (right >> 32)),
                right << 32 | (low & half)};
    }
    friend constexpr TwoLimbs operator-(const TwoLimbs &a, const TwoLimbs &b) noexcept {
        TwoLimbs result = a;
        result += TwoLimbs{static_cast<int64_t>(~static_cast<uint64_t>(b.high_)), ~b.low_};
        result += TwoLimbs{0, 1};
        return result;
    }

    int64_t high_ = 0;
    uint64_t low_ = 0;
};

#ifdef __SIZEOF_INT128__
// The same, using the 128-bit type of the compiler.
class Native128 {
public:
    Native128() noexcept = default;
    constexpr Native128(int64_t high, uint64_t low) noexcept
        : value_(static_cast<Signed>(static_cast<Unsigned>(high) << 64 | low)) {}

    static constexpr Native128 of(uint64_t low) noexcept {
        return Native128(static_cast<Signed>(Unsigned{low}));
    }
    static constexpr Native128 product(int64_t a, int64_t b) noexcept { return Native128(Signed{a} * b); }
    static constexpr uint64_t high_product(uint64_t a, uint64_t b) noexcept {
        return static_cast<uint64_t>((Unsigned{a} * b) >> 64);
    }
    [[nodiscard]] constexpr int64_t high() const noexcept { return static_cast<int64_t>(value_ >> 64); }
    [[nodiscard]] constexpr uint64_t low() const noexcept { return static_cast<uint64_t>(value_); }
    constexpr Native128 &operator+=(const Native128 &other) noexcept {
        value_ += other.value_;
        return *this;
    }
    [[nodiscard]] constexpr int64_t rounded_shift(int bits) const noexcept {
        // Shifted in two halves with an explicit rounding bit: some processors are slow to shift and carry
        // across limbs.
        return static_cast<int64_t>((static_cast<uint64_t>(high()) << (64 - bits)) + (low() >> bits) +
                                    (low() >> (bits - 1) & 1));
    }

private:
    __extension__ typedef __int128 Signed;
    __extension__ typedef unsigned __int128 Unsigned;
    explicit constexpr Native128(Signed value) noexcept : value_(value) {}

    Signed value_ = 0;
};
using Int128 = Native128;
#else
using Int128 = TwoLimbs;
#endif

// A sum in 192 bits, enough for 2^64 terms below 2^127.
class ExactSum {
public:
    ExactSum() noexcept = default;
    explicit ExactSum(const std::array<uint64_t, 3> &limbs) noexcept : limbs_(limbs) {}

    // The limbs, least significant first.
    [[nodiscard]] const std::array<uint64_t, 3> &limbs() const noexcept { return limbs_; }
    // Adds term * 2^shift, 0 <= shift < 64.
    void add(const Int128 &term, int shift) noexcept;
    ExactSum &operator+=(const ExactSum &other) noexcept;
    ExactSum &operator-=(const ExactSum &other) noexcept;
    [[nodiscard]] bool negative() const noexcept { return static_cast<int64_t>(limbs_[2]) < 0; }
    [[nodiscard]] bool zero() const noexcept { return (limbs_[0] | limbs_[1] | limbs_[2]) == 0; }
    // The sum times 2^exponent, with a relative error within 2^-104 where nothing leaves the range of normal
    // numbers.
    [[nodiscard]] DoubleDouble scaled(int exponent) const noexcept;

private:
    std::array<uint64_t, 3> limbs_{};
};

} // namespace nrb::inline numeric
