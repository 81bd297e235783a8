// SPDX-License-Identifier: MIT
// Evaluation of points and derivatives, in batches and on grids; isoparametric curves and surfaces.
#include "batch.h"
#include "guard.h"

#include "base/checked.h"
#include "eval/evaluate.h"
#include "eval/kernels/single_kernel.h"
#include "eval/kernels/slots.h"
#include "eval/single_precision.h"
#include "refine/parts/iso.h"

using namespace nrb;
using namespace nrb::capi;

namespace {

// Points and derivatives up to `order`; with order 0, points only. `name` is the name of the output.
void evaluate(const SplineBatch &batch, int32_t order, double *values, int64_t stride,
              int64_t component_stride, const char *name) {
    const Spline &spline = batch.spline;
    const int64_t width = checked_product(eval::slot_count(spline.axes(), order), spline.dim(), name);
    const Records out = output(name, values, batch.params.count, width, stride, component_stride);
    check_overlap(name, out, "params", batch.params);
    check_values(batch);
    eval::evaluate_points(spline, batch.rules, order, batch.params, out);
}

void evaluate(const SplineBatch &batch, float *points, int64_t stride, int64_t component_stride) {
    const int dim = batch.spline.dim();
    const FloatRecords out = output("points", points, batch.params.count, dim, stride, component_stride);
    check_overlap("points", out, "params", batch.params);
    check_values(batch);
    eval::evaluate_points(batch.spline, batch.rules, batch.params, out);
}

void evaluate_on_grid(const nurbs *g, int32_t order, const int64_t *counts, const double *params,
                      double *values, int64_t stride, int64_t component_stride, const char *name,
                      uint32_t flags) {
    const Spline &spline = spline_of(g);
    const eval::AxisRules rules = decode_rules(flags, spline.axes());
    const Grid grid = grid_of(spline, counts, params);
    const int64_t width = checked_product(eval::slot_count(spline.axes(), order), spline.dim(), name);
    const Records out = output(name, values, grid.point_count, width, stride, component_stride);
    check_overlap(name, out, grid);
    check_values(spline, rules, grid);
    eval::evaluate_grid(spline, rules, order, grid.params, out);
}

void evaluate_on_grid(const nurbs *g, const int64_t *counts, const double *params, float *points,
                      int64_t stride, int64_t component_stride, uint32_t flags) {
    const Spline &spline = spline_of(g);
    const eval::AxisRules rules = decode_rules(flags, spline.axes());
    const Grid grid = grid_of(spline, counts, params);
    const FloatRecords out =
        output("points", points, grid.point_count, spline.dim(), stride, component_stride);
    check_overlap("points", out, grid);
    check_values(spline, rules, grid);
    eval::evaluate_grid(spline, rules, grid.params, out);
}

// The fast path for one point of a spline that has its tables, as in most calls of most programs. False, and
// nothing is written, where arguments need further checks, or an error may have to be reported, or the point
// is not one for the tables.
bool evaluated_single(const nurbs *g, const double *params, int64_t param_stride,
                      int64_t param_component_stride, double *points, int64_t point_stride,
                      int64_t point_component_stride) noexcept {
    const eval::SingleTables *tables = g == nullptr ? nullptr : eval::single_tables(*g->spline);
    return tables != nullptr && params != nullptr && points != nullptr &&
           in_a_row(tables->axis_count, param_stride, param_component_stride) &&
           in_a_row(tables->dim, point_stride, point_component_stride) &&
           apart(memory("points", points, tables->dim), memory("params", params, tables->axis_count)) &&
           eval::evaluate_single(*tables, params, points);
}

} // namespace

nurbs_status nurbs_eval(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                        int64_t param_component_stride, double *points, int64_t point_stride,
                        int64_t point_component_stride, uint32_t flags) {
    if (n == 1 && flags == 0 &&
        evaluated_single(g, params, param_stride, param_component_stride, points, point_stride,
                         point_component_stride)) {
        return NURBS_OK;
    }
    return guard([&] {
        evaluate(spline_batch(g, n, params, param_stride, param_component_stride, flags), 0, points,
                 point_stride, point_component_stride, "points");
    });
}

nurbs_status nurbs_derivative_slots(int32_t axes, int32_t order, int64_t *slots) {
    return guard([&] {
        check_axes(axes);
        check_order(order);
        require(slots, "slots");
        *slots = eval::slot_count(axes, order);
    });
}

nurbs_status nurbs_eval_derivs(const nurbs *g, int32_t order, int64_t n, const double *params,
                               int64_t param_stride, int64_t param_component_stride, double *derivs,
                               int64_t deriv_stride, int64_t deriv_component_stride, uint32_t flags) {
    return guard([&] {
        check_order(order);
        evaluate(spline_batch(g, n, params, param_stride, param_component_stride, flags), order, derivs,
                 deriv_stride, deriv_component_stride, "derivs");
    });
}

nurbs_status nurbs_eval_grid(const nurbs *g, const int64_t *counts, const double *params, double *points,
                             int64_t point_stride, int64_t point_component_stride, uint32_t flags) {
    return guard([&] {
        evaluate_on_grid(g, 0, counts, params, points, point_stride, point_component_stride, "points", flags);
    });
}

nurbs_status nurbs_eval_grid_derivs(const nurbs *g, int32_t order, const int64_t *counts,
                                    const double *params, double *derivs, int64_t deriv_stride,
                                    int64_t deriv_component_stride, uint32_t flags) {
    return guard([&] {
        check_order(order);
        evaluate_on_grid(g, order, counts, params, derivs, deriv_stride, deriv_component_stride, "derivs",
                         flags);
    });
}

nurbs_status nurbs_eval_f32(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                            int64_t param_component_stride, float *points, int64_t point_stride,
                            int64_t point_component_stride, uint32_t flags) {
    return guard([&] {
        evaluate(spline_batch(g, n, params, param_stride, param_component_stride, flags), points,
                 point_stride, point_component_stride);
    });
}

nurbs_status nurbs_eval_grid_f32(const nurbs *g, const int64_t *counts, const double *params, float *points,
                                 int64_t point_stride, int64_t point_component_stride, uint32_t flags) {
    return guard(
        [&] { evaluate_on_grid(g, counts, params, points, point_stride, point_component_stride, flags); });
}

nurbs_status nurbs_iso(const nurbs *g, int32_t axis, double param, uint32_t flags, nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        check_axis(spline, axis);
        give(refine::iso(spline, axis, param, decode_rules(flags, 1)[0]), out);
    });
}
