// SPDX-License-Identifier: MIT
// Basis functions of one axis at one parameter. Included once for every instruction set: see base/simd.h.
#if defined(NURBS_EVAL_KERNELS_AXIS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_EVAL_KERNELS_AXIS_INL_H_
#undef NURBS_EVAL_KERNELS_AXIS_INL_H_
#else
#define NURBS_EVAL_KERNELS_AXIS_INL_H_
#endif

#include "eval/kernels/axis_source.h"
#include "eval/kernels/horner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

// The functions and their derivatives by the recurrence, whose rows have no padding; they are copied to rows
// of `lanes` doubles.
//
// Error bound: a point made from these functions, here and in curve_kernel.cpp, is within (7 p + 2) eps hull
// of the exact one for weights >= 0. Count roundings of eps / 2 each. Errors of the numerator are relative to
// the sum of N w |x|, which is at most w(t) hull; errors of the denominator are relative to w(t) itself,
// since no term of it is negative.
// - Functions: 4 at degree 1, where divide_in_ratio() multiplies by 1 and nothing is added, and 6 for each
//   further degree: 6 p - 2.
// - Products w x, in the numerator only: 1.
// - Contraction: for each term a product and at most p sums, or fewer roundings where they are fused: p + 1.
// - 1 / w(t), and the product with it: 2.
// The numerator has 7 p roundings, the denominator 7 p - 1, the division 2: together 14 p + 1. At degree 0,
// where the functions are exactly 1, there are 3. The bound allows 14 p + 4; the difference leaves room for
// products of errors. Each further axis adds only its functions and its contraction.
static HWY_NOINLINE void recurrence_values(const AxisSource &source, int64_t span, int order, double t,
                                           double *values) {
    const int functions = source.degree + 1;
    basis_derivs(source.axis->knots().data(), source.degree, span, t, order, source.work);
    for (int k = 0; k <= order; ++k) {
        const double *row = source.work + static_cast<int64_t>(k) * functions;
        std::copy_n(row, functions, values + static_cast<int64_t>(k) * source.lanes);
    }
}

// The functions at any parameter, also outside the domain, at a knot, or without tables. values: as for
// axis_values().
static HWY_NOINLINE AxisPoint special_values(const AxisSource &source, int order, double param,
                                             double *values) {
    const double t = place(param, source.rule, source.domain);
    if (t != t) {
        return {-1, -1};
    }
    const int64_t span = source.spans != nullptr ? source.spans->find(t, source.rule.left)
                                                 : source.axis->find_span(t, source.rule.left);
    const double *knots = source.axis->knots().data();
    if (!source.has_power_spans || !source.axis->has_power_span(span)) {
        recurrence_values(source, span, order, t, values);
    } else if (source.power_spans != nullptr && source.spans != nullptr) { // power spans imply spans
        const double *power_span = (*source.power_spans)[source.spans->number(t, source.rule.left)];
        horner(order, power_span, source.degree, source.lanes, t, values);
    } else {
        double *const power_spans[1] = {source.work};
        basis_power_spans(knots, source.degree, &span, 1, power_spans, nullptr);
        horner(order, source.work, source.degree, source.lanes, t, values);
    }
    return {span - source.degree, sole_function(knots, source.degree, span, t)};
}

// The functions at one parameter and their derivatives up to `order`. values: [order + 1][lanes]. The result
// has first < 0 if the parameter gives NaN.
HWY_INLINE AxisPoint axis_values(const AxisSource &source, int order, double t, double *values) {
    if (source.power_spans != nullptr && t > source.domain.lower && t < source.domain.upper) {
        const int64_t number = source.spans->number(t, false);
        const double *power_span = (*source.power_spans)[number];
        if (t > power_span[PowerSpan::lower]) {
            horner(order, power_span, source.degree, source.lanes, t, values);
            return {source.spans->indices()[static_cast<size_t>(number)] - source.degree, -1};
        }
    }
    return special_values(source, order, t, values);
}

// Finds the power spans and the first layers of parameters that all lie strictly inside the domain and
// strictly inside a span with a power span. Returns false if some parameter does not; the results are then
// incomplete. It is separate from its caller, so that everything it needs stays in registers.
static HWY_NOINLINE HWY_MAYBE_UNUSED bool locate(const AxisSource &source, const double *HWY_RESTRICT params,
                                                 int64_t stride, int64_t count,
                                                 AxisPoint *HWY_RESTRICT points,
                                                 const double **HWY_RESTRICT found) {
    const SpanTable::Finder find = source.spans->finder();
    const int64_t *spans = source.spans->indices().data();
    const double *power_spans = (*source.power_spans)[0];
    const int64_t power_span_size = source.power_spans->size();
    const Interval domain = source.domain;
    const int degree = source.degree;
    bool ordinary = true;
    for (int64_t i = 0; i < count; ++i) {
        const double t = params[i * stride];
        if (HWY_UNLIKELY(!(t > domain.lower && t < domain.upper))) {
            return false;
        }
        const int64_t number = find.number_inside(t);
        const double *power_span = power_spans + number * power_span_size;
        points[i] = {spans[number] - degree, -1};
        found[i] = power_span;
        ordinary &= t > power_span[PowerSpan::lower];
    }
    return ordinary;
}

// Whether all parameters lie strictly between two bounds, which NaN does not.
HWY_INLINE bool between(const double *HWY_RESTRICT params, int64_t stride, int64_t count, double lower,
                        double upper) {
    const Vec8 d;
    auto all = hn::Eq(hn::Zero(d), hn::Zero(d));
    int64_t i = 0;
    for (; stride == 1 && i + vec8_lanes <= count; i += vec8_lanes) {
        const auto t = hn::LoadU(d, params + i);
        all = hn::And(all, hn::And(hn::Lt(hn::Set(d, lower), t), hn::Lt(t, hn::Set(d, upper))));
    }
    bool rest = hn::AllTrue(d, all);
    for (; i < count; ++i) {
        rest &= params[i * stride] > lower && params[i * stride] < upper;
    }
    return rest;
}

// The one power span in whose interior all `count` parameters lie, and its first layer; null if there is
// none. The parameters between the first and the last one are examined only if these two share a span.
static HWY_NOINLINE HWY_MAYBE_UNUSED const double *locate_together(const AxisSource &source,
                                                                   const double *HWY_RESTRICT params,
                                                                   int64_t stride, int64_t count,
                                                                   int64_t &first_layer) {
    const double start = params[0], end = params[(count - 1) * stride];
    if (!(start > source.domain.lower && start < source.domain.upper)) {
        return nullptr;
    }
    const int64_t number = source.spans->finder().number_inside(start);
    const double *power_span = (*source.power_spans)[number];
    const double lower = power_span[PowerSpan::lower], upper = power_span[PowerSpan::upper];
    if (!(end > lower && end < upper && between(params, stride, count, lower, upper))) {
        return nullptr;
    }
    first_layer = source.spans->indices()[static_cast<size_t>(number)] - source.degree;
    return power_span;
}

// axis_values() at `count` parameters, which are `stride` apart, in two passes: first all searches, then all
// polynomials. The functions of parameter i go to values[i * (order + 1) * lanes]. Returns whether some
// parameter is special: it gives NaN, or one of its functions is 1 and all others are 0. kOrders: order + 1,
// or most_orders for any order; kDegree: the degree, or -1 for any.
template <int kOrders, int kDegree>
HWY_INLINE bool axis_block(const AxisSource &source, int order, const double *params, int64_t stride,
                           int64_t count, AxisPoint *points, double *values) {
    const int64_t size = source.values_size(order);
    const int lanes = kDegree == 3 ? 4 : source.lanes;
    int64_t first = 0;
    const double *const power_span =
        source.power_spans != nullptr ? locate_together(source, params, stride, count, first) : nullptr;
    if (power_span != nullptr) {
        for (int64_t i = 0; i < count; ++i) {
            points[i] = {first, -1};
            horner_record<kOrders, kDegree>(order, power_span, source.degree, lanes, params[i * stride],
                                            values + i * size);
        }
        return false;
    }
    const double *found[axis_block_size];
    if (source.power_spans == nullptr || !locate(source, params, stride, count, points, found)) {
        bool special = false;
        for (int64_t i = 0; i < count; ++i) {
            points[i] = axis_values(source, order, params[i * stride], values + i * size);
            special |= points[i].sole >= 0 || !points[i].valid();
        }
        return special;
    }
    for (int64_t i = 0; i < count; ++i) {
        horner_record<kOrders, kDegree>(order, found[i], source.degree, lanes, params[i * stride],
                                        values + i * size);
    }
    return false;
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#endif
