// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "intersect/projection/feet/feet_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "intersect/levels/curves/net_samples-inl.h"
#include "intersect/projection/feet/feet_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace nrb::intersect {
namespace HWY_NAMESPACE {

HWY_INLINE Values product_of_four(const Values *a, const Values *b) {
    auto sum = hn::Mul(a[0], b[0]);
    for (int c = 1; c < 4; ++c) {
        sum = hn::MulAdd(a[c], b[c], sum);
    }
    return sum;
}

// Updates the largest magnitude and the sum of all magnitudes; the sum shows whether there was a NaN.
HWY_INLINE void add_value(Values x, Values &most, Values &sum) {
    const auto size = hn::Abs(x);
    most = hn::Max(most, size);
    sum = hn::Add(sum, size);
}

LargestOfFeet feet_samples(const SampledFeet &feet, const CubicSamples &samples,
                           const std::array<std::array<std::array<double, 2>, 4>, 2> &on,
                           const std::array<std::array<double, 3>, 4> &space, double *work) {
    const Vec8 d;
    const size_t count = samples.count();
    Values most[4], sums[4]; // for F_0, F_1, the gap and the distance
    for (int k = 0; k < 4; ++k) {
        most[k] = sums[k] = hn::Zero(d);
    }
    for (size_t i = 0; i < count; i += lanes) {
        const double *const functions = samples.functions() + i;
        const auto u = on_cubic(on[0], 0, functions, count), v = on_cubic(on[0], 1, functions, count),
                   t = on_cubic(on[1], 0, functions, count), h = on_cubic(on[1], 1, functions, count);
        Values of_surface[8], own[4], record[4];
        evaluate_net<8>(feet.surface, u, v, work, of_surface);
        evaluate_net<4>(feet.curve, t, hn::Zero(d), work, own);
        evaluate_net<4>(feet.records, u, v, work, record);
        for (int e = 0; e < 2; ++e) {
            add_value(product_of_four(of_surface + 4 * e, own), most[e], sums[e]);
        }
        auto apart = hn::Zero(d), square = apart;
        for (size_t c = 0; c < 3; ++c) {
            const auto off = hn::MulSub(record[3], on_cubic(space, c, functions, count), record[c]),
                       between = hn::MulAdd(record[c], own[0], hn::Mul(own[1 + c], record[3]));
            apart = hn::MulAdd(off, off, apart);
            square = hn::MulAdd(between, between, square);
        }
        add_value(apart, most[2], sums[2]);
        const auto height = hn::Mul(h, hn::Mul(record[3], own[0]));
        add_value(hn::MulSub(height, height, square), most[3], sums[3]);
    }
    return {{largest_of(most[0], sums[0]), largest_of(most[1], sums[1])},
            largest_of(most[2], sums[2]),
            largest_of(most[3], sums[3])};
}

} // namespace HWY_NAMESPACE
} // namespace nrb::intersect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::intersect {

NURBS_FORMS(feet_samples);

LargestOfFeet largest_of_feet(const SampledFeet &feet, const CubicSamples &samples,
                              const std::array<std::array<std::array<double, 2>, 4>, 2> &on,
                              const std::array<std::array<double, 3>, 4> &space, double *work) noexcept {
    return NURBS_BEST(feet_samples)(feet, samples, on, space, work);
}

} // namespace nrb::intersect
#endif
