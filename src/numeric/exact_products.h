// SPDX-License-Identifier: MIT
// Products of two numbers compared without rounding, and their differences with little.
#pragma once

namespace nrb::inline numeric {

// The sign of a b - c d: -1, 0 or 1, at any size. Precondition: all are finite.
int compare_products(double a, double b, double c, double d) noexcept;

// a b - c d, within 1.5 eps of itself barring underflow and overflow (W. Kahan; C.-P. Jeannerod, N. Louvet,
// J.-M. Muller, "Further analysis of Kahan's algorithm for the accurate computation of 2x2 determinants",
// Math. Comp. 82 (2013)).
double difference_of_products(double a, double b, double c, double d) noexcept;

// The sign of (b - a) x (c - a) of places of the plane: 1 if c lies to the left of the way from a to b, without rounding barring
// underflow (J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", Discrete Comput.
// Geom. 18 (1997)). Precondition: all are finite, and products do not overflow.
int side_of_line(const double *a, const double *b, const double *c) noexcept;

} // namespace nrb::inline numeric
