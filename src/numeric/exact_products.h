// SPDX-License-Identifier: MIT
// Exact comparison of products, accurate differences of products, and the orientation predicate of the plane.
#pragma once

namespace nrb::inline numeric {

// The sign of a b - c d, exactly: -1, 0 or 1, for operands of any size. Precondition: all are finite.
int compare_products(double a, double b, double c, double d) noexcept;

// a b - c d with a relative error within 1.5 eps, barring underflow and overflow (W. Kahan; C.-P. Jeannerod,
// N. Louvet, J.-M. Muller, "Further analysis of Kahan's algorithm for the accurate computation of 2x2
// determinants", Math. Comp. 82 (2013)).
double difference_of_products(double a, double b, double c, double d) noexcept;

// The orientation predicate: the sign of (b - a) x (c - a) for points of the plane, 1 if c lies to the left
// of the line from a to b. Exact, barring underflow (J. R. Shewchuk, "Adaptive precision floating-point
// arithmetic and fast robust geometric predicates", Discrete Comput. Geom. 18 (1997)). Precondition: all are
// finite, and products do not overflow.
int side_of_line(const double *a, const double *b, const double *c) noexcept;

} // namespace nrb::inline numeric
