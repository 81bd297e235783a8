// SPDX-License-Identifier: MIT
// Points of Bernstein spans. Included once for every instruction set: see base/simd.h.
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

// Where the sum of the powers of q = min((t - a) / (b - t), (b - t) / (t - a)) begins, and which way it goes.
struct BernsteinPlace {
    // Precondition: t lies strictly inside the span.
    HWY_INLINE BernsteinPlace(const double *span, int degree, int lanes, double t) {
        const double before = t - span[BernsteinSpan::a], after = span[BernsteinSpan::b] - t;
        const auto lower = static_cast<int64_t>(before <= after); // without jumps, which nobody could foresee
        q = std::min(before, after) / std::max(before, after);
        start = span + BernsteinSpan::head_size + lower * degree * lanes;
        step = lanes - 2 * lower * lanes;
    }

    // Homogeneous components l, l + 1, ..., but for a factor.
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

// The point at t, followed by numbers of no meaning up to whole vectors. point: [lanes].
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
