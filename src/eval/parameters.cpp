// SPDX-License-Identifier: MIT
#include "eval/parameters.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace nrb::eval {

namespace {

bool inside(double t, Interval domain) noexcept {
    return t >= domain.lower && t <= domain.upper;
}

bool allowed(double t, const AxisRule &rule) noexcept {
    if (rule.nan) {
        return true;
    }
    return rule.outside == Outside::clamp ? !std::isnan(t)
                                          : std::isfinite(t) && rule.outside != Outside::refuse;
}

// Checks component k of every record. `format` makes the name for a message from the index, counted from
// `first_index`, and k.
void check_column(const ConstRecords &params, int k, const AxisRule &rule, Interval domain,
                  int64_t first_index, const char *format) {
    for (int64_t i = 0; i < params.count; ++i) {
        const double t = params(i, k);
        if (!inside(t, domain) && !allowed(t, rule)) {
            const long long index = first_index + i;
            char name[64];
            static_cast<void>(std::snprintf(name, sizeof name, format, index, k));
            check_parameter(t, rule, domain, name);
        }
    }
}

// A remainder of x modulo the period: congruent to fmod(x, period), exact like it, and smaller than the
// period in magnitude. It takes one multiplication unless the quotient is large.
double remainder_of(double x, double period) noexcept {
    const double quotient = std::trunc(x / period);
    if (!(std::abs(quotient) < most_periods)) {
        return std::fmod(x, period);
    }
    const double rest =
        std::fma(-quotient, period, x); // exact, and so is the correction if the sign is wrong
    const double signed_period = std::copysign(period, x);
    return rest * signed_period < 0   ? rest + signed_period
           : std::abs(rest) >= period ? rest - signed_period
                                      : rest;
}

// The parameter in the domain that differs from t by a multiple of the period; at the seam, the end of the
// domain from which the rule evaluates.
double wrap(double t, bool left, Interval domain) noexcept {
    const double period = domain.upper - domain.lower;
    double offset = remainder_of(t - domain.lower, period);
    if (!std::isfinite(offset)) { // t - lower overflows
        offset = std::fmod(std::fmod(t, period) - std::fmod(domain.lower, period), period);
    }
    const double wrapped = domain.lower + (offset < 0 ? offset + period : offset);
    const double placed = std::clamp(wrapped, domain.lower, domain.upper);
    if (left) {
        return placed == domain.lower ? domain.upper : placed;
    }
    return placed == domain.upper ? domain.lower : placed;
}

bool packed_inside(const Spline::Axes &axes, const ConstRecords &params) noexcept {
    std::array<Interval, max_axes> domains{};
    for (size_t k = 0; k < axes.size(); ++k) {
        domains[k] = axes[k]->domain();
    }
    const auto count = static_cast<int>(axes.size());
    return all_inside(params.data, params.count * count, count, domains.data());
}

} // namespace

void check_parameter(double t, const AxisRule &rule, Interval domain, const char *name) {
    if (inside(t, domain) || allowed(t, rule)) {
        return;
    }
    if (!std::isfinite(t)) {
        fail(Status::parameter_not_finite, "%s = %s is not finite", name, Number(t).text);
    }
    fail(Status::outside_domain, "%s = %s outside [%s, %s]", name, Number(t).text, Number(domain.lower).text,
         Number(domain.upper).text);
}

void check_parameters(const Spline::Axes &axes, const AxisRules &rules, const ConstRecords &params) {
    const auto count = static_cast<int>(axes.size());
    constexpr int64_t few = 8; // too few to be worth a call of the kernel
    const bool packed = params.stride == count && (params.component_stride == 1 || count == 1);
    if (packed && params.count > few && packed_inside(axes, params)) {
        return;
    }
    const char *format = count == 1 ? "params[%lld]" : "params[%lld][%d]";
    for (size_t k = 0; k < axes.size(); ++k) {
        check_column(params, static_cast<int>(k), rules[k], axes[k]->domain(), 0, format);
    }
}

void check_axis_parameters(const KnotVector &axis, const AxisRule &rule, ConstRecords params,
                           int64_t first_index) {
    check_column(params, 0, rule, axis.domain(), first_index, "params[%lld]");
}

double place_outside(double t, const AxisRule &rule, Interval domain) noexcept {
    if (std::isnan(t)) {
        return nan_value;
    }
    switch (rule.outside) {
    case Outside::clamp:
        return std::clamp(t, domain.lower, domain.upper);
    case Outside::extrapolate:
        return std::isfinite(t) ? t : nan_value;
    case Outside::wrap:
        if (t > domain.lower && t < domain.upper) {
            return t;
        }
        return std::isfinite(t) ? wrap(t, rule.left, domain) : nan_value;
    case Outside::refuse:
        break;
    }
    return nan_value;
}

} // namespace nrb::eval
