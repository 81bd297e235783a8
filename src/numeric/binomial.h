// SPDX-License-Identifier: MIT
// Binomial coefficients up to the largest degree of a product.
#pragma once

#include "base/limits.h"
#include "numeric/double_double.h"

#include <vector>

namespace nrb::inline numeric {

inline constexpr int max_product_degree = 2 * max_degree;

// C(n, k), exact below 2^53, rounded once above. Precondition: 0 <= k <= n <= max_product_degree.
double binomial(int n, int k) noexcept;
// C(n, 0), ..., C(n, n).
const double *binomials(int n) noexcept;
// The same in twice the precision: exact below 2^106.
std::vector<DoubleDouble> precise_binomials(int n);
// C(p, i) C(p, j) / C(2 p, i + j), [p + 1][p + 1]: the factors of B_(i+j) of degree 2 p in the products B_i
// B_j of degree p.
std::vector<DoubleDouble> precise_product_factors(int p);

} // namespace nrb::inline numeric
