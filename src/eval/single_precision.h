// Points in single precision.
#pragma once

#include "eval/parameters.h"

namespace nrb {

// As evaluate_points() and evaluate_grid() of order 0, every coordinate computed in double precision and
// rounded once, to the nearest float.
void evaluate_points(const Spline &spline, const AxisRules &rules, ConstRecords params, FloatRecords points);
void evaluate_grid(const Spline &spline, const AxisRules &rules,
                   const std::array<ConstRecords, max_axes> &params, FloatRecords points);

} // namespace nrb
