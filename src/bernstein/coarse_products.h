// SPDX-License-Identifier: MIT
// Products of Bernstein polynomials with one error bound common to all coefficients: a quarter of the cost of
// products with an error bound for each coefficient.
#pragma once

#include "bernstein/rounded_polynomial.h"

namespace nrb::inline bernstein {

// Each coefficient of a product is a convex combination of products of coefficients of the factors, so the
// largest coefficients of the factors and their largest errors bound the error of all.

// All components of a times a polynomial of width 1.
RoundedPolynomial coarse_times(const RoundedPolynomial &a, const RoundedPolynomial &factor);

// sum_c a_c b_c, where the last component is multiplied by last_sign. Precondition: equal widths.
RoundedPolynomial coarse_dot(const RoundedPolynomial &a, const RoundedPolynomial &b, double last_sign = 1);

// Degree elevation to the degrees of `shape`, which must not be lower.
RoundedPolynomial coarse_raised(const RoundedPolynomial &a, const BernsteinShape &shape);

} // namespace nrb::inline bernstein
