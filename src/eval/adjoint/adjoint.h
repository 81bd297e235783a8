// SPDX-License-Identifier: MIT
// Evaluation transposed: from the gradient of a function of points and derivatives to its gradients with
// respect to control points, weights and parameters.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// Views without data are not wanted.
struct Gradients {
    Records points;  // [control points][dim]
    Records weights; // [control points]
    Records params;  // [count][axes]
};

// cotangents: [count][slots][dim]. With `accumulate` the sums start from what the outputs hold. All
// parameters must have been checked; outputs overlap nothing. May throw only std::bad_alloc, before anything
// is written.
void evaluate_adjoint(const Spline &spline, const AxisRules &rules, int order, ConstRecords params,
                      ConstRecords cotangents, bool accumulate, const Gradients &gradients);

} // namespace nrb::eval
