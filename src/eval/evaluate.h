// SPDX-License-Identifier: MIT
// Batch evaluation into the caller's arrays.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// out record: [slots][dim], slots = slot_count(axes, order). Order 0: points. All parameters must have passed
// check_parameters(); the strided views must not overlap. May throw only std::bad_alloc, before anything is
// written.
void evaluate_points(const Spline &spline, const AxisRules &rules, int order, const ConstRecords &params,
                     const Records &out);

// The grid of all combinations: params[k] are those of axis k, out has one record per grid point, last axis
// fastest.
void evaluate_grid(const Spline &spline, const AxisRules &rules, int order,
                   const std::array<ConstRecords, max_axes> &params, const Records &out);

} // namespace nrb::eval
