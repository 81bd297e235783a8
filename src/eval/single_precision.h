// SPDX-License-Identifier: MIT
// Points in single precision.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// The same as evaluate_points() and evaluate_grid() of order 0, with every coordinate computed in double
// precision and rounded once, to the nearest float. May throw only std::bad_alloc, before anything is
// written. A grid needs working memory for its points in double precision: its rows share what they contract,
// so that computing it in parts would cost a multiple of the time.
void evaluate_points(const Spline &spline, const AxisRules &rules, ConstRecords params, FloatRecords points);
void evaluate_grid(const Spline &spline, const AxisRules &rules,
                   const std::array<ConstRecords, max_axes> &params, FloatRecords points);

} // namespace nrb::eval
