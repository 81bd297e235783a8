// SPDX-License-Identifier: MIT
// Horner's rule on power spans. Included once for every instruction set: see base/simd.h.
#if defined(NURBS_EVAL_KERNELS_HORNER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_EVAL_KERNELS_HORNER_INL_H_
#undef NURBS_EVAL_KERNELS_HORNER_INL_H_
#else
#define NURBS_EVAL_KERNELS_HORNER_INL_H_
#endif

#include "basis/power_spans.h"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Vectors of up to 4 and up to 8 doubles, whose lanes are components of one record or different parameters.
// The arithmetic of a lane depends neither on the width of the vector nor on what the lanes are. Therefore
// all ways to evaluate a point agree in every bit.
using Vec4 = hn::CappedTag<double, 4>;
using Vec8 = hn::CappedTag<double, 8>;

inline constexpr int vec8_lanes = static_cast<int>(hn::MaxLanes(Vec8()));
inline constexpr int vec4_lanes = static_cast<int>(hn::MaxLanes(Vec4()));

// One step of Horner's rule for derivatives 0, ..., kOrders - 1 divided by their factorials, by repeated
// synthetic division: multiplies by x and adds the next coefficient.
template <int kOrders, class V>
HWY_INLINE void horner_step(V x, V coefficient, V *HWY_RESTRICT y) {
    for (int k = kOrders - 1; k > 0; --k) {
        y[k] = hn::MulAdd(y[k], x, y[k - 1]);
    }
    y[0] = hn::MulAdd(y[0], x, coefficient);
}

// How a vector of coefficients is loaded: consecutive components, beginning at `powers`, or one component for
// all lanes.
struct Components {
    template <class D>
    HWY_INLINE hn::Vec<D> operator()(D d, const double *powers) const {
        return hn::LoadU(d, powers);
    }
};
struct OneComponent {
    template <class D>
    HWY_INLINE hn::Vec<D> operator()(D d, const double *powers) const {
        return hn::Set(d, *powers);
    }
};

// The polynomial with the coefficients powers[k * stride], k = 0, ..., degree, and its derivatives with
// respect to t, at the local parameter x; `factor` is dx/dt. kDegree < 0 stands for any degree.
template <int kOrders, int kDegree, class D, class Load>
HWY_INLINE void horner_vector(D d, Load load, const double *HWY_RESTRICT powers, int degree, int64_t stride,
                              hn::Vec<D> x, double factor, hn::Vec<D> *HWY_RESTRICT y) {
    const int steps = kDegree >= 0 ? kDegree : degree;
    const double *next = powers + steps * stride;
    y[0] = load(d, next);
    for (int k = 1; k < kOrders; ++k) {
        y[k] = hn::Zero(d);
    }
    for (int i = 0; i < steps; ++i) {
        next -= stride;
        horner_step<kOrders>(x, load(d, next), y);
    }
    double product = 1;
    for (int k = 1; k < kOrders; ++k) {
        product *= k * factor;
        y[k] = hn::Mul(y[k], hn::Set(d, product));
    }
}

// The number of orders that the kernels for any order compute; derivatives above the degree of a power span
// are 0.
inline constexpr int most_orders = max_power_span_degree + 1;

// Components l, l + 1, ... of a power span at x, as many as a vector holds, with derivatives.
template <int kOrders, int kDegree, class D>
HWY_INLINE void horner_lanes(D d, int order, const double *HWY_RESTRICT power_span, int degree, int lanes,
                             int l, double x, double *HWY_RESTRICT out) {
    hn::Vec<D> y[kOrders];
    horner_vector<kOrders, kDegree>(d, Components(), power_span + PowerSpan::head_size + l, degree, lanes,
                                    hn::Set(d, x), power_span[PowerSpan::scale], y);
    for (int k = 0; k < kOrders; ++k) {
        if (kOrders < most_orders || k <= order) {
            hn::StoreU(y[k], d, out + static_cast<int64_t>(k) * lanes + l);
        }
    }
}

// All components of a power span and their derivatives at t. out: [order + 1][lanes].
template <int kOrders, int kDegree>
HWY_INLINE void horner_record(int order, const double *HWY_RESTRICT power_span, int degree, int lanes,
                              double t, double *HWY_RESTRICT out) {
    const double x = (t - power_span[PowerSpan::middle]) * power_span[PowerSpan::scale];
    int l = 0;
    for (; l + vec8_lanes <= lanes; l += vec8_lanes) {
        horner_lanes<kOrders, kDegree>(Vec8(), order, power_span, degree, lanes, l, x, out);
    }
    for (; l < lanes; l += vec4_lanes) {
        horner_lanes<kOrders, kDegree>(Vec4(), order, power_span, degree, lanes, l, x, out);
    }
    if constexpr (kOrders == most_orders) {
        std::fill_n(out + static_cast<int64_t>(kOrders) * lanes,
                    static_cast<int64_t>(std::max(order + 1 - kOrders, 0)) * lanes, 0.0);
    }
}

HWY_INLINE void horner(int order, const double *power_span, int degree, int lanes, double t, double *out) {
    switch (order) {
    case 0:
        return horner_record<1, -1>(order, power_span, degree, lanes, t, out);
    case 1:
        return horner_record<2, -1>(order, power_span, degree, lanes, t, out);
    case 2:
        return horner_record<3, -1>(order, power_span, degree, lanes, t, out);
    default:
        return horner_record<most_orders, -1>(order, power_span, degree, lanes, t, out);
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#endif
