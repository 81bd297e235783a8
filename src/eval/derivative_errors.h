// Bounds of the rounding errors of derivatives that hold everywhere on a spline: the cheap first test that
// spares nearly every point the evaluation of its own bounds.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// Bounds of the lengths of the errors, each at least that of Jet for the same derivative.
struct DerivativeErrors {
    double u = 0;
    double v = 0;
    double uu = 0;
    double uv = 0;
    double vv = 0;
};

// For a curve or a surface, evaluated at `points` parameters. Infinite where no bound holds everywhere
// (extrapolation, weights that are not positive), and where reading all control points would cost more than
// it can spare. Throws only if a table has to be built.
DerivativeErrors derivative_errors(const Spline &spline, const AxisRules &rules, int64_t points);

} // namespace nrb::eval
