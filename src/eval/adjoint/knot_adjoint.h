// SPDX-License-Identifier: MIT
// The adjoint (transpose) of evaluation with respect to the knots of an axis.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// grad_knots: [knots], one component: the gradient with respect to each stored knot alone. Cotangents and
// parameters are as for evaluate_adjoint(). A parameter that a rule has moved does not move with the knots.
// All memory is allocated before anything is written.
void evaluate_knot_adjoint(const Spline &spline, int axis, const AxisRules &rules, int order,
                           ConstRecords params, ConstRecords cotangents, bool accumulate, Records grad_knots);

} // namespace nrb::eval
