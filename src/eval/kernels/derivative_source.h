// What derivatives are evaluated from.
#pragma once

#include "spline/at_origin.h"

namespace nrb::eval {

// The spline whose derivatives of orders 1, ..., `order` are those of another one: the same moved to the
// origin, but for the curves whose kernel has nothing that cancels. These are the polynomial ones and, with
// differences of control points, those above the degrees of pieces.
inline const Spline &derivative_source(const Spline &spline, int order) {
    if (order == 0) {
        return spline;
    }
    const bool cancels = spline.axes() > 1 || (spline.rational() && piece_degree(spline.axis(0).degree()));
    return cancels ? at_origin(spline) : spline;
}

} // namespace nrb::eval
