// SPDX-License-Identifier: MIT
// Binomial coefficients as the degrees of products need them.
#pragma once

#include "base/limits.h"

namespace nrb::inline numeric {

inline constexpr int max_product_degree = 2 * max_degree;

// n over k, exact below 2^53, rounded once above. Precondition: 0 <= k <= n <= max_product_degree.
double binomial(int n, int k) noexcept;
// C(n, 0), ..., C(n, n).
const double *binomials(int n) noexcept;

} // namespace nrb::inline numeric
