// SPDX-License-Identifier: MIT
// Batches of basis functions of one knot vector.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// All parameters must have passed check_axis_parameters(). A parameter that gives NaN has span -1 and NaN
// values.
void find_spans(const KnotVector &axis, const AxisRule &rule, ConstRecords params, int64_t *spans);

// values record: [order + 1][degree + 1]; spans: [count] or null.
void basis_functions(const KnotVector &axis, const AxisRule &rule, int order, ConstRecords params,
                     int64_t *spans, Records values);

// values record: [order + 1][degree + 1]. Throws Status::parameter_not_finite before anything is written.
void bernstein_polynomials(int degree, int order, ConstRecords params, Records values);

} // namespace nrb::eval
