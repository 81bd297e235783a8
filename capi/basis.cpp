// SPDX-License-Identifier: MIT
// Knot spans, Bernstein polynomials, B-spline and rational basis functions, and gradients of the latter in
// space.
#include "batch.h"
#include "guard.h"

#include "eval/active.h"
#include "eval/functions/basis_batch.h"
#include "eval/functions/basis_gradients.h"

using namespace nrb;
using namespace nrb::capi;

namespace {

constexpr int64_t bytes_of(int64_t n) noexcept {
    return n * static_cast<int64_t>(sizeof(double));
}

// Throws NURBS_ERROR_OVERLAP if the n spans overlap the other array. Spans are 64-bit integers, as wide as
// the doubles of all other arrays, so that bytes_of() measures both.
void check_spans_overlap(const int64_t *spans, int64_t n, const char *name, ConstRecords other) {
    static_assert(sizeof(int64_t) == sizeof(double));
    check_overlap("spans", spans, bytes_of(n), name, other.data, bytes_of(other.extent()));
}

int64_t active_points(const Spline &spline) noexcept {
    int64_t points = 1;
    for (int k = 0; k < spline.axes(); ++k) {
        points *= spline.axis(k).degree() + 1;
    }
    return points;
}

} // namespace

nurbs_status nurbs_find_spans(int32_t degree, int64_t count, const double *knots, int64_t knot_count,
                              int64_t n, const double *params, int64_t param_stride, int64_t *spans,
                              uint32_t flags) {
    return guard([&] {
        const KnotBatch batch = knot_batch(degree, count, knots, knot_count, n, params, param_stride, flags);
        if (n > 0) {
            require(spans, "spans");
        }
        check_spans_overlap(spans, n, "params", batch.params);
        check_spans_overlap(spans, n, "knots", input("knots", knots, knot_count, 0));
        check_values(batch);
        eval::find_spans(*batch.axis, batch.rule, batch.params, spans);
    });
}

nurbs_status nurbs_bernstein(int32_t degree, int32_t order, int64_t n, const double *params,
                             int64_t param_stride, double *values, int64_t value_stride,
                             int64_t value_component_stride) {
    return guard([&] {
        check_degree(degree, -1);
        check_order(order);
        check_length(n, "n");
        const ConstRecords in = input("params", params, n, param_stride);
        const int64_t width = int64_t{order + 1} * (degree + 1);
        const Records out = output("values", values, n, width, value_stride, value_component_stride);
        check_overlap("values", out, "params", in);
        eval::bernstein_polynomials(degree, order, in, out);
    });
}

nurbs_status nurbs_basis(int32_t degree, int64_t count, const double *knots, int64_t knot_count,
                         int32_t order, int64_t n, const double *params, int64_t param_stride, int64_t *spans,
                         double *values, int64_t value_stride, int64_t value_component_stride,
                         uint32_t flags) {
    return guard([&] {
        const KnotBatch batch = knot_batch(degree, count, knots, knot_count, n, params, param_stride, flags);
        check_order(order);
        const int64_t width = int64_t{order + 1} * (degree + 1);
        const Records out = output("values", values, n, width, value_stride, value_component_stride);
        const ConstRecords knot_view = input("knots", knots, knot_count, 0);
        check_overlap("values", out, "params", batch.params);
        check_overlap("values", out, "knots", knot_view);
        if (spans != nullptr) {
            check_spans_overlap(spans, n, "params", batch.params);
            check_spans_overlap(spans, n, "knots", knot_view);
            check_spans_overlap(spans, n, "values", read_only(out));
        }
        check_values(batch);
        eval::basis_functions(*batch.axis, batch.rule, order, batch.params, spans, out);
    });
}

nurbs_status nurbs_rational_basis(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                                  int64_t param_component_stride, int64_t *spans, double *values,
                                  int64_t value_stride, int64_t value_component_stride, uint32_t flags) {
    return guard([&] {
        const SplineBatch batch = spline_batch(g, n, params, param_stride, param_component_stride, flags);
        const int64_t width = active_points(batch.spline);
        const Records out = output("values", values, n, width, value_stride, value_component_stride);
        check_overlap("values", out, "params", batch.params);
        if (spans != nullptr) {
            check_spans_overlap(spans, n * batch.spline.axes(), "params", batch.params);
            check_spans_overlap(spans, n * batch.spline.axes(), "values", read_only(out));
        }
        check_values(batch);
        eval::rational_basis(batch.spline, batch.rules, batch.params, spans, out);
    });
}

nurbs_status nurbs_basis_gradients(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                                   int64_t param_component_stride, int64_t *spans, double *gradients,
                                   int64_t gradient_stride, int64_t gradient_component_stride,
                                   uint32_t flags) {
    return guard([&] {
        const SplineBatch batch = spline_batch(g, n, params, param_stride, param_component_stride, flags);
        const Spline &spline = batch.spline;
        if (spline.axes() > spline.dim()) {
            fail(Status::dimension, "g has %d axes and dimension %d, expected at least as many coordinates",
                 spline.axes(), spline.dim());
        }
        const int64_t width = active_points(spline) * spline.dim();
        const Records out =
            output("gradients", gradients, n, width, gradient_stride, gradient_component_stride);
        check_overlap("gradients", out, "params", batch.params);
        if (spans != nullptr) {
            check_spans_overlap(spans, n * spline.axes(), "params", batch.params);
            check_spans_overlap(spans, n * spline.axes(), "gradients", read_only(out));
        }
        check_values(batch);
        eval::basis_gradients(spline, batch.rules, batch.params, spans, out);
    });
}
