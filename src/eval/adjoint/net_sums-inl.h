// SPDX-License-Identifier: MIT
// What the kernels of net_kernel.h share: the arrays, and sums across lanes. Included once for every
// instruction set: see base/simd.h.
#if defined(NURBS_EVAL_ADJOINT_NET_SUMS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_EVAL_ADJOINT_NET_SUMS_INL_H_
#undef NURBS_EVAL_ADJOINT_NET_SUMS_INL_H_
#else
#define NURBS_EVAL_ADJOINT_NET_SUMS_INL_H_
#endif

#include "eval/adjoint/net_kernel.h"
#include "eval/kernels/horner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

using Vector = hn::Vec<Vec4>;

// The arrays of a job, kept in registers if there are enough.
struct NetArrays {
    explicit NetArrays(const NetJob &job)
        : size(job.size), weights(job.weights), coordinates(job.coordinates), grad_points(job.grad_points),
          grad_weights(job.grad_weights) {}

    int64_t size;
    const double *HWY_RESTRICT weights;
    const double *HWY_RESTRICT coordinates;
    double *HWY_RESTRICT grad_points;
    double *HWY_RESTRICT grad_weights;
};

#if HWY_MAX_BYTES >= 32
// (a0 + a1, b0 + b1, a2 + a3, b2 + b3)
HWY_INLINE Vector sums_of_pairs(Vector a, Vector b) {
    return hn::Add(hn::InterleaveLower(Vec4(), a, b), hn::InterleaveUpper(Vec4(), a, b));
}
#endif

struct Pair {
    double first;
    double second;
};
// The sum of the lanes of each of two vectors.
HWY_INLINE Pair sums_of(Vector a, Vector b) {
#if HWY_MAX_BYTES >= 32
    const hn::CappedTag<double, 2> half;
    const auto both = sums_of_pairs(a, b);
    const auto sums = hn::Add(hn::LowerHalf(half, both), hn::UpperHalf(half, both));
    return {hn::GetLane(sums), hn::ExtractLane(sums, 1)};
#else
    return {hn::GetLane(hn::SumOfLanes(Vec4(), a)), hn::GetLane(hn::SumOfLanes(Vec4(), b))};
#endif
}

// The sum of the lanes of each of four vectors, with the bits of sums_of().
HWY_INLINE void sums_of_four(Vector a, Vector b, Vector c, Vector e, double *HWY_RESTRICT out) {
#if HWY_MAX_BYTES >= 32
    const Vec4 d;
    const auto first = sums_of_pairs(a, b), second = sums_of_pairs(c, e);
    hn::StoreU(hn::Add(hn::ConcatLowerLower(d, second, first), hn::ConcatUpperUpper(d, second, first)), d,
               out);
#else
    const Pair first = sums_of(a, b), second = sums_of(c, e);
    out[0] = first.first;
    out[1] = first.second;
    out[2] = second.first;
    out[3] = second.second;
#endif
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#endif
