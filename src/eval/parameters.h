// SPDX-License-Identifier: MIT
// The rules by which a caller's parameter is interpreted: from which side it is evaluated at a knot, and what
// happens outside the domain.
#pragma once

#include "base/records.h"
#include "spline/spline.h"

#include <array>
#include <cstdint>

namespace nrb::eval {

// What to do with a parameter outside the domain: report an error, move it to the nearest end, continue the
// outermost polynomial piece, or add a multiple of the length of the domain.
enum class Outside { refuse, clamp, extrapolate, wrap };

// The rule for one axis. `left`: at a knot, take the piece to its left. `nan`: a parameter that would be an
// error gives NaN instead.
struct AxisRule {
    bool left = false;
    bool nan = false;
    Outside outside = Outside::refuse;
};
using AxisRules = std::array<AxisRule, max_axes>;

// Throws Status::parameter_not_finite or Status::outside_domain if the rule does not allow t; `name` names
// the parameter in the message.
void check_parameter(double t, const AxisRule &rule, Interval domain, const char *name);

// check_parameters() checks every parameter of a batch, check_axis_parameters() those of one axis of a grid.
// Messages name the array "params" and an index, which for an axis is counted from `first_index`.
void check_parameters(const Spline::Axes &axes, const AxisRules &rules, const ConstRecords &params);
inline void check_parameters(const Spline &spline, const AxisRules &rules, const ConstRecords &params) {
    check_parameters(spline.knot_vectors(), rules, params);
}
void check_axis_parameters(const KnotVector &axis, const AxisRule &rule, ConstRecords params,
                           int64_t first_index);

// Whether `count` parameters lie in their closed domains. The parameters of the axes alternate, without gaps.
// NaN lies in no domain.
bool all_inside(const double *params, int64_t count, int axes, const Interval *domains) noexcept;

// Below this quotient of a parameter and the period, the rounded and truncated quotient is off by at most 1,
// and the remainder takes one multiplication.
inline constexpr double most_periods = 0x1p50;

// The parameter at which to evaluate for a parameter t that was checked; NaN if the rule gives NaN. A wrapped
// parameter lies in [lower, upper), or in (lower, upper] if it is evaluated from the left. place_outside()
// handles all t outside the domain, and also its ends if the rule wraps.
double place_outside(double t, const AxisRule &rule, Interval domain) noexcept;
inline double place(double t, const AxisRule &rule, Interval domain) noexcept {
    return t >= domain.lower && t <= domain.upper && rule.outside != Outside::wrap
               ? t
               : place_outside(t, rule, domain);
}

} // namespace nrb::eval
