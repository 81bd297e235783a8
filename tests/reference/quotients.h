// Curves as quotients of Bernstein polynomials without rounding: sums, products and derivatives of them, and
// how far two are apart, everywhere and not only at samples.
#pragma once

#include "reference/number.h"
#include "support/spline_data.h"

#include <functional>
#include <vector>

namespace reference {

// Bernstein coefficients over one interval.
using Polynomial = std::vector<Rational>;

Polynomial operator*(const Polynomial &a, const Polynomial &b);
Polynomial operator+(const Polynomial &a, const Polynomial &b); // raised to the higher degree
Polynomial operator-(const Polynomial &a, const Polynomial &b);
Polynomial scaled(const Polynomial &a, const Rational &factor);
Polynomial raised(Polynomial a, size_t degree);

// One piece of a curve: numerators of every coordinate over one denominator.
struct QuotientPiece {
    std::vector<Polynomial> numerators;
    Polynomial denominator;
};

// a + factor * b, over the product of the denominators unless they are equal.
QuotientPiece sum(const QuotientPiece &a, const Rational &factor, const QuotientPiece &b);
QuotientPiece times(const QuotientPiece &a, const Polynomial &f);

// Homogeneous control points (w x, w y, ..., w).
using Records = std::vector<std::vector<Rational>>;
Records exact_records(const support::SplineData &data);

// The distinct knots of the closed domain of an axis.
std::vector<double> breaks_of(const support::SplineData &data, int axis);
// The breaks of both.
std::vector<double> united(const std::vector<double> &a, const std::vector<double> &b);

// The polynomials of one row of records over knots, on [lower, upper], which lies in one span.
std::vector<Polynomial> polynomials(const std::vector<double> &knots, int degree, const Records &records,
                                    double lower, double upper);

// A curve on [lower, upper], which lies in one span.
QuotientPiece piece(const support::SplineData &curve, double lower, double upper);

// What a clamped surface is at an end of an axis, as a function of the other one on [lower, upper], and its
// derivative there: with layers A_0, w_0 at the end and A_1, w_1 next to it p / h (A_1 w_0 - A_0 w_1) /
// w_0^2.
QuotientPiece edge(const support::SplineData &surface, int axis, bool upper_end, double lower, double upper);
QuotientPiece edge_derivative(const support::SplineData &surface, int axis, bool upper_end, double lower,
                              double upper);

// A bound of every coordinate of a - b: with F / W their difference, W > 0, max |F_i / W_i|.
long double largest_difference(const QuotientPiece &a, const QuotientPiece &b);

} // namespace reference
