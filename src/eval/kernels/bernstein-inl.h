// SPDX-License-Identifier: MIT
// Evaluation of Bernstein spans (basis/bernstein_span.h) by Horner's rule. Included once for every
// instruction set: see base/simd.h.
#if defined(NURBS_EVAL_KERNELS_BERNSTEIN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_EVAL_KERNELS_BERNSTEIN_INL_H_
#undef NURBS_EVAL_KERNELS_BERNSTEIN_INL_H_
#else
#define NURBS_EVAL_KERNELS_BERNSTEIN_INL_H_
#endif

#include "basis/bernstein_span.h"
#include "eval/kernels/horner-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

// Horner's rule at one parameter of a span [a, b], in q = min((t - a) / (b - t), (b - t) / (t - a)) <= 1: the
// coefficient with which the rule begins, and the step from one coefficient to the next, which is negative in
// the first half of the span.
struct BernsteinPlace {
    // Precondition: t lies strictly inside the span.
    HWY_INLINE BernsteinPlace(const double *span, int degree, int lanes, double t) {
        const double before = t - span[BernsteinSpan::a], after = span[BernsteinSpan::b] - t;
        const auto lower = static_cast<int64_t>(before <= after); // without an unpredictable branch
        q = std::min(before, after) / std::max(before, after);
        start = span + BernsteinSpan::head_size + lower * degree * lanes;
        step = lanes - 2 * lower * lanes;
    }

    // The homogeneous components l, l + 1, ... of one vector, up to a factor that all components share.
    [[nodiscard]] HWY_INLINE hn::Vec<Vec4> components(int degree, int l) const {
        const Vec4 d;
        const auto x = hn::Set(d, q);
        const double *next = start + l;
        auto sum = hn::LoadU(d, next);
        for (int i = 0; i < degree; ++i) {
            next += step;
            sum = hn::MulAdd(sum, x, hn::LoadU(d, next));
        }
        return sum;
    }

    double q;
    const double *start;
    int64_t step;
};

HWY_INLINE bool inside_bernstein_span(const double *span, double t) {
    return t > span[BernsteinSpan::a] && t < span[BernsteinSpan::b];
}

// The point at t, [dim], padded with meaningless numbers. point: [lanes].
HWY_INLINE void bernstein_point(const double *span, int degree, int dim, int lanes, double t, double *point) {
    const Vec4 d;
    const BernsteinPlace place(span, degree, lanes, t);
    for (int l = 0; l <= dim; l += vec4_lanes) {
        hn::StoreU(place.components(degree, l), d, point + l);
    }
    const auto inverse = hn::Set(d, 1 / point[dim]);
    for (int l = 0; l < dim; l += vec4_lanes) {
        hn::StoreU(hn::Mul(hn::LoadU(d, point + l), inverse), d, point + l);
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#endif
