// SPDX-License-Identifier: MIT
// Evaluation of points into arrays of floats.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// The same as evaluate_points() and evaluate_grid() at order 0, with every coordinate computed in double
// precision and then rounded once, to the nearest float. All memory that the results need is allocated before
// anything is written.
void evaluate_points(const Spline &spline, const AxisRules &rules, ConstRecords params, FloatRecords points);
void evaluate_grid(const Spline &spline, const AxisRules &rules,
                   const std::array<ConstRecords, max_axes> &params, FloatRecords points);

} // namespace nrb::eval
