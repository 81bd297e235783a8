// SPDX-License-Identifier: MIT
// Products of polynomials whose coefficients have one error in common: a quarter of the cost of those with an error each.
#pragma once

#include "bernstein/rounded_polynomial.h"

namespace nrb::inline bernstein {

// Coefficients of a product are means of products of coefficients, so that the largest ones of the factors, and their largest errors,
// bound the error of all of them.

// All components of a times a polynomial of width 1.
RoundedPolynomial coarse_times(const RoundedPolynomial &a, const RoundedPolynomial &factor);

// sum_c a_c b_c, with the last component times last_sign. Precondition: equal widths.
RoundedPolynomial coarse_dot(const RoundedPolynomial &a, const RoundedPolynomial &b, double last_sign = 1);

// With degrees that are no lower.
RoundedPolynomial coarse_raised(const RoundedPolynomial &a, const BernsteinShape &shape);

} // namespace nrb::inline bernstein
