// SPDX-License-Identifier: MIT
// The spline from which derivatives are evaluated.
#pragma once

#include "spline/at_origin.h"

namespace nrb::eval {

// The spline whose derivatives of orders 1, ..., `order` are those of another one: the same spline moved to
// the origin, except for curves in whose kernel nothing cancels. These are the polynomial curves and, with
// differences of control points, curves above the degrees of power spans.
inline const Spline &derivative_source(const Spline &spline, int order) {
    if (order == 0) {
        return spline;
    }
    const bool cancels =
        spline.axes() > 1 || (spline.rational() && power_span_degree(spline.axis(0).degree()));
    return cancels ? at_origin(spline) : spline;
}

} // namespace nrb::eval
