// SPDX-License-Identifier: MIT
// Gradients of rational basis functions in space.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// gradients record: [(p_0 + 1) ... (p_last + 1)][dim], J (J^T J)^-1 times the derivatives by the parameters, J [dim][axes] those
// of the spline: on a curve or surface along it. NaN where J has dependent columns to rounding. spans: packed [count][axes] or
// null; -1 for a parameter that gives NaN. Precondition: no more axes than coordinates.
void basis_gradients(const Spline &spline, const AxisRules &rules, ConstRecords params, int64_t *spans,
                     Records gradients);

} // namespace nrb::eval
