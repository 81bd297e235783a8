// SPDX-License-Identifier: MIT
// The control points that are active at a parameter, that is, those whose basis functions belong to the span
// of the parameter on each axis: their rational basis functions, and the hull size of the accuracy contract.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// The rational basis functions w_i N_i(t) / w(t). A record of `values` is [(p_0 + 1) ... (p_last + 1)], last
// axis fastest. spans: the span on each axis, packed [count][axes]; may be null. A parameter that gives NaN
// has NaN values, and -1 as its span on every axis.
void rational_basis(const Spline &spline, const AxisRules &rules, ConstRecords params, int64_t *spans,
                    Records values);

// The largest |coordinate| of an active control point of positive weight. If an active weight is negative, or
// an active control point lies at infinity, the size is (max|w_i P_i| + |C(t)| max|w_i|) / |w(t)| instead. A
// parameter that gives NaN has the size NaN.
void hull_sizes(const Spline &spline, const AxisRules &rules, ConstRecords params, Records sizes);

} // namespace nrb::eval
