// SPDX-License-Identifier: MIT
// Fits to point clouds: splines that are closest to points without parameters.
#include "fit/cloud/cloud_start.h"
#include "fit/cloud/fit_cloud.h"
#include "guard.h"
#include "outputs.h"
#include "spline_data.h"
#include "structs.h"
#include "watched.h"

#include "base/tolerance.h"

using namespace nrb;
using namespace nrb::capi;

namespace {

void check_room(int axes, int dim) {
    if (dim <= axes) {
        fail(Status::dimension, "dim = %d, expected more than %d, the number of axes", dim, axes);
    }
}

fit::CloudWishes checked_cloud_wishes(const nurbs_cloud_options *options) {
    fit::CloudWishes wishes;
    if (options == nullptr) {
        return wishes;
    }
    const nurbs_cloud_options &given = checked_struct("options", options);
    if (given.penalty_order < 1) {
        fail(Status::order, "options: penalty_order = %d, expected at least 1", given.penalty_order);
    }
    check_at_least(given.rounds, 1, "options: rounds");
    check_factor(given.lambda, "options: lambda");
    check_factor(given.first_lambda, "options: first_lambda");
    check_tolerance(given.tolerance, "options: tolerance");
    return {given.penalty_order, given.lambda, given.first_lambda, given.tolerance, given.rounds};
}

void tell(const fit::CloudFit &made, nurbs_cloud_report *report) {
    if (report == nullptr) {
        return;
    }
    report->data_count = made.data_count;
    report->weight = made.weight;
    report->squares = made.squares;
    report->rms = made.rms;
    report->largest = made.largest;
    report->largest_index = made.largest_index;
    report->lambda = made.lambda;
    report->noise = made.noise;
    report->boundary = made.on_boundary;
    report->uncertified = made.uncertified;
    report->rounds = made.rounds;
    report->bits = made.converged ? 0 : NURBS_CLOUD_NOT_CONVERGED;
}

} // namespace

nurbs_status nurbs_cloud_start(int32_t axes, const int32_t *degrees, const int64_t *counts,
                               const double *knots, int64_t knot_count, int64_t n, int32_t dim,
                               const double *points, int64_t point_stride, int64_t point_component_stride,
                               uint32_t flags, nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline::Axes over = AxesData(axes, degrees, counts, flags).with_knots(knots, knot_count);
        check_at_least(n, 1, "n");
        check_dimension(dim);
        check_room(axes, dim);
        const ConstRecords given = input("points", points, n, dim, point_stride, point_component_stride);
        give(fit::cloud_start(fit::cloud_of(given, {}), over), out);
    });
}

nurbs_status nurbs_cloud_options_init(nurbs_cloud_options *options, int64_t struct_size) {
    return guard([&] {
        clear_struct("options", options, struct_size);
        const fit::CloudWishes usual;
        options->penalty_order = usual.penalty_order;
        options->rounds = usual.rounds;
        options->lambda = usual.lambda;
        options->first_lambda = usual.first_lambda;
        options->tolerance = usual.tolerance;
    });
}

nurbs_status nurbs_fit_cloud(const nurbs *g, int64_t n, const double *points, int64_t point_stride,
                             int64_t point_component_stride, const double *weights, int64_t weight_stride,
                             const nurbs_cloud_options *options, nurbs_cloud_report *report, nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &start = spline_of(g);
        if (start.rational()) {
            fail(Status::rational, "g is rational, expected a polynomial spline");
        }
        check_room(start.axes(), start.dim());
        check_at_least(n, 1, "n");
        const ConstRecords given =
            input("points", points, n, start.dim(), point_stride, point_component_stride);
        const ConstRecords weighed =
            weights == nullptr ? ConstRecords{} : input("weights", weights, n, weight_stride);
        const fit::CloudWishes wishes = checked_cloud_wishes(options);
        if (report != nullptr) {
            check_struct_size("report", report->struct_size, sizeof(nurbs_cloud_report));
        }
        const fit::CloudFit made = fit::fit_cloud(g->spline, given, weighed, wishes);
        give(made.spline, out);
        tell(made, report);
    });
}

nurbs_status nurbs_fit_cloud_with(const nurbs *g, int64_t n, const double *points, int64_t point_stride,
                                  int64_t point_component_stride, const double *weights,
                                  int64_t weight_stride, const nurbs_cloud_options *options,
                                  nurbs_cloud_report *report, const nurbs_call_options *call, nurbs **out) {
    return watched(call, out, [&] {
        return nurbs_fit_cloud(g, n, points, point_stride, point_component_stride, weights, weight_stride,
                               options, report, out);
    });
}
