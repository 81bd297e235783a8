// SPDX-License-Identifier: MIT
// Single points of curves, and the end points of their domains.
#pragma once

#include "eval/evaluate.h"

#include <vector>

namespace nrb::eval {

// The point at a parameter of the domain. At a knot, `left` chooses the polynomial piece to the left of the
// knot, otherwise the piece to the right is taken. out: [dim].
inline void curve_point(const Spline &curve, double t, bool left, double *out) {
    AxisRules rules{};
    rules[0].left = left;
    evaluate_points(curve, rules, 0, {&t, 1, 1, 1, 1}, {out, 1, curve.dim(), curve.dim(), 1});
}

inline std::vector<double> curve_point(const Spline &curve, double t, bool left) {
    std::vector<double> x(static_cast<size_t>(curve.dim()));
    curve_point(curve, t, left, x.data());
    return x;
}

// The point at the upper or the lower end of the domain, as a limit from within. out: [dim].
inline void end_point(const Spline &curve, bool upper, double *out) {
    const Interval domain = curve.axis(0).domain();
    curve_point(curve, upper ? domain.upper : domain.lower, upper, out);
}

inline std::vector<double> end_point(const Spline &curve, bool upper) {
    std::vector<double> x(static_cast<size_t>(curve.dim()));
    end_point(curve, upper, x.data());
    return x;
}

} // namespace nrb::eval
