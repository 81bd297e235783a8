// SPDX-License-Identifier: MIT
// Evaluation of points and partial derivatives, of lists of parameters and on grids, into the caller's
// arrays.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// Evaluates a list of parameters. A record of `out` is [slots][dim] with slots = slot_count(axes, order);
// order 0 gives points. Preconditions: all parameters have passed check_parameters(), and the strided views
// do not overlap. All memory that the results need is allocated before anything is written. Afterwards the
// tables for single points may be made (see keep_single_tables()).
void evaluate_points(const Spline &spline, const AxisRules &rules, int order, const ConstRecords &params,
                     const Records &out);

// Evaluates the grid of all combinations of parameters: params[k] are the parameters of axis k, and `out` has
// one record for each grid point, last axis fastest.
void evaluate_grid(const Spline &spline, const AxisRules &rules, int order,
                   const std::array<ConstRecords, max_axes> &params, const Records &out);

} // namespace nrb::eval
