// SPDX-License-Identifier: MIT
// Nets of surfaces at samples of cubic curves. Included once for every instruction set: see base/simd.h.
#if defined(NURBS_INTERSECT_NET_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_INTERSECT_NET_SAMPLES_INL_H_
#undef NURBS_INTERSECT_NET_SAMPLES_INL_H_
#else
#define NURBS_INTERSECT_NET_SAMPLES_INL_H_
#endif

#include "intersect/levels/curves/sample_kernel.h"

#include <hwy/highway.h>

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace nrb::intersect {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Vec8 = hn::CappedTag<double, 8>;
using Values = hn::Vec<Vec8>;
inline constexpr int lanes = static_cast<int>(hn::MaxLanes(Vec8()));

// Functions B_0 ... B_degree at x, one after the other in out.
HWY_INLINE void bernstein_at(int degree, Values x, double *HWY_RESTRICT out) {
    const Vec8 d;
    const auto other = hn::Sub(hn::Set(d, 1.0), x);
    hn::StoreU(hn::Set(d, 1.0), d, out);
    for (int j = 1; j <= degree; ++j) {
        auto carried = hn::Zero(d);
        for (int k = 0; k < j; ++k) {
            const auto own = hn::LoadU(d, out + k * lanes);
            hn::StoreU(hn::MulAdd(other, own, carried), d, out + k * lanes);
            carried = hn::Mul(x, own);
        }
        hn::StoreU(carried, d, out + j * lanes);
    }
}

template <int kWidth>
HWY_INLINE void evaluate_net(const SampledNet &net, Values u, Values v, double *HWY_RESTRICT work,
                             Values *HWY_RESTRICT sum) {
    const Vec8 d;
    double *const across = work, *const along = work + (net.degrees[0] + 1) * lanes;
    bernstein_at(net.degrees[0], u, across);
    bernstein_at(net.degrees[1], v, along);
    for (int c = 0; c < kWidth; ++c) {
        sum[c] = hn::Zero(d);
    }
    const double *values = net.values;
    for (int i = 0; i <= net.degrees[0]; ++i) {
        Values row[kWidth];
        for (int c = 0; c < kWidth; ++c) {
            row[c] = hn::Zero(d);
        }
        for (int j = 0; j <= net.degrees[1]; ++j, values += kWidth) {
            const auto factor = hn::LoadU(d, along + j * lanes);
            for (int c = 0; c < kWidth; ++c) {
                row[c] = hn::MulAdd(factor, hn::Set(d, values[c]), row[c]);
            }
        }
        const auto factor = hn::LoadU(d, across + i * lanes);
        for (int c = 0; c < kWidth; ++c) {
            sum[c] = hn::MulAdd(factor, row[c], sum[c]);
        }
    }
}

// Coordinate c at samples.
template <size_t N>
HWY_INLINE Values on_cubic(const std::array<std::array<double, N>, 4> &points, size_t c,
                           const double *HWY_RESTRICT functions, size_t count) {
    const Vec8 d;
    auto sum = hn::Mul(hn::LoadU(d, functions), hn::Set(d, points[0][c]));
    for (size_t i = 1; i < 4; ++i) {
        sum = hn::MulAdd(hn::LoadU(d, functions + i * count), hn::Set(d, points[i][c]), sum);
    }
    return sum;
}

// The largest of all; infinite if there is a NaN, which makes the sum one.
HWY_INLINE double largest_of(Values largest, Values sum) {
    const Vec8 d;
    return std::isnan(hn::GetLane(hn::SumOfLanes(d, sum))) ? HUGE_VAL
                                                           : hn::GetLane(hn::MaxOfLanes(d, largest));
}

} // namespace HWY_NAMESPACE
} // namespace nrb::intersect
HWY_AFTER_NAMESPACE();

#endif
