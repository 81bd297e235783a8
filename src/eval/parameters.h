// SPDX-License-Identifier: MIT
// The meaning of a caller's parameter: which side of a knot, and what happens outside the domain.
#pragma once

#include "base/records.h"
#include "spline/spline.h"

#include <array>
#include <cstdint>

namespace nrb::eval {

enum class Outside { refuse, clamp, extrapolate, wrap };

// The rule for one axis.
struct AxisRule {
    bool left = false;
    bool nan = false;
    Outside outside = Outside::refuse;
};
using AxisRules = std::array<AxisRule, max_axes>;

// Throws Status::parameter_not_finite or outside_domain if the rule does not allow t; `name` names it in the
// message.
void check_parameter(double t, const AxisRule &rule, Interval domain, const char *name);

// Checks every parameter of a batch or of one axis of a grid; messages name the array "params" and the index
// from `first_index` on.
void check_parameters(const Spline::Axes &axes, const AxisRules &rules, const ConstRecords &params);
inline void check_parameters(const Spline &spline, const AxisRules &rules, const ConstRecords &params) {
    check_parameters(spline.knot_vectors(), rules, params);
}
void check_axis_parameters(const KnotVector &axis, const AxisRule &rule, ConstRecords params,
                           int64_t first_index);

// Whether `count` parameters, packed with those of all axes in turn, lie in the closed domains; NaN lies in
// none.
bool all_inside(const double *params, int64_t count, int axes, const Interval *domains) noexcept;

// The largest quotient of a parameter and a period for which a remainder takes one multiplication: its rounded value is
// off by at most 1.
inline constexpr double most_periods = 0x1p50;

// The parameter to evaluate at for a parameter t that was checked, or NaN if the rule gives NaN. A wrapped
// parameter is in [lower, upper), from the left in (lower, upper].
double place_outside(double t, const AxisRule &rule, Interval domain) noexcept; // or at an end that wraps
inline double place(double t, const AxisRule &rule, Interval domain) noexcept {
    return t >= domain.lower && t <= domain.upper && rule.outside != Outside::wrap
               ? t
               : place_outside(t, rule, domain);
}

} // namespace nrb::eval
