// Bases: spans, Bernstein polynomials, B-spline and rational basis functions.
#include "checks.h"
#include "guard.h"

#include "base/checked.h"
#include "basis/bspline.h"
#include "eval/active.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace nrb;
using namespace nrb::capi;

namespace {

KnotVectorPtr checked_knot_vector(int32_t degree, int64_t count, const double *knots, int64_t knot_count) {
    check_degree(degree, -1);
    check_count(degree, count, -1);
    check_knot_total(knot_count, degree, count);
    require(knots, "knots");
    return make_knot_vector(degree, std::vector<double>(knots, knots + knot_count));
}

constexpr int64_t int64_bytes(int64_t n) noexcept {
    return n * static_cast<int64_t>(sizeof(int64_t));
}

void check_spans_overlap(const int64_t *spans, int64_t n, ConstRecords params) {
    const int64_t bytes = params.extent() * static_cast<int64_t>(sizeof(double));
    check_overlap("spans", spans, int64_bytes(n), "params", params.data, bytes);
}

// Where and with which functions a batch on one axis is evaluated.
class BasisBatch {
public:
    BasisBatch(const KnotVector &axis, const AxisRule &rule, int order)
        : axis_(axis), rule_(rule), order_(order) {}

    // The span of t, or -1 for NaN.
    [[nodiscard]] int64_t span(double t) const {
        const double placed = place(t, rule_, axis_.domain());
        return std::isnan(placed) ? -1 : axis_.spans().find(placed, rule_.left);
    }

    void values(double t, int64_t span, double *values, int64_t size) const {
        if (span < 0) {
            std::fill_n(values, size, std::numeric_limits<double>::quiet_NaN());
        } else {
            basis_derivs(axis_.knots().data(), axis_.degree(), span, place(t, rule_, axis_.domain()), order_,
                         values);
        }
    }

private:
    const KnotVector &axis_;
    AxisRule rule_;
    int order_;
};

void store_record(const std::vector<double> &values, Records out, int64_t i) noexcept {
    for (int64_t c = 0; c < out.width; ++c) {
        out(i, c) = values[static_cast<size_t>(c)];
    }
}

} // namespace

nurbs_status nurbs_find_spans(int32_t degree, int64_t count, const double *knots, int64_t knot_count,
                              int64_t n, const double *params, int64_t param_stride, int64_t *spans,
                              uint32_t flags) {
    return guard([&] {
        const KnotVectorPtr axis = checked_knot_vector(degree, count, knots, knot_count);
        const AxisRule rule = decode_rules(flags, 1)[0];
        check_length(n, "n");
        const ConstRecords in = input("params", params, n, param_stride);
        if (n > 0) {
            require(spans, "spans");
        }
        check_spans_overlap(spans, n, in);
        check_overlap("spans", spans, int64_bytes(n), "knots", knots, int64_bytes(knot_count));
        check_axis_parameters(*axis, rule, in, 0);
        const BasisBatch batch(*axis, rule, 0);
        for (int64_t i = 0; i < n; ++i) {
            spans[i] = batch.span(in(i, 0));
        }
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
        for (int64_t i = 0; i < n; ++i) {
            if (!std::isfinite(in(i, 0))) {
                fail(NURBS_ERROR_PARAMETER_NOT_FINITE, "params[%lld] = %s is not finite",
                     static_cast<long long>(i), Number(in(i, 0)).text);
            }
        }
        std::vector<double> record(static_cast<size_t>(width));
        for (int64_t i = 0; i < n; ++i) {
            bernstein_derivs(degree, in(i, 0), order, record.data());
            store_record(record, out, i);
        }
    });
}

nurbs_status nurbs_basis(int32_t degree, int64_t count, const double *knots, int64_t knot_count,
                         int32_t order, int64_t n, const double *params, int64_t param_stride, int64_t *spans,
                         double *values, int64_t value_stride, int64_t value_component_stride,
                         uint32_t flags) {
    return guard([&] {
        const KnotVectorPtr axis = checked_knot_vector(degree, count, knots, knot_count);
        const AxisRule rule = decode_rules(flags, 1)[0];
        check_order(order);
        check_length(n, "n");
        const ConstRecords in = input("params", params, n, param_stride);
        const int64_t width = int64_t{order + 1} * (degree + 1);
        const Records out = output("values", values, n, width, value_stride, value_component_stride);
        check_overlap("values", out, "params", in);
        check_overlap("values", out, "knots", input("knots", knots, knot_count, 0));
        if (spans != nullptr) {
            check_spans_overlap(spans, n, in);
            check_overlap("spans", spans, int64_bytes(n), "knots", knots, int64_bytes(knot_count));
        }
        check_axis_parameters(*axis, rule, in, 0);
        const BasisBatch batch(*axis, rule, order);
        std::vector<double> record(static_cast<size_t>(width));
        for (int64_t i = 0; i < n; ++i) {
            const int64_t span = batch.span(in(i, 0));
            batch.values(in(i, 0), span, record.data(), width);
            store_record(record, out, i);
            if (spans != nullptr) {
                spans[i] = span;
            }
        }
    });
}

nurbs_status nurbs_rational_basis(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                                  int64_t param_component_stride, int64_t *spans, double *values,
                                  int64_t value_stride, int64_t value_component_stride, uint32_t flags) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        const AxisRules rules = decode_rules(flags, spline.axes());
        check_length(n, "n");
        const ConstRecords in =
            input("params", params, n, spline.axes(), param_stride, param_component_stride);
        int64_t width = 1;
        for (int k = 0; k < spline.axes(); ++k) {
            width *= spline.axis(k).degree() + 1;
        }
        const Records out = output("values", values, n, width, value_stride, value_component_stride);
        check_overlap("values", out, "params", in);
        if (spans != nullptr) {
            check_spans_overlap(spans, n * spline.axes(), in);
        }
        check_parameters(spline, rules, in);
        rational_basis(spline, rules, in, spans, out);
    });
}
