// SPDX-License-Identifier: MIT
// The adjoint (transpose) of evaluation: from the cotangents of a function L, its gradients with respect to
// points and derivatives, to its gradients with respect to control points, weights and parameters.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// The outputs. A view without data is not wanted.
struct Gradients {
    Records points;  // [control points][dim]
    Records weights; // [control points]
    Records params;  // [count][axes]
};

// cotangents: [count][slots][dim]. With `accumulate` the sums start from what the outputs hold.
// Preconditions: all parameters have been checked, and the outputs overlap nothing. All memory is allocated
// before anything is written.
void evaluate_adjoint(const Spline &spline, const AxisRules &rules, int order, ConstRecords params,
                      ConstRecords cotangents, bool accumulate, const Gradients &gradients);

} // namespace nrb::eval
