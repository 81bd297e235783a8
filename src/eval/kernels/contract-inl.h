// SPDX-License-Identifier: MIT
// Weighted sums of rows. Included once for every instruction set: see base/simd.h.
#if defined(NURBS_EVAL_KERNELS_CONTRACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_EVAL_KERNELS_CONTRACT_INL_H_
#undef NURBS_EVAL_KERNELS_CONTRACT_INL_H_
#else
#define NURBS_EVAL_KERNELS_CONTRACT_INL_H_
#endif

#include "eval/kernels/horner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

// One vector of the weighted sum of n rows, `stride` apart. n is kDegree + 1, or any number if kDegree < 0.
template <int kDegree, class D>
HWY_INLINE hn::Vec<D> contracted(D d, const double *HWY_RESTRICT coefficients, int n,
                                 const double *HWY_RESTRICT rows, int64_t stride) {
    const int count = kDegree >= 0 ? kDegree + 1 : n;
    auto sum = hn::Mul(hn::Set(d, coefficients[0]), hn::LoadU(d, rows));
    for (int i = 1; i < count; ++i) {
        rows += stride;
        sum = hn::MulAdd(hn::Set(d, coefficients[i]), hn::LoadU(d, rows), sum);
    }
    return sum;
}

template <int kDegree>
HWY_INLINE void contract_degree(const double *HWY_RESTRICT coefficients, int n,
                                const double *HWY_RESTRICT rows, int64_t stride, int64_t length,
                                double *HWY_RESTRICT out) {
    int64_t l = 0;
    for (; l + vec8_lanes <= length; l += vec8_lanes) {
        hn::StoreU(contracted<kDegree>(Vec8(), coefficients, n, rows + l, stride), Vec8(), out + l);
    }
    for (; l + vec4_lanes <= length; l += vec4_lanes) {
        hn::StoreU(contracted<kDegree>(Vec4(), coefficients, n, rows + l, stride), Vec4(), out + l);
    }
    for (; l < length; ++l) {
        hn::StoreU(contracted<kDegree>(hn::CappedTag<double, 1>(), coefficients, n, rows + l, stride),
                   hn::CappedTag<double, 1>(), out + l);
    }
}

// The weighted sum of n rows: out[l] = coefficients[0] * rows[l], then + coefficients[i] * rows[i * stride +
// l] in rising order of i, fused if the instruction set has fused multiply-adds, for all l < length. The
// operations for one l depend neither on the length nor on the vectors. Preconditions: n >= 1; out overlaps
// nothing.
HWY_INLINE void contract_rows(const double *coefficients, int n, const double *rows, int64_t stride,
                              int64_t length, double *out) {
    if (n == 4) {
        contract_degree<3>(coefficients, n, rows, stride, length, out);
    } else {
        contract_degree<-1>(coefficients, n, rows, stride, length, out);
    }
}

// kVectors vectors of the sums for kOrders sets of coefficients. The sets are `lanes` apart, the sums
// `length` apart.
template <int kOrders, int kVectors, class D>
HWY_INLINE void contract_orders(D d, const double *HWY_RESTRICT coefficients, int lanes, int n,
                                const double *HWY_RESTRICT rows, int64_t stride, int64_t length,
                                double *HWY_RESTRICT out) {
    constexpr int step = static_cast<int>(hn::MaxLanes(d));
    hn::Vec<D> sums[kVectors][kOrders];
    for (int a = 0; a < kOrders; ++a) {
        for (int v = 0; v < kVectors; ++v) {
            sums[v][a] = hn::Mul(hn::Set(d, coefficients[a * lanes]), hn::LoadU(d, rows + v * step));
        }
    }
    for (int i = 1; i < n; ++i) {
        rows += stride;
        for (int a = 0; a < kOrders; ++a) {
            const auto coefficient = hn::Set(d, coefficients[a * lanes + i]);
            for (int v = 0; v < kVectors; ++v) {
                sums[v][a] = hn::MulAdd(coefficient, hn::LoadU(d, rows + v * step), sums[v][a]);
            }
        }
    }
    for (int v = 0; v < kVectors; ++v) {
        for (int a = 0; a < kOrders; ++a) {
            hn::StoreU(sums[v][a], d, out + v * step + a * length);
        }
    }
}

// contract_rows() for the functions and for their derivatives of orders below kOrders at once. Precondition:
// the length is a multiple of 4.
template <int kOrders>
HWY_INLINE void contract_rows_of_orders(const double *coefficients, int lanes, int n, const double *rows,
                                        int64_t stride, int64_t length, double *out) {
    int64_t l = 0;
    for (; l + 3 * vec8_lanes <= length; l += 3 * vec8_lanes) {
        contract_orders<kOrders, 3>(Vec8(), coefficients, lanes, n, rows + l, stride, length, out + l);
    }
    for (; l + vec8_lanes <= length; l += vec8_lanes) {
        contract_orders<kOrders, 1>(Vec8(), coefficients, lanes, n, rows + l, stride, length, out + l);
    }
    for (; l < length; l += vec4_lanes) {
        contract_orders<kOrders, 1>(Vec4(), coefficients, lanes, n, rows + l, stride, length, out + l);
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#endif
