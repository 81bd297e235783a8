// SPDX-License-Identifier: MIT
// Evaluation transposed with respect to the knots of an axis.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// grad_knots: [knots] of one component: the gradient for each stored knot alone. cotangents and parameters as
// for evaluate_adjoint(); a parameter that a rule moves stays where it is. May throw only std::bad_alloc,
// before anything is written.
void evaluate_knot_adjoint(const Spline &spline, int axis, const AxisRules &rules, int order,
                           ConstRecords params, ConstRecords cotangents, bool accumulate, Records grad_knots);

} // namespace nrb::eval
