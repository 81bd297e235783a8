// SPDX-License-Identifier: MIT
// The innermost loop of the library: a weighted sum of rows.
#pragma once

#include <cstdint>

namespace nrb::inline spline {

// out[l] = coefficients[0] * rows[l] + ... + coefficients[n-1] * rows[(n-1) * stride + l], l < length, added
// in this order for every l, whatever the length: this is what makes a point, a batch and a grid agree in
// every bit. Preconditions: n >= 1; out does not overlap rows. Error: |error| <= (n + 1) eps / 2 * sum
// |coefficient * row|.
void contract(const double *coefficients, int n, const double *rows, int64_t stride, int64_t length,
              double *out) noexcept;

} // namespace nrb::inline spline
