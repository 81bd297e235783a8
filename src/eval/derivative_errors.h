// SPDX-License-Identifier: MIT
// Bounds of the rounding errors of derivatives that hold at every parameter of a spline. They serve as a
// cheap first test of whether a derivative, or a product of two, may vanish: nearly every point passes the
// test and needs no bounds of its own.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// Bounds of the Euclidean lengths of the errors of derivatives. Each is at least the bound that Jet computes
// for the same derivative at any parameter.
struct DerivativeErrors {
    double u = 0;
    double v = 0;
    double uu = 0;
    double uv = 0;
    double vv = 0;
};

// The bounds for a curve or a surface. `points`: the number of further parameters it is about to be evaluated
// at. All bounds are infinite if none holds everywhere (extrapolation, weights that are not all positive),
// and as long as the parameters evaluated so far have not paid for reading all control points. Once computed,
// the bounds are kept with the spline. Throws only if a table has to be built.
DerivativeErrors derivative_errors(const Spline &spline, const AxisRules &rules, int64_t points);

} // namespace nrb::eval
