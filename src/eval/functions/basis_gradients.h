// SPDX-License-Identifier: MIT
// Gradients of rational basis functions in space, as functions of the point instead of the parameters.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// A record of `gradients` is [(p_0 + 1) ... (p_last + 1)][dim]: for each active function R, J (J^T J)^-1
// dR/dt, where J, [dim][axes], is the Jacobian of the spline. On a curve or a surface in space the gradient
// is tangential. It is NaN where the columns of J are linearly dependent up to rounding. spans: packed
// [count][axes], may be null; -1 for a parameter that gives NaN. Precondition: no more axes than coordinates.
void basis_gradients(const Spline &spline, const AxisRules &rules, ConstRecords params, int64_t *spans,
                     Records gradients);

} // namespace nrb::eval
