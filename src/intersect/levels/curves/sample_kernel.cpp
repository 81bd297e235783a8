// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "intersect/levels/curves/sample_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "intersect/levels/curves/sample_kernel.h"

#include "bernstein/de_casteljau.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

HWY_INLINE Values form_of(const double *form, const Values *record) {
    const Vec8 d;
    auto sum = hn::Mul(hn::Set(d, form[0]), record[0]);
    for (size_t c = 1; c < 4; ++c) {
        sum = hn::MulAdd(hn::Set(d, form[c]), record[c], sum);
    }
    return sum;
}

// The largest of all; infinite if there is a NaN, which makes the sum one.
HWY_INLINE double largest_of(Values largest, Values sum) {
    const Vec8 d;
    return std::isnan(hn::GetLane(hn::SumOfLanes(d, sum))) ? HUGE_VAL
                                                           : hn::GetLane(hn::MaxOfLanes(d, largest));
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
