// SPDX-License-Identifier: MIT
// Checks of the options of fits.
#include "fit_arguments.h"
#include "guard.h"
#include "spline_data.h"
#include "structs.h"

#include "base/checked.h"

#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace nrb::capi {

namespace {

double checked_factor(double factor, const char *name) {
    if (!(factor >= 0 && std::isfinite(factor))) {
        fail(Status::factor, "options: %s = %s, expected a finite value >= 0", name, Number(factor).text);
    }
    return factor;
}

fit::FitCondition checked_condition(const nurbs_fit_options &options, int64_t i, const Spline::Axes &axes,
                                    int dim) {
    const auto count = std::ssize(axes);
    fit::FitCondition condition{};
    for (int64_t k = 0; k < count; ++k) {
        const int64_t at = i * count + k;
        const KnotVector &axis = *axes[static_cast<size_t>(k)];
        const double t = options.condition_params[at];
        const int order = options.condition_orders == nullptr ? 0 : options.condition_orders[at];
        char name[64];
        std::snprintf(name, sizeof name, "condition_params[%lld][%lld]", static_cast<long long>(i),
                      static_cast<long long>(k));
        eval::check_parameter(t, {}, axis.domain(), name);
        if (order < 0 || order > axis.degree()) {
            fail(Status::order, "condition_orders[%lld][%lld] = %d, expected 0 to %d, the degree",
                 static_cast<long long>(i), static_cast<long long>(k), order, axis.degree());
        }
        condition.place[static_cast<size_t>(k)] = t;
        condition.orders[static_cast<size_t>(k)] = order;
    }
    for (int64_t c = 0; c < dim; ++c) {
        const double target = options.condition_targets[i * dim + c];
        if (!std::isfinite(target)) {
            fail(Status::point_not_finite, "condition_targets[%lld][%lld] = %s is not finite",
                 static_cast<long long>(i), static_cast<long long>(c), Number(target).text);
        }
        condition.target.push_back(target);
    }
    return condition;
}

std::vector<double> checked_bounds(const double *bounds, int dim, const char *name) {
    if (bounds == nullptr) {
        return {};
    }
    for (int c = 0; c < dim; ++c) {
        if (std::isnan(bounds[c])) {
            fail(Status::point_not_finite, "%s[%d] is not a number", name, c);
        }
    }
    return {bounds, bounds + dim};
}

fit::ShapeWishes checked_shape(const nurbs_fit_options &options, int64_t axes, int dim) {
    fit::ShapeWishes shape;
    if (options.shapes != nullptr) {
        shape.along.assign(options.shapes, options.shapes + axes * dim);
    }
    shape.lower = checked_bounds(options.lower, dim, "lower");
    shape.upper = checked_bounds(options.upper, dim, "upper");
    return shape;
}

} // namespace

fit::FitWishes checked_wishes(const nurbs_fit_options *options, const Spline::Axes &axes, int dim) {
    fit::FitWishes wishes;
    if (options == nullptr) {
        return wishes;
    }
    const nurbs_fit_options &given = checked_struct("options", options);
    if (given.smoothing < NURBS_SMOOTHING_NONE || given.smoothing > NURBS_SMOOTHING_DISCREPANCY) {
        fail(Status::rule, "options: smoothing = %d, expected a NURBS_SMOOTHING_ constant", given.smoothing);
    }
    if (given.penalty_order < 1) {
        fail(Status::order, "options: penalty_order = %d, expected at least 1", given.penalty_order);
    }
    if (given.regularize != 0 && given.regularize != 1) {
        fail(Status::options, "options: regularize = %d, expected 0 or 1", given.regularize);
    }
    if (given.reserved != 0 || given.reserved2 != 0) {
        fail(Status::options, "options: reserved = %d, reserved2 = %d, expected 0", given.reserved,
             given.reserved2);
    }
    if (given.robust < NURBS_ROBUST_NONE || given.robust > NURBS_ROBUST_TUKEY) {
        fail(Status::rule, "options: robust = %d, expected a NURBS_ROBUST_ constant", given.robust);
    }
    wishes.smoothing = static_cast<fit::Smoothing>(given.smoothing);
    wishes.penalty_order = given.penalty_order;
    wishes.regularise = given.regularize == 1;
    const double lambda = checked_factor(given.lambda, "lambda"),
                 target = checked_factor(given.target, "target");
    wishes.value = given.smoothing == NURBS_SMOOTHING_LAMBDA ? lambda : target;
    wishes.robust = static_cast<fit::Robust>(given.robust);
    wishes.width = checked_factor(given.robust_width, "robust_width");
    wishes.shape = checked_shape(given, std::ssize(axes), dim);
    check_length(given.conditions, "options: conditions");
    checked_product(given.conditions, std::max<int64_t>(dim, std::ssize(axes)), "options: conditions");
    if (given.conditions > 0) {
        require(given.condition_params, "options: condition_params");
        require(given.condition_targets, "options: condition_targets");
    }
    for (int64_t i = 0; i < given.conditions; ++i) {
        wishes.conditions.push_back(checked_condition(given, i, axes, dim));
    }
    return wishes;
}

} // namespace nrb::capi

nurbs_status nurbs_fit_options_init(nurbs_fit_options *options, int64_t struct_size) {
    return guard([&] {
        clear_struct("options", options, struct_size);
        options->penalty_order = fit::FitWishes().penalty_order;
    });
}
