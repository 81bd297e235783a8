// SPDX-License-Identifier: MIT
// The control points that are active at a parameter: their rational basis functions, and their size.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// values record: [(p_0 + 1) ... (p_last + 1)]; spans: packed [count][axes] or null. A parameter that gives
// NaN has spans -1.
void rational_basis(const Spline &spline, const AxisRules &rules, ConstRecords params, int64_t *spans,
                    Records values);

// The largest |coordinate| of an active control point of positive weight. If a weight is negative or a point
// at infinity: (max|w_i P_i| + |C(t)| max|w_i|) / |w(t)|.
void hull_sizes(const Spline &spline, const AxisRules &rules, ConstRecords params, Records sizes);

} // namespace nrb::eval
