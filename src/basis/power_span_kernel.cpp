// SPDX-License-Identifier: MIT
// Power spans of degrees above max_blossom_degree, several at a time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "basis/power_span_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "basis/power_spans.h"
#include "numeric/binomial.h"
#include "numeric/double_double-inl.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace nrb::inline basis {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using namespace numeric::HWY_NAMESPACE;

using Vec8 = hn::CappedTag<double, 8>;

// The basis functions of several spans, one span in each lane, expanded about the middles of the spans.
template <class D>
class CentredFunctions {
public:
    static constexpr int most = max_power_span_degree;
    using V = hn::Vec<D>;
    using Number = DoubleDoubleLanes<V>;

    // knots: [2 degree][lanes], those before the middle first; the local parameter is (t - middle) * scale.
    HWY_INLINE CentredFunctions(D d, int degree, const double *knots, V middle, V scale) : d_(d) {
        Number after[most];
        Number ahead[most];
        const auto lanes = static_cast<int>(hn::Lanes(d));
#pragma GCC unroll 4
        for (int i = 0; i < degree; ++i) {
            after[i] =
                scaled(exact_sum(middle, hn::Neg(hn::LoadU(d, knots + (degree - 1 - i) * lanes))), scale);
            ahead[i] = scaled(exact_sum(hn::LoadU(d, knots + (degree + i) * lanes), hn::Neg(middle)), scale);
        }
        for (int e = 1; e <= degree; ++e) {
#pragma GCC unroll 4
            for (int r = 0; r < e; ++r) {
                const Number slope = inverse(after[e - 1 - r] + ahead[r]);
                slope_[e - 1][r] = slope;
                after_[e - 1][r] = after[e - 1 - r] * slope;
                ahead_[e - 1][r] = ahead[r] * slope;
            }
        }
    }

    // One step of the Cox-de Boor recurrence at the middle, from degree e - 1 to degree e.
    HWY_INLINE void raise_degree(int e, Number *functions) const {
        Number carried{hn::Zero(d_), hn::Zero(d_)};
#pragma GCC unroll 4
        for (int r = 0; r < e; ++r) {
            const Number before = functions[r];
            functions[r] = carried + before * ahead_[e - 1][r];
            carried = before * after_[e - 1][r];
        }
        functions[e] = carried;
    }

    // The difference formula without its factor e: from derivatives of the functions of degree e - 1 to those
    // of degree e.
    HWY_INLINE void differentiate(int e, Number *functions) const {
        Number carried{hn::Zero(d_), hn::Zero(d_)};
#pragma GCC unroll 4
        for (int r = 0; r < e; ++r) {
            const Number slope = functions[r] * slope_[e - 1][r];
            functions[r] = carried - slope;
            carried = slope;
        }
        functions[e] = carried;
    }

private:
    static HWY_INLINE Number scaled(const Number &a, V scale) {
        return {hn::Mul(a.high, scale), hn::Mul(a.low, scale)};
    }

    D d_;
    Number slope_[most][most]; // [e - 1][r]: 1 / length of the support of function r of degree e - 1
    Number after_[most][most]; // the relative part of the support before the middle
    Number ahead_[most][most];
};

// Writes lane l of the coefficients to the power span of span l.
template <class D>
HWY_INLINE void store_row(D d, const DoubleDoubleLanes<hn::Vec<D>> *row, int degree, double factor,
                          int64_t offset, int count, double *const *power_spans, double *const *rests) {
    HWY_ALIGN double high[8] = {};
    HWY_ALIGN double low[8] = {};
#pragma GCC unroll 4
    for (int j = 0; j <= degree; ++j) {
        const DoubleDoubleLanes<hn::Vec<D>> product = exact_product(row[j].high, hn::Set(d, factor));
        const auto rest = hn::MulAdd(row[j].low, hn::Set(d, factor), product.low);
        const DoubleDoubleLanes<hn::Vec<D>> value = ordered_sum(product.high, rest);
        hn::Store(value.high, d, high);
        hn::Store(value.low, d, low);
        for (int l = 0; l < count; ++l) {
            power_spans[l][offset + j] = high[l];
            if (rests != nullptr) {
                rests[l][offset + j] = low[l];
            }
        }
    }
}

// Fills the coefficients of the power spans of `count` spans, at most one for each lane; the heads are
// already there. knots: as for CentredFunctions.
template <class D>
HWY_INLINE void fill_power_spans(D d, int degree, const double *knots, int count, double *const *power_spans,
                                 double *const *rests) {
    using Number = DoubleDoubleLanes<hn::Vec<D>>;
    HWY_ALIGN double middles[8];
    HWY_ALIGN double scales[8];
    for (int l = 0; l < static_cast<int>(hn::Lanes(d)); ++l) {
        middles[l] = power_spans[std::min(l, count - 1)][PowerSpan::middle];
        scales[l] = power_spans[std::min(l, count - 1)][PowerSpan::scale];
    }
    const CentredFunctions<D> centred(d, degree, knots, hn::Load(d, middles), hn::Load(d, scales));
    const int lanes = PowerSpan::lanes(degree + 1);
    Number functions[max_power_span_degree + 1];
    Number row[max_power_span_degree + 1];
    functions[0] = {hn::Set(d, 1.0), hn::Zero(d)};
    for (int e = 0; e <= degree; ++e) {
        if (e > 0) {
            centred.raise_degree(e, functions);
        }
        std::copy_n(functions, e + 1, row);
        for (int raised = e + 1; raised <= degree; ++raised) {
            centred.differentiate(raised, row);
        }
        // The factors degree, ..., e + 1 of the difference formula, divided by the factorial of the order.
        const int order = degree - e;
        const double factor = binomial(degree, order);
        store_row(d, row, degree, factor, PowerSpan::head_size + static_cast<int64_t>(order) * lanes, count,
                  power_spans, rests);
    }
}

void make_power_spans(const double *knots, int degree, const int64_t *spans, int count,
                      double *const *power_spans, double *const *rests) {
    HWY_ALIGN double local[2 * max_power_span_degree * 8];
    const int lanes = count == 1 ? 1 : static_cast<int>(hn::Lanes(Vec8()));
    for (int i = 0; i < 2 * degree; ++i) {
        for (int l = 0; l < lanes; ++l) {
            local[i * lanes + l] = knots[spans[std::min(l, count - 1)] - degree + 1 + i];
        }
    }
    if (count == 1) {
        fill_power_spans(hn::CappedTag<double, 1>(), degree, local, count, power_spans, rests);
    } else {
        fill_power_spans(Vec8(), degree, local, count, power_spans, rests);
    }
}

int power_span_lanes() {
    return static_cast<int>(hn::Lanes(Vec8()));
}

// Component c of power k: the sum over j of coefficient [k][j] times w_j x_jc, rounded once.
void combine(const double *HWY_RESTRICT basis, const double *HWY_RESTRICT rests, int degree,
             const double *HWY_RESTRICT weights, const double *HWY_RESTRICT points, int lanes,
             double *HWY_RESTRICT powers) {
    const hn::CappedTag<double, 4> d;
    using V = hn::Vec<hn::CappedTag<double, 4>>;
    const int functions = PowerSpan::lanes(degree + 1);
    for (int c = 0; c < lanes; c += static_cast<int>(hn::Lanes(d))) {
        DoubleDoubleLanes<V> products[max_power_span_degree + 1];
#pragma GCC unroll 4
        for (int j = 0; j <= degree; ++j) {
            products[j] = exact_product(hn::Set(d, weights[j]),
                                        hn::LoadU(d, points + static_cast<int64_t>(j) * lanes + c));
        }
        for (int k = 0; k <= degree; ++k) {
            DoubleDoubleLanes<V> sum{hn::Zero(d), hn::Zero(d)};
#pragma GCC unroll 4
            for (int j = 0; j <= degree; ++j) {
                const V coefficient = hn::Set(d, basis[k * functions + j]);
                const DoubleDoubleLanes<V> term = exact_product(coefficient, products[j].high);
                const DoubleDoubleLanes<V> next = exact_sum(sum.high, term.high);
                const V small =
                    hn::MulAdd(coefficient, products[j].low,
                               hn::MulAdd(hn::Set(d, rests[k * functions + j]), products[j].high, term.low));
                sum = {next.high, hn::Add(sum.low, hn::Add(next.low, small))};
            }
            hn::StoreU(hn::Add(sum.high, sum.low), d, powers + static_cast<int64_t>(k) * lanes + c);
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::inline basis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::inline basis {

namespace {

NURBS_FORMS(make_power_spans);
NURBS_FORMS(power_span_lanes);
NURBS_FORMS(combine);

} // namespace

void write_power_span_head(double lower, double upper, double *power_span) noexcept {
    const double middle = lower / 2 + upper / 2;
    const double radius = std::max(middle - lower, upper - middle);
    constexpr int largest_exponent = 1023;
    power_span[PowerSpan::lower] = lower;
    power_span[PowerSpan::upper] = upper;
    power_span[PowerSpan::middle] = middle;
    power_span[PowerSpan::scale] = std::ldexp(1.0, std::min(-std::ilogb(radius) - 1, largest_exponent));
}

void basis_power_spans(const double *knots, int degree, const int64_t *spans, int count,
                       double *const *power_spans, double *const *rests) noexcept {
    if (degree <= max_blossom_degree) {
        for (int l = 0; l < count; ++l) {
            low_basis_power_span(knots, degree, spans[l], power_spans[l],
                                 rests != nullptr ? rests[l] : nullptr);
        }
        return;
    }
    const int lanes = PowerSpan::lanes(degree + 1);
    for (int l = 0; l < count; ++l) {
        write_power_span_head(knots[spans[l]], knots[spans[l] + 1], power_spans[l]);
        std::fill_n(power_spans[l] + PowerSpan::head_size, static_cast<int64_t>(degree + 1) * lanes, 0.0);
    }
    NURBS_BEST(make_power_spans)(knots, degree, spans, count, power_spans, rests);
}

int power_spans_together() noexcept {
    return NURBS_BEST(power_span_lanes)();
}

void combine_power_spans(const double *basis, const double *rests, int degree, const double *weights,
                         const double *points, int lanes, double *powers) noexcept {
    NURBS_BEST(combine)
    (basis + PowerSpan::head_size, rests + PowerSpan::head_size, degree, weights, points, lanes, powers);
}

} // namespace nrb::inline basis
#endif
