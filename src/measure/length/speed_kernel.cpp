// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "measure/length/speed_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "measure/length/speed_kernel.h"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace nrb::measure {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Vec8 = hn::CappedTag<double, 8>;

// kDegree: -1 if it is not a compile-time constant.
template <int kDegree>
HWY_INLINE hn::Vec<Vec8> polynomial(const double *HWY_RESTRICT row, const double *HWY_RESTRICT basis,
                                    int degree) {
    const Vec8 d;
    const int n = kDegree < 0 ? degree : kDegree;
    auto sum = hn::Mul(hn::Set(d, row[0]), hn::LoadU(d, basis));
    for (int i = 1; i <= n; ++i) {
        sum = hn::MulAdd(hn::Set(d, row[i]), hn::LoadU(d, basis + i * rule_capacity), sum);
    }
    return sum;
}

template <int kDegree, int kWeights>
HWY_INLINE hn::Vec<Vec8> speed(const SpeedForm &form, const double *HWY_RESTRICT net, int node) {
    const Vec8 d;
    auto square = hn::Zero(d);
    const double *row = net;
    for (int c = 0; c < form.dim; ++c, row += form.degree + 1) {
        const auto x = polynomial<kDegree>(row, form.basis + node, form.degree);
        square = hn::MulAdd(x, x, square);
    }
    const auto speed = hn::Sqrt(square);
    if (form.weight_degree < 0) {
        return speed;
    }
    const auto w = polynomial<kWeights>(row, form.weight_basis + node, form.weight_degree);
    return hn::Div(speed, hn::Mul(w, w));
}

// Calls visit<kDegree, kWeights>() with the degrees as constants for cubics.
template <class Visit>
HWY_INLINE void with_degrees(const SpeedForm &form, Visit &&visit) {
    if (form.degree == 4 && form.weight_degree == 3) {
        visit.template operator()<4, 3>();
    } else if (form.degree == 2) {
        visit.template operator()<2, -1>();
    } else {
        visit.template operator()<-1, -1>();
    }
}

void speeds(const SpeedForm &form, const double *net, int first, int count, double *out) {
    const Vec8 d;
    with_degrees(form, [&]<int kDegree, int kWeights>() HWY_ATTR {
        for (int node = first; node < first + count; node += static_cast<int>(hn::Lanes(d))) {
            hn::StoreU(speed<kDegree, kWeights>(form, net, node), d, out + node);
        }
    });
}

RuleDecay rule_decay(int level, const double *values) {
    const Vec8 d;
    const DecayRows &rows = decay_rows[static_cast<size_t>(level)];
    const int count = std::max(8, rule_size(level));
    std::array<double, decay_sums> sums;
    for (size_t row = 0; row < rows.size(); ++row) {
        auto sum = hn::Zero(d);
        for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
            sum = hn::MulAdd(hn::LoadU(d, rows[row] + i), hn::LoadU(d, values + i), sum);
        }
        sums[row] = hn::GetLane(hn::SumOfLanes(d, sum));
    }
    return decay_of(sums);
}

RuleDecay speed_decay(const SpeedForm &form, const double *net, int first, int level, double *values) {
    HWY_NAMESPACE::speeds(form, net, first, rule_size(level) - first, values);
    return HWY_NAMESPACE::rule_decay(level, values);
}

double sum_of_speeds(const SpeedForm &form, const double *nets, int64_t count, const double *factors) {
    const Vec8 d;
    const int64_t size = form.size();
    auto sum = hn::Zero(d);
    with_degrees(form, [&]<int kDegree, int kWeights>() HWY_ATTR {
        for (int64_t i = 0; i < count; ++i) {
            for (int node = 0; node < 8; node += static_cast<int>(hn::Lanes(d))) {
                sum = hn::MulAdd(speed<kDegree, kWeights>(form, nets + i * size, node),
                                 hn::LoadU(d, factors + node), sum);
            }
        }
    });
    return hn::GetLane(hn::SumOfLanes(d, sum));
}

} // namespace HWY_NAMESPACE
} // namespace nrb::measure
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::measure {

NURBS_FORMS(speeds);

void speeds(const SpeedForm &form, const double *net, int first, int count, double *out) noexcept {
    NURBS_BEST(speeds)(form, net, first, count, out);
}

NURBS_FORMS(speed_decay);

RuleDecay speed_decay(const SpeedForm &form, const double *net, int first, int level,
                      double *values) noexcept {
    return NURBS_BEST(speed_decay)(form, net, first, level, values);
}

NURBS_FORMS(sum_of_speeds);

double sum_of_speeds(const SpeedForm &form, const double *nets, int64_t count,
                     const double *factors) noexcept {
    return NURBS_BEST(sum_of_speeds)(form, nets, count, factors);
}

NURBS_FORMS(rule_decay);

RuleDecay rule_decay(int level, const double *values) noexcept {
    return NURBS_BEST(rule_decay)(level, values);
}

} // namespace nrb::measure
#endif
