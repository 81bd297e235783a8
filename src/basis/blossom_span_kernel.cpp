// SPDX-License-Identifier: MIT
// Power spans of low degree, one at a time, by blossoming.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "basis/blossom_span_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "basis/power_spans.h"
#include "numeric/double_double-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace nrb::inline basis {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using namespace numeric::HWY_NAMESPACE;

using Four = hn::CappedTag<double, 4>;
using V = hn::Vec<Four>;
using Number = DoubleDoubleLanes<V>;

// Sum and product without the final renormalisation, which makes the low part small relative to the high
// part. They lose about 2^-104 of the terms, and sums that cancel retain what their low parts hold.
HWY_INLINE Number loose_sum(const Number &a, const Number &b) {
    const Number sum = exact_sum(a.high, b.high);
    return {sum.high, hn::Add(sum.low, hn::Add(a.low, b.low))};
}
HWY_INLINE Number loose_difference(const Number &a, const Number &b) {
    return loose_sum(a, {hn::Neg(b.high), hn::Neg(b.low)});
}
HWY_INLINE Number loose_product(const Number &a, const Number &b) {
    const Number product = exact_product(a.high, b.high);
    return {product.high, hn::Add(product.low, hn::MulAdd(a.high, b.low, hn::Mul(a.low, b.high)))};
}

// For each step of de Boor's algorithm at the middle of a span: the inverse of the length of a support in the
// local parameter (slope), and the relative parts of the support after its start and ahead of the middle.
// Index e (e - 1) / 2 + r belongs to the support of the r-th active function of degree e - 1.
template <int kDegree>
class Supports {
public:
    HWY_INLINE Supports(const double *knots, int64_t span, double middle, double scale) {
        HWY_ALIGN double left[size_up] = {};
        HWY_ALIGN double right[size_up] = {};
        for (int e = 1; e <= kDegree; ++e) {
            for (int r = 0; r < e; ++r) {
                left[e * (e - 1) / 2 + r] = knots[span - (e - 1 - r)];
                right[e * (e - 1) / 2 + r] = knots[span + 1 + r];
            }
        }
        std::fill(left + size, left + size_up, left[0]);
        std::fill(right + size, right + size_up, right[0]);
        for (int i = 0; i < size_up; i += static_cast<int>(hn::Lanes(Four()))) {
            set(i, left, right, middle, scale);
        }
    }

    [[nodiscard]] HWY_INLINE Number slope(int i) const { return number(0, i); }
    [[nodiscard]] HWY_INLINE Number after(int i) const { return number(2, i); }
    [[nodiscard]] HWY_INLINE Number ahead(int i) const { return number(4, i); }

private:
    static constexpr int size = kDegree * (kDegree + 1) / 2;
    static constexpr int size_up = (size + 3) / 4 * 4;

    HWY_INLINE void set(int i, const double *left, const double *right, double middle, double scale) {
        const Four d;
        const V at = hn::Set(d, middle), unit = hn::Set(d, scale);
        Number after = exact_sum(at, hn::Neg(hn::Load(d, left + i)));
        Number ahead = exact_sum(hn::Load(d, right + i), hn::Neg(at));
        after = {hn::Mul(after.high, unit), hn::Mul(after.low, unit)};
        ahead = {hn::Mul(ahead.high, unit), hn::Mul(ahead.low, unit)};
        const Number slope = inverse(after + ahead);
        store(0, i, slope);
        store(2, i, after * slope);
        store(4, i, ahead * slope);
    }
    HWY_INLINE void store(int row, int i, const Number &number) {
        hn::Store(number.high, Four(), parts_[row] + i);
        hn::Store(number.low, Four(), parts_[row + 1] + i);
    }
    [[nodiscard]] HWY_INLINE Number number(int row, int i) const {
        return {hn::Set(Four(), parts_[row][i]), hn::Set(Four(), parts_[row + 1][i])};
    }

    HWY_ALIGN double parts_[6][size_up];
};

// Evaluates the polar form (blossom) of four components. It starts from the points and adds one argument
// after the other: the middle of the span or the direction of the parameter; values[k][r] has k directions.
// The directions are added first, so that differences are taken of points and of differences, never of means
// of points, whose rounding errors are those of larger terms.
template <int kDegree>
HWY_INLINE void blossom(const Supports<kDegree> &supports, Number (&values)[kDegree + 1][kDegree + 1]) {
#pragma GCC unroll 4
    for (int left = kDegree; left >= 1; --left) { // number of arguments that are missing
        const int given = kDegree - left, first = left * (left - 1) / 2;
#pragma GCC unroll 4
        for (int r = 0; r < left; ++r) {
            values[given + 1][r] = loose_product(loose_difference(values[given][r + 1], values[given][r]),
                                                 supports.slope(first + r));
        }
#pragma GCC unroll 4
        for (int k = 0; k <= given; ++k) {
#pragma GCC unroll 4
            for (int r = 0; r < left; ++r) {
                values[k][r] = loose_sum(loose_product(values[k][r], supports.ahead(first + r)),
                                         loose_product(values[k][r + 1], supports.after(first + r)));
            }
        }
    }
}

template <int kDegree>
HWY_INLINE void fill_degree(const double *knots, int64_t span, const double *weights, const double *points,
                            int lanes, double *power_span, double *rests) {
    const Four d;
    constexpr double binomials[] = {1, kDegree, kDegree == 3 ? 3 : 1, 1};
    const Supports<kDegree> supports(knots, span, power_span[PowerSpan::middle],
                                     power_span[PowerSpan::scale]);
    for (int c = 0; c < lanes; c += static_cast<int>(hn::Lanes(d))) {
        Number values[kDegree + 1][kDegree + 1];
#pragma GCC unroll 4
        for (int j = 0; j <= kDegree; ++j) {
            values[0][j] = exact_product(hn::Set(d, weights[j]), hn::LoadU(d, points + j * lanes + c));
        }
        blossom<kDegree>(supports, values);
#pragma GCC unroll 4
        for (int k = 0; k <= kDegree; ++k) {
            const V factor = hn::Set(d, binomials[k]);
            const int at = PowerSpan::head_size + k * lanes + c;
            const Number product = exact_product(values[k][0].high, factor);
            const Number value = ordered_sum(product.high, hn::MulAdd(values[k][0].low, factor, product.low));
            hn::StoreU(value.high, d, power_span + at);
            if (rests != nullptr) {
                hn::StoreU(value.low, d, rests + at);
            }
        }
    }
}

void fill_low_power_span(const double *knots, int degree, int64_t span, const double *weights,
                         const double *points, int lanes, double *power_span, double *rests) {
    switch (degree) {
    case 1:
        return fill_degree<1>(knots, span, weights, points, lanes, power_span, rests);
    case 2:
        return fill_degree<2>(knots, span, weights, points, lanes, power_span, rests);
    default:
        return fill_degree<3>(knots, span, weights, points, lanes, power_span, rests);
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::inline basis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::inline basis {

namespace {

NURBS_FORMS(fill_low_power_span);

} // namespace

void low_power_span(const double *knots, int degree, int64_t span, const double *weights,
                    const double *points, int lanes, double *power_span, double *rests) noexcept {
    write_power_span_head(knots[span], knots[span + 1], power_span);
    NURBS_BEST(fill_low_power_span)(knots, degree, span, weights, points, lanes, power_span, rests);
}

void low_basis_power_span(const double *knots, int degree, int64_t span, double *power_span,
                          double *rests) noexcept {
    static constexpr double ones[] = {1, 1, 1, 1};
    static constexpr double functions[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    low_power_span(knots, degree, span, ones, functions, 4, power_span, rests);
}

} // namespace nrb::inline basis
#endif
