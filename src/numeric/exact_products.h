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

} // namespace nrb::inline numeric
