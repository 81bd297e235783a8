// SPDX-License-Identifier: MIT
// Interpolation of points, derivatives and directions; parameters and tangents for it.
#include "checks.h"
#include "guard.h"

#include "base/checked.h"
#include "base/finite.h"
#include "base/representable.h"
#include "basis/generators.h"
#include "fit/interpolate.h"
#include "fit/largest_miss.h"
#include "fit/mixed_derivatives.h"
#include "fit/tangents.h"
#include "outputs.h"
#include "spline_data.h"

#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace {

struct Points {
    int32_t dim;
    const double *data;
    int64_t stride;
    int64_t component_stride;
};

std::vector<int64_t> checked_counts(int32_t axes, const int64_t *counts) {
    check_axes(axes);
    require(counts, "counts");
    for (int k = 0; k < axes; ++k) {
        if (counts[k] < 1) {
            fail(Status::count, "counts[%d] = %lld, expected at least 1", k,
                 static_cast<long long>(counts[k]));
        }
    }
    return {counts, counts + axes};
}

// Throws NURBS_ERROR_POINT_NOT_FINITE for a value that is not finite, except for NaN in a point for which
// may_be_unknown(index) is true.
template <class Unknown>
void check_finite(const char *name, std::span<const double> values, int dim, Unknown &&may_be_unknown) {
    if (all_finite(values)) {
        return;
    }
    for (size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i]) &&
            !(std::isnan(values[i]) && may_be_unknown(static_cast<int64_t>(i) / dim))) {
            fail(Status::point_not_finite, "%s[%zu][%zu] = %s is not finite", name,
                 i / static_cast<size_t>(dim), i % static_cast<size_t>(dim), Number(values[i]).text);
        }
    }
}

void check_finite(const char *name, std::span<const double> values, int dim) {
    check_finite(name, values, dim, [](int64_t) { return false; });
}

ConstRecords records(const char *name, const Points &points, int64_t count) {
    check_dimension(points.dim);
    return input(name, points.data, count, points.dim, points.stride, points.component_stride);
}

std::vector<double> finite_points(const char *name, const Points &points, int64_t count) {
    std::vector<double> values = packed(records(name, points, count));
    check_finite(name, values, points.dim);
    return values;
}

// The shape of a grid of points; stores their number in `total`.
fit::GridShape checked_shape(std::vector<int64_t> counts, int dim, uint32_t flags, int64_t &total) {
    fit::GridShape grid{std::move(counts), dim};
    total = 1;
    for (size_t k = 0; k < grid.counts.size(); ++k) {
        total = checked_product(total, grid.counts[k], "points");
        grid.periodic[k] =
            decode_periodic(flags, static_cast<int32_t>(grid.counts.size()), static_cast<int>(k));
    }
    return grid;
}

fit::PointGrid checked_grid(std::vector<int64_t> counts, const Points &points, uint32_t flags) {
    int64_t total = 1;
    fit::GridShape shape = checked_shape(std::move(counts), points.dim, flags, total);
    return {std::move(shape), finite_points("points", points, total)};
}

// A grid of layers of points and derivatives. Where layers of derivatives of two axes cross, the mixed
// derivatives may be NaN.
fit::PointGrid checked_grid_of_layers(std::vector<int64_t> counts, const Points &values,
                                      const std::vector<fit::AxisLayers> &layers, uint32_t flags) {
    int64_t total = 1;
    fit::GridShape shape = checked_shape(std::move(counts), values.dim, flags, total);
    std::vector<double> points = packed(records("values", values, total));
    check_finite("values", points, values.dim, [&](int64_t point) {
        std::vector<int64_t> place(shape.counts.size());
        for (size_t k = place.size(); k-- > 0; point /= shape.counts[k]) {
            place[k] = point % shape.counts[k];
        }
        return fit::is_mixed(layers, place);
    });
    return {std::move(shape), std::move(points)};
}

// The sum of the counts. It does not overflow, since each count is a factor of the number of points, which
// was checked.
int64_t sum_of(const std::vector<int64_t> &counts) noexcept {
    int64_t sum = 0;
    for (const int64_t count : counts) {
        sum += count;
    }
    return sum;
}

std::span<const double> checked_params(const double *params, int64_t n) {
    require(params, "params");
    return {params, static_cast<size_t>(n)};
}

std::vector<int> checked_degrees(int32_t axes, const int32_t *degrees) {
    require(degrees, "degrees");
    for (int k = 0; k < axes; ++k) {
        check_degree(degrees[k], k);
    }
    return {degrees, degrees + axes};
}

std::vector<fit::Ends> checked_ends(int32_t axes, const int32_t *ends) {
    std::vector<fit::Ends> result(static_cast<size_t>(axes), {fit::End::not_a_knot, fit::End::not_a_knot});
    for (int i = 0; ends != nullptr && i < 2 * axes; ++i) {
        if (ends[i] < NURBS_ENDS_NOT_A_KNOT || ends[i] > NURBS_ENDS_FREE) {
            fail(Status::rule, "ends[%d][%d] = %d, expected a NURBS_ENDS_ constant", i / 2, i % 2, ends[i]);
        }
        result[static_cast<size_t>(i / 2)][static_cast<size_t>(i % 2)] = static_cast<fit::End>(ends[i]);
    }
    return result;
}

void check_rule(int32_t rule, double exponent) {
    constexpr double largest = 8;
    if (rule < NURBS_PARAMS_UNIFORM || rule > NURBS_PARAMS_FOLEY_NIELSON) {
        fail(Status::rule, "rule = %d, expected a NURBS_PARAMS_ constant", rule);
    }
    if (rule == NURBS_PARAMS_POWER && !(exponent >= 0 && exponent <= largest)) {
        fail(Status::factor, "exponent = %s, expected 0 to 8", Number(exponent).text);
    }
}

// The full knot vectors of all axes. An axis has as many distinct layers of control points as data; a
// periodic axis has `degree` layers more, which repeat the first ones.
Spline::Axes checked_axes(const std::vector<int> &degrees, const fit::GridShape &grid, const double *knots,
                          int64_t knot_count) {
    std::vector<int64_t> sizes(degrees.size());
    int64_t total = 0;
    for (size_t k = 0; k < sizes.size(); ++k) {
        const int64_t count = grid.counts[k] + (grid.periodic[k] ? degrees[k] : 0);
        check_count(degrees[k], count, static_cast<int>(k));
        sizes[k] = checked_sum(count, degrees[k] + 1, "knots");
        total = checked_sum(total, sizes[k], "knots");
    }
    check_size(knot_count, total, "knot_count");
    require(knots, "knots");
    Spline::Axes axes;
    int64_t offset = 0;
    for (size_t k = 0; k < sizes.size(); ++k) {
        axes.push_back(make_knot_vector(degrees[k], {knots + offset, knots + offset + sizes[k]},
                                        grid.periodic[k], static_cast<int>(k), offset));
        offset += sizes[k];
    }
    return axes;
}

// The order of condition i, after a check; 1 for a direction.
int32_t checked_order(int64_t i, int degree, double param, int32_t order) {
    const long long at = i;
    if (!std::isfinite(param)) {
        fail(Status::parameter_not_finite, "params[%lld] = %s is not finite", at, Number(param).text);
    }
    constexpr int highest = 15; // above 20, rounding decides which lengths have the least energy
    if (order == NURBS_ORDER_DIRECTION && (degree < 2 || degree > highest)) {
        fail(Status::order, "orders[%lld] = %d, a direction, expected a degree from 2 to %d, not %d", at,
             order, highest, degree);
    }
    if ((order < 0 && order != NURBS_ORDER_DIRECTION) || order > degree) {
        fail(Status::order, "orders[%lld] = %d, expected 0 to %d, the degree, or NURBS_ORDER_DIRECTION", at,
             order, degree);
    }
    return order == NURBS_ORDER_DIRECTION ? 1 : order;
}

// Checks conditions i - 1 and i: parameters must not decrease, and orders must rise where parameters are
// equal.
void check_next(const fit::CurveConditions &given, size_t i) {
    const double before = given.params[i - 1], next = given.params[i];
    if (next < before) {
        fail(Status::knots_decreasing, "params[%zu] = %s, expected at least params[%zu] = %s", i,
             Number(next).text, i - 1, Number(before).text);
    }
    if (next == before && given.orders[i] <= given.orders[i - 1]) {
        fail(Status::order, "orders[%zu] = %d, expected more than orders[%zu] = %d at the same parameter %s",
             i, given.orders[i], i - 1, given.orders[i - 1], Number(next).text);
    }
}

void check_direction(const fit::CurveConditions &given, int64_t i) {
    const double *const target = given.targets.data() + i * given.dim;
    if (std::all_of(target, target + given.dim, [](double x) { return x == 0; })) {
        fail(Status::direction, "targets[%lld] is 0, expected a direction", static_cast<long long>(i));
    }
}

fit::CurveConditions checked_conditions(int degree, int64_t n, const double *params, const int32_t *orders,
                                        const Points &targets) {
    require(params, "params");
    require(targets.data, "targets");
    check_degree(degree, -1);
    check_at_least(n, 1, "n");
    fit::CurveConditions given{{}, {}, {}, targets.dim, finite_points("targets", targets, n)};
    given.params.assign(params, params + n);
    given.orders.reserve(static_cast<size_t>(n));
    for (int64_t i = 0; i < n; ++i) {
        given.orders.push_back(checked_order(i, degree, params[i], orders == nullptr ? 0 : orders[i]));
        if (i > 0) {
            check_next(given, static_cast<size_t>(i));
        }
        if (orders != nullptr && orders[i] == NURBS_ORDER_DIRECTION) {
            given.directions.push_back(i);
            check_direction(given, i);
        }
    }
    return given;
}

KnotVectorPtr knots_for(int degree, std::span<const double> params, const double *knots, int64_t knot_count,
                        uint32_t flags) {
    const bool periodic = decode_periodic(flags, 1, 0);
    if (knots != nullptr && knot_count != 0) {
        fit::GridShape grid{{std::ssize(params)}, 1};
        grid.periodic[0] = periodic;
        return checked_axes({degree}, grid, knots, knot_count)[0];
    }
    check_size(knot_count, 0, "knot_count");
    if (periodic) {
        fail(Status::flags, "flags = 0x%x: NURBS_PERIODIC needs knots", flags);
    }
    check_count(degree, std::ssize(params), -1);
    std::vector<double> averages(params.size() + static_cast<size_t>(degree) + 1);
    averaged_knots(degree, params, averages);
    return make_knot_vector(degree, std::move(averages));
}

} // namespace

nurbs_status nurbs_parametrize(int32_t axes, const int64_t *counts, int32_t dim, const double *points,
                               int64_t point_stride, int64_t point_component_stride, int32_t rule,
                               double exponent, uint32_t flags, double *params) {
    return guard([&] {
        int64_t total = 1;
        const fit::GridShape grid = checked_shape(checked_counts(axes, counts), dim, flags, total);
        const ConstRecords given =
            records("points", {dim, points, point_stride, point_component_stride}, total);
        std::vector<double> room;
        const std::span<const double> values = packed(given, room);
        check_finite("points", values, dim);
        check_rule(rule, exponent);
        require(params, "params");
        const Records out = output("params", params, sum_of(grid.counts), 1, 1, 1);
        check_overlap("params", out, "points", given);
        check_apart({memory("params", params, out.count)}, {memory("counts", counts, axes)});
        const std::vector<double> made =
            fit::parametrize(grid, values, static_cast<fit::ParameterRule>(rule), exponent);
        std::copy(made.begin(), made.end(), params);
    });
}

nurbs_status nurbs_params_universal(int32_t degree, int64_t count, double *params) {
    return guard([&] {
        check_degree(degree, -1);
        check_at_least(count, 2, "count");
        check_count(degree, count, -1);
        checked_array(count, "params");
        require(params, "params");
        const std::vector<double> made = fit::universal_params(degree, count);
        std::copy(made.begin(), made.end(), params);
    });
}

nurbs_status nurbs_interpolate(int32_t axes, const int32_t *degrees, const int64_t *counts,
                               const double *params, int32_t dim, const double *points, int64_t point_stride,
                               int64_t point_component_stride, const int32_t *ends, uint32_t flags,
                               double *residual, nurbs **out) {
    return guard([&] {
        require_out(out);
        fit::PointGrid grid = checked_grid(checked_counts(axes, counts),
                                           {dim, points, point_stride, point_component_stride}, flags);
        const std::span<const double> places = checked_params(params, sum_of(grid.counts));
        const std::vector<int> orders = checked_degrees(axes, degrees);
        const std::vector<fit::Ends> at_ends = checked_ends(axes, ends);
        const std::vector<fit::AxisLayers> layers = fit::layers_by_axis(grid.counts, places);
        if (residual == nullptr) {
            return give(fit::interpolate(orders, layers, std::move(grid), at_ends), out);
        }
        SplinePtr made = fit::interpolate(orders, layers, grid, at_ends);
        const double miss = fit::largest_miss(*made, places, grid);
        give(std::move(made), out);
        *residual = miss;
    });
}

nurbs_status nurbs_interpolate_derivatives(int32_t axes, const int32_t *degrees, const int64_t *counts,
                                           const double *params, const int32_t *orders, int32_t dim,
                                           const double *values, int64_t value_stride,
                                           int64_t value_component_stride, const int32_t *ends,
                                           uint32_t flags, nurbs **out) {
    return guard([&] {
        require_out(out);
        std::vector<int64_t> sizes = checked_counts(axes, counts);
        require(degrees, "degrees");
        require(params, "params");
        require(values, "values");
        int64_t layer_count = 0;
        for (const int64_t size : sizes) {
            layer_count = checked_sum(layer_count, size, "params");
        }
        checked_array(layer_count, "params");
        const std::vector<fit::AxisLayers> layers =
            fit::layers_by_axis(sizes, checked_params(params, layer_count),
                                orders == nullptr ? std::span<const int32_t>()
                                                  : std::span(orders, static_cast<size_t>(layer_count)));
        fit::PointGrid grid = checked_grid_of_layers(
            std::move(sizes), {dim, values, value_stride, value_component_stride}, layers, flags);
        give(fit::interpolate(checked_degrees(axes, degrees), layers, std::move(grid),
                              checked_ends(axes, ends)),
             out);
    });
}

nurbs_status nurbs_interpolate_over_knots(int32_t axes, const int32_t *degrees, const int64_t *counts,
                                          const double *params, const double *knots, int64_t knot_count,
                                          int32_t dim, const double *points, int64_t point_stride,
                                          int64_t point_component_stride, uint32_t flags, nurbs **out) {
    return guard([&] {
        require_out(out);
        fit::PointGrid grid = checked_grid(checked_counts(axes, counts),
                                           {dim, points, point_stride, point_component_stride}, flags);
        const std::span<const double> places = checked_params(params, sum_of(grid.counts));
        const Spline::Axes over = checked_axes(checked_degrees(axes, degrees), grid, knots, knot_count);
        give(fit::interpolate(over, places, std::move(grid)), out);
    });
}

nurbs_status nurbs_curve_interpolate(int32_t degree, int64_t n, const double *params, const int32_t *orders,
                                     int32_t dim, const double *targets, int64_t target_stride,
                                     int64_t target_component_stride, const double *knots, int64_t knot_count,
                                     uint32_t flags, nurbs **out) {
    return guard([&] {
        require_out(out);
        fit::CurveConditions given = checked_conditions(
            degree, n, params, orders, {dim, targets, target_stride, target_component_stride});
        KnotVectorPtr over = knots_for(degree, checked_params(params, n), knots, knot_count, flags);
        give(fit::interpolate_conditions(std::move(given), std::move(over)), out);
    });
}

nurbs_status nurbs_tangent_lengths(int32_t degree, int64_t n, const double *params, const int32_t *orders,
                                   int32_t dim, const double *targets, int64_t target_stride,
                                   int64_t target_component_stride, const double *knots, int64_t knot_count,
                                   uint32_t flags, double *lengths) {
    return guard([&] {
        require(lengths, "lengths");
        const fit::CurveConditions given = checked_conditions(
            degree, n, params, orders, {dim, targets, target_stride, target_component_stride});
        KnotVectorPtr over = knots_for(degree, checked_params(params, n), knots, knot_count, flags);
        const Records out = output("lengths", lengths, n, 1, 1, 1);
        check_overlap("lengths", out, "params", input("params", params, n, 1));
        check_overlap("lengths", out, "targets",
                      input("targets", targets, n, dim, target_stride, target_component_stride));
        check_overlap("lengths", out, "knots", input("knots", knots, knot_count, 1));
        check_overlap("lengths", lengths, n * 8, "orders", orders, orders == nullptr ? 0 : n * 4);
        const std::vector<double> made = fit::tangent_lengths(given, std::move(over));
        std::copy(made.begin(), made.end(), lengths);
    });
}

nurbs_status nurbs_tangents(int32_t rule, int64_t n, const double *params, int32_t dim, const double *points,
                            int64_t point_stride, int64_t point_component_stride, uint32_t flags,
                            double *tangents, int64_t tangent_stride, int64_t tangent_component_stride) {
    return guard([&] {
        if (rule < NURBS_TANGENTS_CATMULL_ROM || rule > NURBS_TANGENTS_MONOTONE) {
            fail(Status::rule, "rule = %d, expected a NURBS_TANGENTS_ constant", rule);
        }
        check_at_least(n, 2, "n");
        const fit::PointGrid data =
            checked_grid({n}, {dim, points, point_stride, point_component_stride}, flags);
        const std::span<const double> places = checked_params(params, n);
        fit::check_params(places, data.counts);
        fit::check_closed(data);
        const Records out = output("tangents", tangents, n, dim, tangent_stride, tangent_component_stride);
        check_overlap("tangents", out, "points",
                      input("points", points, n, dim, point_stride, point_component_stride));
        check_overlap("tangents", out, "params", input("params", params, n, 1));
        const std::vector<double> made =
            fit::tangents_of(static_cast<fit::TangentRule>(rule), places, dim, data.points, data.periodic[0]);
        require_representable(made, "tangents");
        for (int64_t i = 0; i < n; ++i) {
            for (int64_t c = 0; c < dim; ++c) {
                out(i, c) = made[static_cast<size_t>(i * dim + c)];
            }
        }
    });
}
