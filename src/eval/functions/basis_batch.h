// SPDX-License-Identifier: MIT
// B-spline basis functions and spans of one knot vector, and Bernstein polynomials, at batches of parameters.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// The span of each parameter. Precondition of this function and of basis_functions(): all parameters have
// passed check_axis_parameters(). A parameter that gives NaN has the span -1 and NaN values.
void find_spans(const KnotVector &axis, const AxisRule &rule, ConstRecords params, int64_t *spans);

// The active functions and their derivatives. A record of `values` is [order + 1][degree + 1]. spans:
// [count]; may be null.
void basis_functions(const KnotVector &axis, const AxisRule &rule, int order, ConstRecords params,
                     int64_t *spans, Records values);

// The Bernstein polynomials of a degree over [0, 1] and their derivatives. A record of `values` is [order +
// 1][degree + 1]. Throws Status::parameter_not_finite before anything is written.
void bernstein_polynomials(int degree, int order, ConstRecords params, Records values);

} // namespace nrb::eval
