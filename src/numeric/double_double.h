// Values of twice the precision, one at a time: unevaluated sums of two doubles (Dekker 1971), as those of
// numeric/double_double-inl.h for vectors.
#pragma once

#include <cfloat>
#include <cmath>

namespace nrb::inline numeric {

// On processors that compute with more digits (x87) the errors of operations would not be what is relied on.
static_assert(FLT_EVAL_METHOD == 0, "operations on doubles have to be rounded to double");

// high + low with |low| at most half a unit of rounding of high. Each operation is within 2^-102 of its
// value, barring overflow and underflow; sums that cancel, within that of what was added.
struct Wide {
    double high = 0;
    double low = 0;

    Wide() = default;
    Wide(double value) noexcept : high(value) {}
    Wide(double high_part, double low_part) noexcept : high(high_part), low(low_part) {}

    static Wide sum(double a, double b) noexcept {
        const double total = a + b, part = total - a;
        return {total, (a - (total - part)) + (b - part)};
    }
    // Where |a| >= |b|.
    static Wide ordered_sum(double a, double b) noexcept {
        const double total = a + b;
        return {total, b - (total - a)};
    }
    static Wide product(double a, double b) noexcept {
        const double rounded = a * b;
        return {rounded, std::fma(a, b, -rounded)};
    }
    [[nodiscard]] double value() const noexcept { return high + low; }
};

inline Wide operator-(const Wide &a) noexcept {
    return {-a.high, -a.low};
}
inline Wide operator+(const Wide &a, const Wide &b) noexcept {
    const Wide high = Wide::sum(a.high, b.high), low = Wide::sum(a.low, b.low);
    const Wide once = Wide::ordered_sum(high.high, high.low + low.high);
    return Wide::ordered_sum(once.high, once.low + low.low);
}
inline Wide operator-(const Wide &a, const Wide &b) noexcept {
    return a + -b;
}
inline Wide operator*(const Wide &a, const Wide &b) noexcept {
    const Wide high = Wide::product(a.high, b.high);
    return Wide::ordered_sum(high.high, high.low + (a.high * b.low + a.low * b.high));
}
// Newton's step on the rounded quotient, with its exact remainder.
inline Wide operator/(const Wide &a, const Wide &b) noexcept {
    const double first = a.high / b.high;
    const Wide rest = a - Wide(first) * b;
    const double second = rest.high / b.high;
    const Wide last = rest - Wide(second) * b;
    return Wide::ordered_sum(first, second) + Wide(last.high / b.high);
}
// Of a value that is not negative.
inline Wide square_root(const Wide &a) noexcept {
    const double first = std::sqrt(a.high);
    if (first == 0) {
        return {};
    }
    const Wide rest = a - Wide::product(first, first);
    return Wide::ordered_sum(first, rest.high / (2 * first));
}

} // namespace nrb::inline numeric
