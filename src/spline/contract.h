// SPDX-License-Identifier: MIT
// The innermost loop of the library: a linear combination of rows.
#pragma once

#include <cstdint>

namespace nrb::inline spline {

// out[l] = coefficients[0] * rows[l] + ... + coefficients[n-1] * rows[(n-1) * stride + l], l < length. The
// terms are added in this order for every l, whatever the length, so that a point, a batch and a grid agree
// in every bit. Preconditions: n >= 1; out does not overlap rows. Error: at most (n + 1) eps / 2 * sum
// |coefficient * row|.
void contract(const double *coefficients, int n, const double *rows, int64_t stride, int64_t length,
              double *out) noexcept;

} // namespace nrb::inline spline
