// SPDX-License-Identifier: MIT
// Four doubles in two 128-bit vector registers, which every processor has: for example a homogeneous point
// (x, y, z, w). They serve code that needs a few of them at a time, which is not worth a run-time choice of
// instruction sets (base/simd.h): the vector extensions of the compilers do.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>

namespace nrb::mesh {

using Pair = double __attribute__((vector_size(16)));
struct Four {
    Pair low, high;

    explicit Four(double x = 0) noexcept : low{x, x}, high{x, x} {}
    Four(const Pair &a, const Pair &b) noexcept : low(a), high(b) {}
    Four(double a, double b, double c, double d) noexcept : low{a, b}, high{c, d} {}
    explicit Four(const std::array<double, 4> &row) noexcept : Four(row.data()) {}
    explicit Four(const double *x) noexcept {
        std::memcpy(&low, x, sizeof low);
        std::memcpy(&high, x + 2, sizeof high);
    }
    void store(double *x) const noexcept {
        std::memcpy(x, &low, sizeof low);
        std::memcpy(x + 2, &high, sizeof high);
    }
    [[nodiscard]] double operator[](size_t k) const noexcept { return k < 2 ? low[k] : high[k - 2]; }
    [[nodiscard]] Four operator+(const Four &other) const noexcept {
        return {low + other.low, high + other.high};
    }
    [[nodiscard]] Four operator-(const Four &other) const noexcept {
        return {low - other.low, high - other.high};
    }
    [[nodiscard]] Four operator*(double x) const noexcept { return {low * x, high * x}; }
    [[nodiscard]] Four operator*(const Four &other) const noexcept {
        return {low * other.low, high * other.high};
    }
    [[nodiscard]] double sum() const noexcept {
        const Pair both = low + high;
        return both[0] + both[1];
    }
};

inline Four least(const Four &a, const Four &b) noexcept {
    return {a.low < b.low ? a.low : b.low, a.high < b.high ? a.high : b.high};
}

inline Four greatest(const Four &a, const Four &b) noexcept {
    return {a.low > b.low ? a.low : b.low, a.high > b.high ? a.high : b.high};
}

inline std::array<Four, 4> transposed(const std::array<Four, 4> &x) noexcept {
    const auto &[a, b, c, d] = x;
    return {Four(Pair{a.low[0], b.low[0]}, Pair{c.low[0], d.low[0]}),
            Four(Pair{a.low[1], b.low[1]}, Pair{c.low[1], d.low[1]}),
            Four(Pair{a.high[0], b.high[0]}, Pair{c.high[0], d.high[0]}),
            Four(Pair{a.high[1], b.high[1]}, Pair{c.high[1], d.high[1]})};
}

// Clears the sign bits.
inline Four abs(const Four &a) noexcept {
    using Bits = int64_t __attribute__((vector_size(16)));
    constexpr Bits rest{std::numeric_limits<int64_t>::max(), std::numeric_limits<int64_t>::max()};
    return {reinterpret_cast<Pair>(reinterpret_cast<Bits>(a.low) & rest),
            reinterpret_cast<Pair>(reinterpret_cast<Bits>(a.high) & rest)};
}

// The squared length of the first three numbers.
inline double square3(const Four &a) noexcept {
    return a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
}

} // namespace nrb::mesh
