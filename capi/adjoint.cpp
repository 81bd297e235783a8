// SPDX-License-Identifier: MIT
// Adjoints (reverse-mode gradients) of evaluation, of closest points and of the length of a curve.
#include "batch.h"
#include "guard.h"
#include "outputs.h"
#include "part.h"

#include "base/checked.h"
#include "base/tolerance.h"
#include "closest/closest_adjoint.h"
#include "eval/adjoint/adjoint.h"
#include "eval/adjoint/knot_adjoint.h"
#include "eval/kernels/slots.h"
#include "measure/length/length_adjoint.h"

#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace {

// A view of an optional output: without records if the pointer is NULL.
Records optional_output(const char *name, double *data, int64_t count, int64_t width, int64_t stride,
                        int64_t component_stride) {
    return data == nullptr ? Records{} : output(name, data, count, width, stride, component_stride);
}

void check_highest(int32_t order, const double *grad_params) {
    check_order(order);
    if (order == NURBS_MAX_ORDER && grad_params != nullptr) {
        fail(Status::order, "order = %d, expected at most %d with grad_params", order, NURBS_MAX_ORDER - 1);
    }
}

void check_gradients(const eval::Gradients &out, ConstRecords params, ConstRecords cotangents) {
    check_overlap("grad_points", out.points, "grad_weights", read_only(out.weights));
    check_overlap("grad_points", out.points, "grad_params", read_only(out.params));
    check_overlap("grad_weights", out.weights, "grad_params", read_only(out.params));
    for (const auto &[name, view] :
         {std::pair("grad_points", out.points), {"grad_weights", out.weights}, {"grad_params", out.params}}) {
        check_overlap(name, view, "params", params);
        check_overlap(name, view, "cotangents", cotangents);
    }
}

// A view of optional cotangents: without records, which stands for zeros, if the pointer is NULL.
ConstRecords optional_input(const char *name, const double *data, int64_t count, int64_t width) {
    return data == nullptr ? ConstRecords{} : input(name, data, count, width, 0, 0);
}

// The parameters of feet, which have to lie in the domain. The only flags are NURBS_LEFT, for the side at a
// knot, and NURBS_NAN_POINTS, with which a foot that is not finite or not in the domain gives NaN instead of
// an error.
SplineBatch foot_batch(const nurbs *g, int64_t n, const double *params, uint32_t flags) {
    const uint32_t sides = NURBS_ON_ALL_AXES(spline_of(g).axes(), NURBS_LEFT);
    if ((flags & ~(sides | NURBS_NAN_POINTS)) != 0) {
        fail(Status::flags, "flags = 0x%08x, expected NURBS_LEFT on axes and NURBS_NAN_POINTS only", flags);
    }
    const bool nan = (flags & NURBS_NAN_POINTS) != 0;
    return spline_batch(g, n, params, 0, 0,
                        (flags & sides) | (nan ? NURBS_ON_ALL_AXES(spline_of(g).axes(), NURBS_NAN) : 0));
}

void check_queries(const ConstRecords &points) {
    for (int64_t i = 0; i < points.count; ++i) {
        for (int64_t c = 0; c < points.width; ++c) {
            if (!std::isfinite(points(i, c))) {
                fail(Status::point_not_finite, "points[%lld][%lld] = %s, expected a number",
                     static_cast<long long>(i), static_cast<long long>(c), Number(points(i, c)).text);
            }
        }
    }
}

// give() overwrites outputs or adds to them (NURBS_ACCUMULATE). check_multiples() first refuses products that
// are not finite, so that nothing is written if one overflows.
void check_multiples(const std::vector<double> &values, double factor, const char *name) {
    for (const double value : values) {
        if (!std::isfinite(factor * value)) {
            fail(Status::not_representable, "%s: cotangent = %s times %s is not finite", name,
                 Number(factor).text, Number(value).text);
        }
    }
}

void give(const Records &out, const std::vector<double> &values, double factor, bool accumulate) noexcept {
    for (int64_t i = 0; i < out.count && out.data != nullptr; ++i) {
        for (int64_t c = 0; c < out.width; ++c) {
            const double value = factor * values[static_cast<size_t>(i * out.width + c)];
            out(i, c) = accumulate ? out(i, c) + value : value;
        }
    }
}

} // namespace

nurbs_status nurbs_eval_adjoint(const nurbs *g, int32_t order, int64_t n, const double *params,
                                int64_t param_stride, int64_t param_component_stride,
                                const double *cotangents, int64_t cotangent_stride,
                                int64_t cotangent_component_stride, double *grad_points,
                                int64_t grad_point_stride, int64_t grad_point_component_stride,
                                double *grad_weights, int64_t grad_weight_stride, double *grad_params,
                                int64_t grad_param_stride, int64_t grad_param_component_stride,
                                uint32_t flags) {
    return guard([&] {
        check_highest(order, grad_params);
        const SplineBatch batch = spline_batch(g, n, params, param_stride, param_component_stride,
                                               flags & ~uint32_t{NURBS_ACCUMULATE});
        const Spline &spline = batch.spline;
        const int64_t width =
            checked_product(eval::slot_count(spline.axes(), order), spline.dim(), "cotangents");
        const ConstRecords in =
            input("cotangents", cotangents, n, width, cotangent_stride, cotangent_component_stride);
        const int64_t count = spline.point_count();
        const eval::Gradients out{
            optional_output("grad_points", grad_points, count, spline.dim(), grad_point_stride,
                            grad_point_component_stride),
            optional_output("grad_weights", grad_weights, count, 1, grad_weight_stride, 0),
            optional_output("grad_params", grad_params, n, spline.axes(), grad_param_stride,
                            grad_param_component_stride)};
        check_gradients(out, batch.params, in);
        check_values(batch);
        eval::evaluate_adjoint(spline, batch.rules, order, batch.params, in, (flags & NURBS_ACCUMULATE) != 0,
                               out);
    });
}

nurbs_status nurbs_eval_adjoint_knots(const nurbs *g, int32_t axis, int32_t order, int64_t n,
                                      const double *params, int64_t param_stride,
                                      int64_t param_component_stride, const double *cotangents,
                                      int64_t cotangent_stride, int64_t cotangent_component_stride,
                                      double *grad_knots, uint32_t flags) {
    return guard([&] {
        check_axis(spline_of(g), axis);
        check_order(order);
        const SplineBatch batch = spline_batch(g, n, params, param_stride, param_component_stride,
                                               flags & ~uint32_t{NURBS_ACCUMULATE});
        const int64_t width =
            checked_product(eval::slot_count(batch.spline.axes(), order), batch.spline.dim(), "cotangents");
        const ConstRecords in =
            input("cotangents", cotangents, n, width, cotangent_stride, cotangent_component_stride);
        const Records out =
            output("grad_knots", grad_knots, std::ssize(batch.spline.axis(axis).knots()), 1, 0, 0);
        check_overlap("grad_knots", out, "params", batch.params);
        check_overlap("grad_knots", out, "cotangents", in);
        check_values(batch);
        eval::evaluate_knot_adjoint(batch.spline, axis, batch.rules, order, batch.params, in,
                                    (flags & NURBS_ACCUMULATE) != 0, out);
    });
}

nurbs_status nurbs_closest_adjoint(const nurbs *g, int64_t n, const double *points, const double *params,
                                   const double *param_cotangents, const double *foot_cotangents,
                                   const double *distance_cotangents, double *grad_points,
                                   double *grad_weights, double *grad_queries, int32_t *status,
                                   uint32_t flags) {
    return guard([&] {
        const SplineBatch batch = foot_batch(g, n, params, flags);
        const Spline &spline = batch.spline;
        const closest::FootCotangents in{
            input("points", points, n, spline.dim(), 0, 0), batch.params,
            optional_input("param_cotangents", param_cotangents, n, spline.axes()),
            optional_input("foot_cotangents", foot_cotangents, n, spline.dim()),
            optional_input("distance_cotangents", distance_cotangents, n, 1)};
        const int64_t count = spline.point_count();
        const closest::FootGradients out{
            optional_output("grad_points", grad_points, count, spline.dim(), 0, 0),
            optional_output("grad_weights", grad_weights, count, 1, 0, 0),
            optional_output("grad_queries", grad_queries, n, spline.dim(), 0, 0), status};
        check_apart({memory("grad_points", grad_points, count * spline.dim()),
                     memory("grad_weights", grad_weights, count),
                     memory("grad_queries", grad_queries, n * spline.dim()), memory("status", status, n)},
                    {memory("points", points, n * spline.dim()), memory("params", params, n * spline.axes()),
                     memory("param_cotangents", param_cotangents, n * spline.axes()),
                     memory("foot_cotangents", foot_cotangents, n * spline.dim()),
                     memory("distance_cotangents", distance_cotangents, n)});
        if ((flags & NURBS_NAN_POINTS) == 0) {
            check_queries(in.queries);
        }
        check_values(batch);
        closest::closest_adjoint(spline, batch.rules, in, out);
    });
}

nurbs_status nurbs_length_adjoint(const nurbs *g, const double *range, double relative_tolerance,
                                  double cotangent, double *grad_points, int64_t grad_point_stride,
                                  int64_t grad_point_component_stride, double *grad_weights,
                                  int64_t grad_weight_stride, double *error, uint32_t flags) {
    return guard([&] {
        const Spline &curve = curve_of(g);
        check_tolerance(relative_tolerance, "relative_tolerance");
        if ((flags & ~uint32_t{NURBS_ACCUMULATE}) != 0) {
            fail(Status::flags, "flags = 0x%08x, expected NURBS_ACCUMULATE or 0", flags);
        }
        const int64_t count = curve.point_count();
        const Records points = optional_output("grad_points", grad_points, count, curve.dim(),
                                               grad_point_stride, grad_point_component_stride);
        const Records weights =
            optional_output("grad_weights", grad_weights, count, 1, grad_weight_stride, 0);
        check_overlap("grad_points", points, "grad_weights", read_only(weights));
        check_apart({memory("error", error, 1), memory("grad_points", grad_points, points.extent())},
                    {memory("range", range, 2)});
        check_apart({memory("error", error, 1), memory("grad_weights", grad_weights, weights.extent())},
                    {memory("range", range, 2)});
        const measure::LengthGradient found = measure::length_gradient(
            curve, checked_part(curve, range)[0], relative_tolerance, grad_weights != nullptr);
        if (grad_points != nullptr) {
            check_multiples(found.points, cotangent, "grad_points");
        }
        check_multiples(found.weights, cotangent, "grad_weights");
        give(points, found.points, cotangent, flags != 0);
        give(weights, found.weights, cotangent, flags != 0);
        put(error, found.error);
    });
}
