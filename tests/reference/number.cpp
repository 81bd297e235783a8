#include "reference/number.h"

#include <climits>
#include <cmath>
#include <cstdint>
#include <limits>

namespace reference {

namespace {

// x = mantissa * 2^exponent with an integer mantissa of at most 53 bits.
int64_t split(double x, int &exponent) {
    const double fraction = std::frexp(x, &exponent);
    exponent -= 53;
    return static_cast<int64_t>(std::ldexp(fraction, 53));
}

// The leading 64 bits of x > 0, and what they are multiplied by.
long double leading(const Integer &x, int64_t &exponent) {
    const auto bits = static_cast<int64_t>(msb(x)) + 1;
    exponent = std::max<int64_t>(bits - 64, 0);
    return static_cast<long double>(static_cast<uint64_t>(x >> static_cast<unsigned>(exponent)));
}

} // namespace

int lowest_bit(double x) {
    if (x == 0) {
        return INT_MAX;
    }
    int exponent = 0;
    int64_t mantissa = split(x, exponent);
    while (mantissa % 2 == 0) {
        mantissa /= 2;
        ++exponent;
    }
    return exponent;
}

Integer scaled(double x, int exponent) {
    int own = 0;
    const Integer mantissa = split(x, own);
    return own >= exponent ? Integer(mantissa << (own - exponent))
                           : Integer(mantissa / (Integer(1) << (exponent - own)));
}

Rational exact(double x) {
    int exponent = 0;
    const Integer mantissa = split(x, exponent);
    return exponent >= 0 ? Rational(mantissa << exponent) : Rational(mantissa, Integer(1) << -exponent);
}

Fraction fraction(const Rational &x) {
    return {boost::multiprecision::numerator(x), boost::multiprecision::denominator(x)};
}

long double quotient(const Integer &a, const Integer &b) {
    if (a == 0) {
        return 0;
    }
    int64_t up = 0;
    int64_t down = 0;
    const long double ratio = leading(abs(a), up) / leading(abs(b), down);
    const long double value = std::ldexp(ratio, static_cast<int>(up - down));
    return (a < 0) == (b < 0) ? value : -value;
}

double nearest(const Fraction &x) {
    if (x.numerator == 0) {
        return 0;
    }
    const Integer magnitude = abs(x.numerator);
    // The quotient gets 63 or 64 bits; the remainder is folded into the last one, far below the place that is
    // rounded.
    const int shift = 63 + static_cast<int>(msb(x.denominator)) - static_cast<int>(msb(magnitude));
    const Integer up = shift > 0 ? Integer(magnitude << shift) : magnitude;
    const Integer down = shift < 0 ? Integer(x.denominator << -shift) : x.denominator;
    Integer whole;
    Integer remainder;
    divide_qr(up, down, whole, remainder);
    const uint64_t bits = static_cast<uint64_t>(whole) | (remainder == 0 ? 0U : 1U);
    const double value = std::ldexp(static_cast<double>(bits), -shift);
    return x.numerator < 0 ? -value : value;
}

long double distance(double value, const Fraction &x) {
    int exponent = 0;
    const Integer mantissa = split(value, exponent);
    if (exponent >= 0) {
        return quotient(abs(Integer((mantissa << exponent) * x.denominator - x.numerator)), x.denominator);
    }
    const Integer difference = mantissa * x.denominator - (x.numerator << -exponent);
    return std::ldexp(quotient(abs(difference), x.denominator), exponent);
}

long double error_ratio(double value, const Fraction &x, long double bound) {
    if (!std::isfinite(value)) {
        return std::numeric_limits<long double>::infinity();
    }
    const long double error = distance(value, x);
    return error == 0 ? 0 : error / bound;
}

} // namespace reference
