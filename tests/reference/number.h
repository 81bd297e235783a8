// Exact numbers: every double is an integer times a power of two, and everything derived from doubles here
// stays a quotient of integers until it is compared with a double.
#pragma once

// Boost 1.74 shadows and converts inside its own headers.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#ifndef __clang__ // g++ with sanitizers loses track of which member of its small-number union is set
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/multiprecision/cpp_int.hpp>
#pragma GCC diagnostic pop

#include <algorithm>

namespace reference {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

// numerator / denominator with denominator > 0, deliberately not reduced: the common divisors of intermediate
// results cost far more than they save.
struct Fraction {
    Integer numerator;
    Integer denominator;
};

// Exponent of the lowest bit set in a finite x; INT_MAX for 0.
int lowest_bit(double x);
// x * 2^-exponent. Precondition: exponent <= lowest_bit(x).
Integer scaled(double x, int exponent);
// The exponent, at most 0, at which all values of a range are integers.
template <class Range>
int common_exponent(const Range &values) {
    int exponent = 0;
    for (const double x : values) {
        exponent = std::min(exponent, lowest_bit(x));
    }
    return exponent;
}

Rational exact(double x);
Fraction fraction(const Rational &x);

// a / b rounded twice at most; neither has to fit a floating-point type. b != 0.
long double quotient(const Integer &a, const Integer &b);
// The double nearest to x, ties to even. Precondition: 0 or in the normal range.
double nearest(const Fraction &x);
// |value - x|, to the precision of long double; never rounds a difference to 0.
long double distance(double value, const Fraction &x);
// |value - x| / bound; 0 / 0 is 0.
long double error_ratio(double value, const Fraction &x, long double bound);

} // namespace reference
