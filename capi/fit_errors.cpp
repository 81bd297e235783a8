// SPDX-License-Identifier: MIT
// Standard errors of fits, and the criteria that choose the factor of the penalty.
#include "fit_arguments.h"
#include "guard.h"
#include "handle.h"
#include "watched.h"

#include "fit/least_squares/fit_errors.h"
#include "fit/least_squares/penalty.h"

#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace {

// Throws NURBS_ERROR_AXES unless there are as many axes as in the statistics.
void check_axes_of(const fit::Statistics &statistics, const Spline::Axes &axes) {
    if (std::ssize(axes) != statistics.form().axes()) {
        fail(Status::axes, "g has %d axes, expected %d, those of the statistics",
             static_cast<int>(axes.size()), statistics.form().axes());
    }
}

void check_not_negative(double value, const char *name) {
    if (!(std::isfinite(value) && value >= 0)) {
        fail(Status::factor, "%s = %s, expected a finite value >= 0", name, Number(value).text);
    }
}

// The order of the derivative that is penalised: 1 to the highest degree.
int checked_order(int32_t order, const Spline::Axes &axes) {
    const int highest = fit::highest_degree(axes);
    if (order < 1 || order > highest) {
        fail(Status::order, "penalty_order = %d, expected 1 to %d, the highest degree", order, highest);
    }
    return order;
}

} // namespace

nurbs_status nurbs_fit_errors(const nurbs_statistics *statistics, const nurbs *g, int32_t penalty_order,
                              double lambda, double sigma, int64_t n, const double *params,
                              int64_t param_stride, int64_t param_component_stride, uint32_t flags,
                              double *errors) {
    return guard([&] {
        const fit::Statistics &own = *statistics_of(statistics);
        const Spline::Axes &axes = spline_of(g).knot_vectors();
        check_length(n, "n");
        const ConstRecords places =
            input("params", params, n, own.form().axes(), param_stride, param_component_stride);
        const Records results = output("errors", errors, n, 1, 0, 0);
        check_overlap("errors", results, "params", places);
        check_axes_of(own, axes);
        check_not_negative(lambda, "lambda");
        check_not_negative(sigma, "sigma");
        const int order = lambda > 0 ? checked_order(penalty_order, axes) : 1;
        const eval::AxisRules rules = data_rules(flags, own.form().axes(), "");
        eval::check_parameters(axes, rules, places);
        StagedRecords made(results);
        fit::standard_errors(own, axes, order, lambda, places, rules, made.view());
        for (int64_t i = 0; i < n; ++i) {
            made.view()(i, 0) *= sigma;
        }
        made.commit();
    });
}

nurbs_status nurbs_fit_errors_with(const nurbs_statistics *statistics, const nurbs *g, int32_t penalty_order,
                                   double lambda, double sigma, int64_t n, const double *params,
                                   int64_t param_stride, int64_t param_component_stride, uint32_t flags,
                                   double *errors, const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_fit_errors(statistics, g, penalty_order, lambda, sigma, n, params, param_stride,
                                param_component_stride, flags, errors);
    });
}

nurbs_status nurbs_fit_criteria(const nurbs_statistics *statistics, const nurbs *g, int32_t penalty_order,
                                int64_t n, const double *lambdas, double *values) {
    return guard([&] {
        const fit::Statistics &own = *statistics_of(statistics);
        const Spline::Axes &axes = spline_of(g).knot_vectors();
        check_length(n, "n");
        const ConstRecords factors = input("lambdas", lambdas, n, 1, 0, 0);
        const Records results = output("values", values, n, 4, 0, 0);
        check_overlap("values", results, "lambdas", factors);
        check_axes_of(own, axes);
        const int order = checked_order(penalty_order, axes);
        std::vector<double> wanted;
        for (int64_t i = 0; i < n; ++i) {
            const double lambda = factors(i, 0);
            if (!(std::isfinite(lambda) && lambda > 0)) {
                fail(Status::factor, "lambdas[%lld] = %s, expected a finite value > 0",
                     static_cast<long long>(i), Number(lambda).text);
            }
            wanted.push_back(lambda);
        }
        const std::vector<fit::Criteria> found = fit::criteria(own, axes, order, wanted);
        for (int64_t i = 0; i < n; ++i) {
            const fit::Criteria &own_values = found[static_cast<size_t>(i)];
            results(i, 0) = own_values.squares;
            results(i, 1) = own_values.freedom;
            results(i, 2) = own_values.gcv;
            results(i, 3) = own_values.reml;
        }
    });
}

nurbs_status nurbs_fit_criteria_with(const nurbs_statistics *statistics, const nurbs *g,
                                     int32_t penalty_order, int64_t n, const double *lambdas, double *values,
                                     const nurbs_call_options *call) {
    return watched(call,
                   [&] { return nurbs_fit_criteria(statistics, g, penalty_order, n, lambdas, values); });
}
