// SPDX-License-Identifier: MIT
// Evaluation transposed.
#include "batch.h"
#include "guard.h"

#include "base/checked.h"
#include "eval/adjoint/adjoint.h"
#include "eval/kernels/slots.h"

using namespace nrb;
using namespace nrb::capi;

namespace {

// An output that is not wanted has no records.
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
