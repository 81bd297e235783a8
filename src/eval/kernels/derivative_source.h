// SPDX-License-Identifier: MIT
// The spline whose control points derivatives are computed from.
#pragma once

#include "spline/at_origin.h"

namespace nrb::eval {

// A spline with the same derivatives of orders 1, ..., `order` as the given one, from which they are
// computed. It is the given spline moved to the origin, so that no part common to all coordinates has to
// cancel. Curves in whose kernel nothing cancels are taken as they are: polynomial curves, and curves above
// the degrees of power spans, whose derivatives come from differences of control points.
inline const Spline &derivative_source(const Spline &spline, int order) {
    if (order == 0) {
        return spline;
    }
    const bool cancels =
        spline.axes() > 1 || (spline.rational() && power_span_degree(spline.axis(0).degree()));
    return cancels ? at_origin(spline) : spline;
}

} // namespace nrb::eval
