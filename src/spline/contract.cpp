// SPDX-License-Identifier: MIT
#include "spline/contract.h"

namespace nrb::inline spline {

namespace {

template <int length>
inline void contract_fixed(const double *coefficients, int n, const double *rows, int64_t stride,
                           double *out) noexcept {
    double sum[length];
    for (int l = 0; l < length; ++l) {
        sum[l] = coefficients[0] * rows[l];
    }
    for (int i = 1; i < n; ++i) {
        rows += stride;
        for (int l = 0; l < length; ++l) {
            sum[l] += coefficients[i] * rows[l];
        }
    }
    for (int l = 0; l < length; ++l) {
        out[l] = sum[l];
    }
}

} // namespace

void contract(const double *coefficients, int n, const double *rows, int64_t stride, int64_t length,
              double *out) noexcept {
    constexpr int block = 8;
    for (; length >= block; length -= block, rows += block, out += block) {
        contract_fixed<block>(coefficients, n, rows, stride, out);
    }
    if (length >= 4) {
        contract_fixed<4>(coefficients, n, rows, stride, out);
        length -= 4;
        rows += 4;
        out += 4;
    }
    switch (length) {
    case 3:
        return contract_fixed<3>(coefficients, n, rows, stride, out);
    case 2:
        return contract_fixed<2>(coefficients, n, rows, stride, out);
    case 1:
        return contract_fixed<1>(coefficients, n, rows, stride, out);
    default:
        return;
    }
}

} // namespace nrb::inline spline
