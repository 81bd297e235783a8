// SPDX-License-Identifier: MIT
// The quotient rule on vectors. Included once for every instruction set: see base/simd.h.
#if defined(NURBS_EVAL_KERNELS_QUOTIENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_EVAL_KERNELS_QUOTIENT_INL_H_
#undef NURBS_EVAL_KERNELS_QUOTIENT_INL_H_
#else
#define NURBS_EVAL_KERNELS_QUOTIENT_INL_H_
#endif

#include "eval/kernels/quotient.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The quotient rule for the frequent shapes, written out, with the terms in the order of QuotientRule. a:
// homogeneous derivatives, which are replaced by the Cartesian ones. w: derivatives of the weight; w[0] is
// not read. inverse: 1 / w. Lanes are components or points.
template <class V>
HWY_INLINE V without(V sum, V weight, V value) {
    return hn::NegMulAdd(weight, value, sum);
}

template <int kAxes, int kOrder, class V>
HWY_INLINE void divide(const V *HWY_RESTRICT w, V inverse, V *HWY_RESTRICT a) {
    static_assert(kOrder <= 1 || (kOrder == 2 && kAxes <= 2));
    a[0] = hn::Mul(a[0], inverse);
    if constexpr (kOrder >= 1) {
        for (int s = 1; s <= kAxes; ++s) {
            a[s] = hn::Mul(without(a[s], w[s], a[0]), inverse);
        }
    }
    if constexpr (kOrder == 2 && kAxes == 1) {
        a[2] = hn::Mul(without(without(a[2], hn::Add(w[1], w[1]), a[1]), w[2], a[0]), inverse);
    }
    if constexpr (kOrder == 2 && kAxes == 2) {
        a[3] = hn::Mul(without(without(a[3], hn::Add(w[1], w[1]), a[1]), w[3], a[0]), inverse);
        a[4] = hn::Mul(without(without(without(a[4], w[2], a[1]), w[1], a[2]), w[4], a[0]), inverse);
        a[5] = hn::Mul(without(without(a[5], hn::Add(w[2], w[2]), a[2]), w[5], a[0]), inverse);
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#endif
