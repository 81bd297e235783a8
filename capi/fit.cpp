// SPDX-License-Identifier: MIT
// Least-squares fits over given knots and to a tolerance, and approximations of splines.
#include "base/checked.h"
#include "base/tolerance.h"
#include "fit/adaptive/approximate.h"
#include "fit/adaptive/fit_tolerance.h"
#include "fit/least_squares/robust_fit.h"
#include "fit_arguments.h"
#include "guard.h"
#include "outputs.h"
#include "spline_data.h"
#include "structs.h"
#include "watched.h"

#include <cmath>
#include <limits>

using namespace nrb;
using namespace nrb::capi;

namespace nrb::capi {

namespace {

void check_report(const nurbs_fit_report *report) {
    if (report != nullptr) {
        check_struct_size("report", report->struct_size, sizeof(nurbs_fit_report));
    }
}

void tell(const fit::Fitted &fit, int64_t data_count, int dim, double largest, int64_t index,
          nurbs_fit_report *report) {
    if (report == nullptr) {
        return;
    }
    report->data_count = data_count;
    report->weight = fit.misfit.given_weight();
    report->squares = fit.misfit.given_squares();
    report->rms = fit.misfit.rms();
    report->lambda = fit.lambda;
    report->freedom = fit.freedom;
    report->sigma = fit.misfit.sigma(dim * (static_cast<double>(data_count) - fit.freedom));
    report->residual = fit.residual;
    report->largest = largest;
    report->largest_index = index;
    report->bits = (fit.reached ? 0 : NURBS_FIT_TARGET_MISSED) | (fit.settled ? 0 : NURBS_FIT_NOT_CONVERGED);
    report->rounds = 1;
    report->outliers = 0;
}

void tell(const fit::FittedPoints &made, int dim, bool robust, nurbs_fit_report *report) {
    tell(made.fit, made.data_count, dim, made.largest, made.largest_index, report);
    if (report != nullptr && robust) {
        report->bits |= made.converged ? 0 : NURBS_FIT_NOT_CONVERGED;
        report->rounds = made.rounds;
        report->outliers = made.outliers;
        report->sigma = made.scale;
    }
}

void refuse_robust(const fit::FitWishes &wishes, const char *why) {
    if (wishes.robust != fit::Robust::none) {
        fail(Status::rule, "options: robust = %d, expected NURBS_ROBUST_NONE: %s",
             static_cast<int>(wishes.robust), why);
    }
}

// The range of the finite parameters of axis k; empty, with lower > upper, if there are none.
Interval range_of(const ConstRecords &params, int64_t k) {
    Interval range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (int64_t i = 0; i < params.count; ++i) {
        const double t = params(i, k);
        if (std::isfinite(t)) {
            range = {std::min(range.lower, t), std::max(range.upper, t)};
        }
    }
    return range;
}

fit::FitDomain checked_domain(const nurbs_data &data, const ConstRecords &params, const int32_t *degrees,
                              const double *domain, uint32_t flags) {
    require(degrees, "degrees");
    fit::FitDomain result;
    for (int k = 0; k < data.axes; ++k) {
        check_degree(degrees[k], k);
        result.degrees.push_back(degrees[k]);
        result.periodic[static_cast<size_t>(k)] = decode_periodic(flags, data.axes, k);
        const Interval range =
            domain == nullptr ? range_of(params, k) : Interval{domain[2 * k], domain[2 * k + 1]};
        if (!(range.lower < range.upper && std::isfinite(range.upper - range.lower))) {
            fail(Status::empty_domain, "domain[%d] = [%s, %s], expected a finite interval of some length", k,
                 Number(range.lower).text, Number(range.upper).text);
        }
        result.domains.push_back(range);
    }
    return result;
}

int64_t checked_limit(int64_t max_count, const std::vector<int> &degrees) {
    check_length(max_count, "max_count");
    int64_t least = 1;
    for (const int degree : degrees) {
        least *= degree + 1;
    }
    if (max_count != 0 && max_count < least) {
        fail(Status::too_few_points, "max_count = %lld, expected 0 or at least %lld",
             static_cast<long long>(max_count), static_cast<long long>(least));
    }
    return max_count == 0 ? max_doubles : max_count;
}

} // namespace

} // namespace nrb::capi

nurbs_status nurbs_fit(const nurbs_statistics *statistics, const int32_t *degrees, const int64_t *counts,
                       const double *knots, int64_t knot_count, uint32_t flags,
                       const nurbs_fit_options *options, nurbs_fit_report *report, nurbs **out) {
    return guard([&] {
        require_out(out);
        const fit::Statistics &own = *statistics_of(statistics);
        const Spline::Axes axes =
            AxesData(own.form().axes(), degrees, counts, flags).with_knots(knots, knot_count);
        const fit::FitWishes wishes = checked_wishes(options, axes, own.form().dim);
        refuse_robust(wishes, "statistics do not hold the data");
        check_report(report);
        const fit::Fitted made = fit::fit(own, axes, wishes);
        give(made.spline, out);
        tell(made, own.data_count(), own.form().dim, std::numeric_limits<double>::quiet_NaN(), -1, report);
    });
}

nurbs_status nurbs_fit_with(const nurbs_statistics *statistics, const int32_t *degrees, const int64_t *counts,
                            const double *knots, int64_t knot_count, uint32_t flags,
                            const nurbs_fit_options *options, nurbs_fit_report *report,
                            const nurbs_call_options *call, nurbs **out) {
    return watched(call, out, [&] {
        return nurbs_fit(statistics, degrees, counts, knots, knot_count, flags, options, report, out);
    });
}

nurbs_status nurbs_fit_points(const nurbs_data *data, const int32_t *degrees, const int64_t *counts,
                              const double *knots, int64_t knot_count, uint32_t flags,
                              const nurbs_fit_options *options, nurbs_fit_report *report, nurbs **out) {
    return guard([&] {
        require_out(out);
        const CheckedData given = checked_data(data);
        const Spline::Axes axes = AxesData(data->axes, degrees, counts, flags).with_knots(knots, knot_count);
        const fit::FitWishes wishes = checked_wishes(options, axes, data->dim);
        check_report(report);
        const bool robust = wishes.robust != fit::Robust::none;
        const fit::FittedPoints made =
            robust ? fit::robust_fit(given.data, given.rules, axes, wishes)
                   : fit::fit_points(given.data, given.rules, axes, wishes, report != nullptr);
        give(made.fit.spline, out);
        tell(made, data->dim, robust, report);
    });
}

nurbs_status nurbs_fit_points_with(const nurbs_data *data, const int32_t *degrees, const int64_t *counts,
                                   const double *knots, int64_t knot_count, uint32_t flags,
                                   const nurbs_fit_options *options, nurbs_fit_report *report,
                                   const nurbs_call_options *call, nurbs **out) {
    return watched(call, out, [&] {
        return nurbs_fit_points(data, degrees, counts, knots, knot_count, flags, options, report, out);
    });
}

nurbs_status nurbs_fit_tolerance(const nurbs_data *data, const int32_t *degrees, const double *domain,
                                 double tolerance, int64_t max_count, uint32_t flags,
                                 const nurbs_fit_options *options, nurbs_fit_report *report, nurbs **out) {
    return guard([&] {
        require_out(out);
        const CheckedData given = checked_data(data);
        check_at_least(data->n, 1, "n");
        check_tolerance(tolerance, "tolerance");
        const fit::FitDomain over = checked_domain(*data, given.data.params, degrees, domain, flags);
        const int64_t limit = checked_limit(max_count, over.degrees);
        const fit::FitWishes wishes = checked_wishes(options, fit::simplest_axes(over), data->dim);
        refuse_robust(wishes, "a tolerance is for all data");
        check_report(report);
        const fit::ToleranceFit made =
            fit::fit_to_tolerance(given.data, given.rules, over, tolerance, limit, wishes);
        const fit::FittedPoints &points = made.points;
        give(points.fit.spline, out);
        tell(points, data->dim, false, report);
        if (report != nullptr && !made.reached) {
            report->bits |= NURBS_FIT_TARGET_MISSED;
        }
    });
}

nurbs_status nurbs_fit_tolerance_with(const nurbs_data *data, const int32_t *degrees, const double *domain,
                                      double tolerance, int64_t max_count, uint32_t flags,
                                      const nurbs_fit_options *options, nurbs_fit_report *report,
                                      const nurbs_call_options *call, nurbs **out) {
    return watched(call, out, [&] {
        return nurbs_fit_tolerance(data, degrees, domain, tolerance, max_count, flags, options, report, out);
    });
}

nurbs_status nurbs_approximate(const nurbs *g, const int32_t *degrees, double tolerance, int64_t max_count,
                               double *bound, nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        std::vector<int> wanted;
        for (int k = 0; k < spline.axes(); ++k) {
            wanted.push_back(degrees == nullptr ? spline.axis(k).degree() : degrees[k]);
            check_degree(wanted.back(), k);
        }
        check_tolerance(tolerance, "tolerance");
        const int64_t limit = checked_limit(max_count, wanted);
        const fit::Approximation made = fit::approximate(g->spline, wanted, tolerance, limit);
        give(made.spline, out);
        put(bound, made.bound);
    });
}

nurbs_status nurbs_approximate_with(const nurbs *g, const int32_t *degrees, double tolerance,
                                    int64_t max_count, double *bound, const nurbs_call_options *call,
                                    nurbs **out) {
    return watched(call, out,
                   [&] { return nurbs_approximate(g, degrees, tolerance, max_count, bound, out); });
}
