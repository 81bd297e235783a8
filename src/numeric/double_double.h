// SPDX-License-Identifier: MIT
// Double-double arithmetic: values of twice the precision as unevaluated sums of two doubles (Dekker 1971).
// For many values at a time see numeric/double_double-inl.h.
#pragma once

#include <cfloat>
#include <cmath>

namespace nrb::inline numeric {

// Where the processor computes with more digits (x87), the error terms of the operations would not be exact.
static_assert(FLT_EVAL_METHOD == 0, "operations on doubles have to be rounded to double");

// high + low with |low| at most half an ulp of high. Barring overflow and underflow, each operation has a
// relative error within 2^-102; for sums that cancel, the error is relative to the terms.
struct DoubleDouble {
    double high = 0;
    double low = 0;

    DoubleDouble() = default;
    DoubleDouble(double value) noexcept : high(value) {}
    DoubleDouble(double high_part, double low_part) noexcept : high(high_part), low(low_part) {}

    static DoubleDouble sum(double a, double b) noexcept {
        const double total = a + b, part = total - a;
        return {total, (a - (total - part)) + (b - part)};
    }
    // Precondition: |a| >= |b|.
    static DoubleDouble ordered_sum(double a, double b) noexcept {
        const double total = a + b;
        return {total, b - (total - a)};
    }
    static DoubleDouble product(double a, double b) noexcept {
        const double rounded = a * b;
        return {rounded, std::fma(a, b, -rounded)};
    }
    [[nodiscard]] double value() const noexcept { return high + low; }
};

inline DoubleDouble operator-(const DoubleDouble &a) noexcept {
    return {-a.high, -a.low};
}
inline DoubleDouble operator+(const DoubleDouble &a, const DoubleDouble &b) noexcept {
    const DoubleDouble high = DoubleDouble::sum(a.high, b.high), low = DoubleDouble::sum(a.low, b.low);
    const DoubleDouble once = DoubleDouble::ordered_sum(high.high, high.low + low.high);
    return DoubleDouble::ordered_sum(once.high, once.low + low.low);
}
inline DoubleDouble operator-(const DoubleDouble &a, const DoubleDouble &b) noexcept {
    return a + -b;
}
inline DoubleDouble operator*(const DoubleDouble &a, const DoubleDouble &b) noexcept {
    const DoubleDouble high = DoubleDouble::product(a.high, b.high);
    return DoubleDouble::ordered_sum(high.high, high.low + (a.high * b.low + a.low * b.high));
}
// The rounded quotient, corrected by Newton steps with its exact remainder.
inline DoubleDouble operator/(const DoubleDouble &a, const DoubleDouble &b) noexcept {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - DoubleDouble(first) * b;
    const double second = rest.high / b.high;
    const DoubleDouble last = rest - DoubleDouble(second) * b;
    return DoubleDouble::ordered_sum(first, second) + DoubleDouble(last.high / b.high);
}
// Precondition: a >= 0.
inline DoubleDouble square_root(const DoubleDouble &a) noexcept {
    const double first = std::sqrt(a.high);
    if (first == 0) {
        return {};
    }
    const DoubleDouble rest = a - DoubleDouble::product(first, first);
    return DoubleDouble::ordered_sum(first, rest.high / (2 * first));
}

} // namespace nrb::inline numeric
