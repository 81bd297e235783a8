// SPDX-License-Identifier: MIT
// The smallest change of a spline that makes it meet constraints.
#include "batch.h"
#include "guard.h"
#include "outputs.h"
#include "structs.h"
#include "watched.h"

#include "base/tolerance.h"
#include "build/placement.h"
#include "modify/constrain/constrain.h"

#include <algorithm>
#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace {

struct GivenConstraints {
    const Spline &spline;
    int64_t count;
    const int32_t *kinds;
    const int32_t *orders;
    const double *params;
    const double *targets;

    [[nodiscard]] int32_t kind(int64_t i) const noexcept {
        return kinds == nullptr ? NURBS_CONSTRAIN_VALUE : kinds[i];
    }
};

// Refuses a kind that is unknown, or that does not suit the spline's number of axes or dimension.
void check_kind(const GivenConstraints &given, int64_t i) {
    const int32_t kind = given.kind(i);
    const int axes = given.spline.axes(), dim = given.spline.dim();
    const auto place = static_cast<long long>(i);
    if (kind < NURBS_CONSTRAIN_VALUE || kind > NURBS_CONSTRAIN_CURVATURE) {
        fail(Status::constraint, "kinds[%lld] = %d, expected one of the NURBS_CONSTRAIN_ constants", place,
             kind);
    }
    if (kind == NURBS_CONSTRAIN_CURVATURE && axes != 1) {
        fail(Status::axes, "kinds[%lld] = NURBS_CONSTRAIN_CURVATURE is for curves, g has %d axes", place,
             axes);
    }
    const int least = kind == NURBS_CONSTRAIN_VALUE ? 1 : kind == NURBS_CONSTRAIN_NORMAL ? axes + 1 : 2;
    if (dim < least) {
        fail(Status::dimension, "kinds[%lld] = %d asks for dimension %d at least, that of g is %d", place,
             kind, least, dim);
    }
}

eval::Orders checked_orders(const GivenConstraints &given, int64_t i) {
    const int32_t kind = given.kind(i);
    const int axes = given.spline.axes();
    eval::Orders orders{};
    if (given.orders == nullptr) {
        orders[0] = kind == NURBS_CONSTRAIN_DIRECTION && axes == 1 ? 1 : 0;
        return orders;
    }
    const bool free = kind == NURBS_CONSTRAIN_VALUE || kind == NURBS_CONSTRAIN_DIRECTION;
    int total = 0;
    for (int k = 0; k < axes; ++k) {
        const int32_t order = given.orders[i * axes + k];
        if (order < 0 || order > (free ? NURBS_MAX_ORDER : 0)) {
            fail(Status::order, "orders[%lld][%d] = %d, expected 0%s", static_cast<long long>(i), k, order,
                 free ? " to NURBS_MAX_ORDER" : " for this kind");
        }
        orders[static_cast<size_t>(k)] = order;
        total += order;
    }
    if (total > NURBS_MAX_ORDER) {
        fail(Status::order, "orders[%lld] add up to %d, expected at most %d", static_cast<long long>(i),
             total, NURBS_MAX_ORDER);
    }
    return orders;
}

void check_target(const GivenConstraints &given, int64_t i, const double *target) {
    const int dim = given.spline.dim();
    const double *const bad =
        std::find_if_not(target, target + dim, [](double x) { return std::isfinite(x); });
    if (bad != target + dim) {
        fail(Status::point_not_finite, "targets[%lld][%lld] = %s is not finite", static_cast<long long>(i),
             static_cast<long long>(bad - target), Number(*bad).text);
    }
    const int32_t kind = given.kind(i);
    const bool direction = kind == NURBS_CONSTRAIN_DIRECTION || kind == NURBS_CONSTRAIN_NORMAL;
    if (direction && std::all_of(target, target + dim, [](double x) { return x == 0; })) {
        fail(Status::direction, "targets[%lld] is zero, expected a direction", static_cast<long long>(i));
    }
}

std::vector<modify::Condition> checked_conditions(const GivenConstraints &given) {
    const int axes = given.spline.axes(), dim = given.spline.dim();
    eval::check_parameters(given.spline, {}, {given.params, given.count, axes, axes, 1});
    std::vector<modify::Condition> conditions;
    for (int64_t i = 0; i < given.count; ++i) {
        const double *const target = given.targets + i * dim;
        check_kind(given, i);
        check_target(given, i, target);
        conditions.emplace_back(given.kind(i), checked_orders(given, i), given.params + i * axes, target,
                                axes, dim);
    }
    return conditions;
}

void check_costs(const Spline &spline, const double *costs, const char *name) {
    for (int64_t i = 0; costs != nullptr && i < spline.point_count(); ++i) {
        if (!(costs[i] > 0)) {
            fail(Status::factor, "%s[%lld] = %s, expected > 0", name, static_cast<long long>(i),
                 Number(costs[i]).text);
        }
    }
}

} // namespace

nurbs_status nurbs_constrain(const nurbs *g, int64_t count, const int32_t *kinds, const int32_t *orders,
                             const double *params, const double *targets, const int32_t *keep,
                             const double *costs, const double *weight_costs, double tolerance,
                             double *residuals, int64_t *rank, double *moved, double *optimality,
                             nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        check_at_least(count, 1, "count");
        const int64_t axes = spline.axes(), dim = spline.dim(), points = spline.point_count();
        static_cast<void>(checked_product(count, std::max(axes, dim), "targets"));
        require(params, "params");
        require(targets, "targets");
        check_apart({memory("residuals", residuals, count), memory("rank", rank, 1),
                     memory("moved", moved, 1), memory("optimality", optimality, 1)},
                    {memory("kinds", kinds, count), memory("orders", orders, count * axes),
                     memory("params", params, count * axes), memory("targets", targets, count * dim),
                     memory("keep", keep, 2 * axes), memory("costs", costs, points),
                     memory("weight_costs", weight_costs, points)});
        check_keep(spline, keep);
        check_costs(spline, costs, "costs");
        check_costs(spline, weight_costs, "weight_costs");
        check_tolerance(tolerance);
        const std::vector<modify::Condition> conditions =
            checked_conditions({spline, count, kinds, orders, params, targets});
        modify::Constrained made =
            modify::constrain(spline, conditions, {keep, costs, weight_costs}, tolerance);
        give(std::move(made.spline), out);
        put_all(residuals, made.residuals);
        put(rank, made.rank);
        put(moved, made.moved);
        put(optimality, made.optimality);
    });
}

nurbs_status nurbs_constrain_with(const nurbs *g, const nurbs_constraints *constraints,
                                  nurbs_constraint_report *report, const nurbs_call_options *call,
                                  nurbs **out) {
    return watched(call, out, [&] {
        const nurbs_constraints &c = checked_struct("constraints", constraints);
        nurbs_constraint_report found{};
        found.residuals = report == nullptr ? nullptr : checked_struct("report", report).residuals;
        const nurbs_status status = nurbs_constrain(
            g, c.count, c.kinds, c.orders, c.params, c.targets, c.keep, c.costs, c.weight_costs, c.tolerance,
            found.residuals, &found.rank, &found.moved, &found.optimality, out);
        if (status == NURBS_OK && report != nullptr) {
            report->rank = found.rank;
            report->moved = found.moved;
            report->optimality = found.optimality;
        }
        return status;
    });
}
