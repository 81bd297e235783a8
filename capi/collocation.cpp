// SPDX-License-Identifier: MIT
// Collocation matrices in compressed sparse rows (CSR), and Bezier extraction operators.
#include "batch.h"
#include "guard.h"
#include "sparse.h"
#include "spline_data.h"

#include "base/checked.h"
#include "eval/functions/collocation.h"
#include "refine/knots/extraction.h"

using namespace nrb;
using namespace nrb::capi;

namespace {

eval::Orders checked_orders(const int32_t *orders, int axes) {
    eval::Orders result{};
    int64_t total = 0;
    for (int k = 0; k < axes && orders != nullptr; ++k) {
        if (orders[k] < 0 || orders[k] > NURBS_MAX_ORDER) {
            fail(Status::order, "orders[%d] = %d, expected 0 to %d", k, orders[k], NURBS_MAX_ORDER);
        }
        result[static_cast<size_t>(k)] = orders[k];
        total += orders[k];
    }
    if (total > NURBS_MAX_ORDER) {
        fail(Status::order, "orders add up to %lld, expected at most %d", static_cast<long long>(total),
             NURBS_MAX_ORDER);
    }
    return result;
}

} // namespace

nurbs_status nurbs_collocation(int32_t axes, const int32_t *degrees, const int64_t *counts,
                               const double *knots, int64_t knot_count, const int32_t *orders, int64_t n,
                               const double *params, int64_t param_stride, int64_t param_component_stride,
                               int64_t cap, double *values, int64_t *columns, int64_t *row_pointers,
                               int64_t *entries, uint32_t flags) {
    return guard([&] {
        const Spline::Axes vectors = AxesData(axes, degrees, counts, 0).with_knots(knots, knot_count);
        const eval::AxisRules rules = decode_rules(flags, axes);
        const eval::Orders derivative = checked_orders(orders, axes);
        check_length(n, "n");
        const ConstRecords in = input("params", params, n, axes, param_stride, param_component_stride);
        const int64_t total = checked_product(n, eval::row_length(vectors), "entries");
        const SparseArrays arrays(cap, values, columns, row_pointers, entries);
        const eval::SparseRows rows =
            arrays.check(n, total,
                         {memory("params", params, in.extent()), memory("knots", knots, knot_count),
                          memory("degrees", degrees, axes), memory("counts", counts, axes),
                          memory("orders", orders, axes)});
        eval::check_parameters(vectors, rules, in);
        eval::collocation(vectors, rules, derivative, in, rows);
        arrays.finish(total);
    });
}

nurbs_status nurbs_rational_collocation(const nurbs *g, const int32_t *orders, int64_t n,
                                        const double *params, int64_t param_stride,
                                        int64_t param_component_stride, int64_t cap, double *values,
                                        int64_t *columns, int64_t *row_pointers, int64_t *entries,
                                        uint32_t flags) {
    return guard([&] {
        const SplineBatch batch = spline_batch(g, n, params, param_stride, param_component_stride, flags);
        const Spline &spline = batch.spline;
        const eval::Orders derivative = checked_orders(orders, spline.axes());
        const int64_t total = checked_product(n, eval::row_length(spline.knot_vectors()), "entries");
        const SparseArrays arrays(cap, values, columns, row_pointers, entries);
        const eval::SparseRows rows = arrays.check(
            n, total,
            {memory("params", params, batch.params.extent()), memory("orders", orders, spline.axes())});
        check_values(batch);
        eval::rational_collocation(spline, batch.rules, derivative, batch.params, rows);
        arrays.finish(total);
    });
}

nurbs_status nurbs_bezier_extraction(const nurbs *g, int32_t axis, int64_t cap, double *operators,
                                     int64_t *firsts, double *domains, int64_t *count) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_axis(spline, axis);
        require(count, "count");
        const KnotVector &knots = spline.axis(axis);
        const int64_t spans = knots.spans().size();
        const int64_t filled = checked_cap(cap, spans);
        const int64_t size = int64_t{knots.degree() + 1} * (knots.degree() + 1);
        check_apart({memory("operators", operators, checked_product(filled, size, "operators")),
                     memory("firsts", firsts, filled), memory("domains", domains, 2 * filled),
                     memory("count", count, 1)},
                    {});
        if (filled > 0) {
            refine::bezier_extraction(knots, operators, firsts, domains);
        }
        *count = spans;
    });
}
