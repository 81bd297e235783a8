// SPDX-License-Identifier: MIT
// Editing of weights and control points, and inverse knot insertion.
#include "batch.h"
#include "guard.h"
#include "outputs.h"

#include "base/tolerance.h"
#include "build/placement.h"
#include "modify/edit/influence.h"
#include "modify/edit/inverse_insertion.h"
#include "modify/edit/net_editor.h"
#include "modify/edit/pull_point.h"
#include "modify/edit/weight_edit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace nrb;
using namespace nrb::capi;

namespace {

// Checks the index of a control point and returns its original, the first of the copies that periodic axes
// make of it. place: where the index is in the array `indices`; < 0: it is an argument of its own.
int64_t checked_point(const Spline &spline, int64_t index, int64_t place = -1) {
    if (index < 0 || index >= spline.point_count()) {
        const auto last = static_cast<long long>(spline.point_count() - 1);
        if (place < 0) {
            fail(Status::index, "index = %lld, expected 0 to %lld", static_cast<long long>(index), last);
        }
        fail(Status::index, "indices[%lld] = %lld, expected 0 to %lld", static_cast<long long>(place),
             static_cast<long long>(index), last);
    }
    return modify::original_of(spline, index);
}

void check_different(const int64_t *indices, const std::vector<int64_t> &originals) {
    std::vector<size_t> order(originals.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
        return originals[a] < originals[b] || (originals[a] == originals[b] && a < b);
    });
    for (size_t i = 1; i < order.size(); ++i) {
        if (originals[order[i]] == originals[order[i - 1]]) {
            fail(Status::index, "indices[%zu] = %lld is the same control point as indices[%zu] = %lld",
                 order[i], static_cast<long long>(indices[order[i]]), order[i - 1],
                 static_cast<long long>(indices[order[i - 1]]));
        }
    }
}

std::vector<int64_t> checked_points(const Spline &spline, int64_t count, const int64_t *indices) {
    if (count > 0) {
        require(indices, "indices");
    }
    checked_array(count, "indices");
    std::vector<int64_t> originals;
    for (int64_t i = 0; i < count; ++i) {
        originals.push_back(checked_point(spline, indices[i], i));
    }
    check_different(indices, originals);
    return originals;
}

// Checks the parameters of a single place, [axes].
const double *checked_param(const Spline &spline, const double *params) {
    require(params, "params");
    eval::check_parameters(spline, {}, {params, 1, spline.axes(), spline.axes(), 1});
    return params;
}

void check_distance(double distance) {
    if (!std::isfinite(distance)) {
        fail(Status::length, "distance = %s is not finite", Number(distance).text);
    }
}

const double *given_point(const double *point, int64_t dim, const char *name) {
    require(point, name);
    build::check_point(point, dim, name);
    return point;
}

} // namespace

nurbs_status nurbs_pull_weight(const nurbs *g, int64_t index, const double *params, double distance,
                               double *weight, nurbs **out) {
    return guard([&] {
        require_out(out);
        const int64_t point = checked_point(spline_of(g), index);
        checked_param(*g->spline, params);
        check_distance(distance);
        modify::WeightEdit edit = modify::pull_weight(*g->spline, point, params, distance);
        give(std::move(edit.spline), out);
        put(weight, edit.value);
    });
}

nurbs_status nurbs_pull_weights(const nurbs *g, int64_t count, const int64_t *indices, const double *params,
                                double distance, double *factor, nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        check_at_least(count, 1, "count");
        const std::vector<int64_t> points = checked_points(spline, count, indices);
        checked_param(spline, params);
        check_distance(distance);
        modify::WeightEdit edit = modify::pull_weights(spline, points, params, distance);
        give(std::move(edit.spline), out);
        put(factor, edit.value);
    });
}

nurbs_status nurbs_set_weights(const nurbs *g, int64_t count, const int64_t *indices, const double *weights,
                               nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        check_length(count, "count");
        const std::vector<int64_t> points = checked_points(spline, count, indices);
        for (int64_t i = 0; i < count; ++i) {
            require(weights, "weights");
            if (!std::isfinite(weights[i]) || weights[i] < 0) {
                fail(std::isfinite(weights[i]) ? Status::weight_negative : Status::weight_not_finite,
                     "weights[%lld] = %s, expected finite and >= 0", static_cast<long long>(i),
                     Number(weights[i]).text);
            }
        }
        give(modify::set_weights(spline, points, weights), out);
    });
}

nurbs_status nurbs_weight_points(const nurbs *g, int64_t index, const double *params, double *at_zero,
                                 double *at_one, double *at_weight) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        const int64_t point = checked_point(spline, index);
        require(params, "params");
        const int64_t dim = spline.dim();
        check_apart({memory("at_zero", at_zero, dim), memory("at_one", at_one, dim),
                     memory("at_weight", at_weight, dim)},
                    {memory("params", params, spline.axes())});
        modify::weight_points(spline, point, checked_param(spline, params), at_zero, at_one, at_weight);
    });
}

nurbs_status nurbs_weight_cross_ratio(int32_t dim, const double *control_point, const double *at_zero,
                                      const double *at_one, const double *at_weight, double *weight) {
    return guard([&] {
        if (dim < 1) {
            fail(Status::dimension, "dim = %d, expected at least 1", dim);
        }
        require(weight, "weight");
        given_point(control_point, dim, "control_point");
        given_point(at_zero, dim, "at_zero");
        given_point(at_one, dim, "at_one");
        given_point(at_weight, dim, "at_weight");
        check_apart({memory("weight", weight, 1)},
                    {memory("control_point", control_point, dim), memory("at_zero", at_zero, dim),
                     memory("at_one", at_one, dim), memory("at_weight", at_weight, dim)});
        *weight = modify::weight_cross_ratio(dim, control_point, at_zero, at_one, at_weight);
    });
}

nurbs_status nurbs_weight_through(const nurbs *g, int64_t index, const double *params, const double *target,
                                  double tolerance, double *weight, nurbs **out) {
    return guard([&] {
        require_out(out);
        const int64_t point = checked_point(spline_of(g), index);
        checked_param(*g->spline, params);
        given_point(target, g->spline->dim(), "target");
        check_tolerance(tolerance);
        modify::WeightEdit edit = modify::weight_through(*g->spline, point, params, target, tolerance);
        give(std::move(edit.spline), out);
        put(weight, edit.value);
    });
}

nurbs_status nurbs_pull_point(const nurbs *g, int64_t index, const double *params, const double *direction,
                              double distance, double *moved, nurbs **out) {
    return guard([&] {
        require_out(out);
        const int64_t point = checked_point(spline_of(g), index);
        checked_param(*g->spline, params);
        require(direction, "direction");
        build::check_direction(direction, g->spline->dim(), "direction");
        check_distance(distance);
        modify::PointEdit edit = modify::pull_point(*g->spline, point, params, direction, distance);
        give(std::move(edit.spline), out);
        put(moved, edit.moved);
    });
}

nurbs_status nurbs_most_influential(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                                    int64_t param_component_stride, int64_t *indices, double *influences) {
    return guard([&] {
        const SplineBatch batch = spline_batch(g, n, params, param_stride, param_component_stride, 0);
        check_apart({memory("indices", indices, n), memory("influences", influences, n)},
                    {memory("params", params, batch.params.extent())});
        check_values(batch);
        modify::most_influential(batch.spline, batch.params, indices, influences);
    });
}

namespace {

modify::LegInsertion insert_checked(const nurbs *g, int32_t axis, int64_t index, double ratio) {
    if (!(ratio >= 0 && ratio <= 1)) {
        fail(Status::factor, "ratio = %s, expected 0 to 1", Number(ratio).text);
    }
    checked_point(*g->spline, index);
    return modify::insert_on_leg(g->spline, axis, index, ratio);
}

} // namespace

nurbs_status nurbs_insert_on_leg(const nurbs *g, int32_t axis, int64_t index, double ratio, double *knot,
                                 nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        modify::LegInsertion made = insert_checked(g, axis, index, ratio);
        give(std::move(made.spline), out);
        put(knot, made.knot);
    });
}

nurbs_status nurbs_insert_at_point(const nurbs *g, int32_t axis, const double *point, double tolerance,
                                   int64_t *index, double *ratio, double *knot, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        given_point(point, g->spline->dim(), "point");
        check_tolerance(tolerance);
        const modify::Leg leg = modify::nearest_leg(*g->spline, axis, point);
        if (!(leg.distance <= tolerance)) {
            fail(Status::off_polygon,
                 "point: distance %s from the nearest leg, from control point %lld along axis %d; tolerance "
                 "= %s",
                 Number(leg.distance).text, static_cast<long long>(leg.point), axis, Number(tolerance).text);
        }
        if (leg.point < 0) { // there is no leg, and the tolerance is infinite
            fail(Status::off_polygon, "g has no leg along axis %d without control points at infinity", axis);
        }
        modify::LegInsertion made = insert_checked(g, axis, leg.point, leg.ratio);
        give(std::move(made.spline), out);
        put(index, leg.point);
        put(ratio, leg.ratio);
        put(knot, made.knot);
    });
}
