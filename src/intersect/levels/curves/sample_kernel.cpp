// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "intersect/levels/curves/sample_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "intersect/levels/curves/net_samples-inl.h"
#include "intersect/levels/curves/sample_kernel.h"

#include "bernstein/de_casteljau.h"

#include <algorithm>
#include <cmath>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace nrb::intersect {
namespace HWY_NAMESPACE {

HWY_INLINE Values form_of(const double *form, const Values *record) {
    const Vec8 d;
    auto sum = hn::Mul(hn::Set(d, form[0]), record[0]);
    for (size_t c = 1; c < 4; ++c) {
        sum = hn::MulAdd(hn::Set(d, form[c]), record[c], sum);
    }
    return sum;
}

LargestDifferences differences(const SampledPiece &piece, const CubicSamples &samples,
                               const std::array<std::array<double, 2>, 4> &on,
                               const std::array<std::array<double, 3>, 4> &space, double *work) {
    const Vec8 d;
    const size_t count = samples.count();
    auto value = hn::Zero(d), values = value, square = value, squares = value;
    for (size_t i = 0; i < count; i += lanes) {
        const double *const functions = samples.functions() + i;
        const auto u = on_cubic(on, 0, functions, count), v = on_cubic(on, 1, functions, count);
        Values record[4], own[1];
        evaluate_net<4>(piece.records, u, v, work, record);
        if (piece.form != nullptr) {
            own[0] = form_of(piece.form, record);
        } else {
            evaluate_net<1>(piece.net, u, v, work, own);
        }
        own[0] = hn::Abs(own[0]);
        value = hn::Max(value, own[0]);
        values = hn::Add(values, own[0]);
        auto sum = hn::Zero(d);
        for (size_t c = 0; c < 3; ++c) {
            const auto apart = hn::MulSub(record[3], on_cubic(space, c, functions, count), record[c]);
            sum = hn::MulAdd(apart, apart, sum);
        }
        square = hn::Max(square, sum);
        squares = hn::Add(squares, sum);
    }
    return {largest_of(value, values), std::sqrt(largest_of(square, squares))};
}

} // namespace HWY_NAMESPACE
} // namespace nrb::intersect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::intersect {

CubicSamples::CubicSamples(int n) {
    constexpr size_t unit = 8;
    const size_t count = (static_cast<size_t>(n) + unit) / unit * unit;
    functions_.resize(4 * count);
    for (size_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(std::min(i, static_cast<size_t>(n))) / n;
        double functions[4];
        bernstein_functions(3, 0.5 - 0.5 * std::cos(std::numbers::pi * share), functions);
        for (size_t k = 0; k < 4; ++k) {
            functions_[k * count + i] = functions[k];
        }
    }
}

NURBS_FORMS(differences);

LargestDifferences largest_differences(const SampledPiece &piece, const CubicSamples &samples,
                                       const std::array<std::array<double, 2>, 4> &on,
                                       const std::array<std::array<double, 3>, 4> &space,
                                       double *work) noexcept {
    return NURBS_BEST(differences)(piece, samples, on, space, work);
}

} // namespace nrb::intersect
#endif
