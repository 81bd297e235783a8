// SPDX-License-Identifier: MIT
// Bounds of the rounding errors of derivatives that hold everywhere on a spline. They are a cheap first test:
// nearly every point passes it and needs no bounds of its own.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// Bounds of the lengths of the errors, each at least the bound of Jet for the same derivative.
struct DerivativeErrors {
    double u = 0;
    double v = 0;
    double uu = 0;
    double uv = 0;
    double vv = 0;
};

// For a curve or a surface, evaluated at `points` parameters more. Infinite if no bound holds everywhere
// (extrapolation, weights that are not positive), or if all points so far have not paid for reading the
// control points. Then they are kept with the spline. Throws only if a table has to be built.
DerivativeErrors derivative_errors(const Spline &spline, const AxisRules &rules, int64_t points);

} // namespace nrb::eval
