// SPDX-License-Identifier: MIT
// Reverse-mode gradients (adjoints) of the length of a curve.
#pragma once

#include "base/records.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::measure {

// dL/dP_i and dL/dw_i for every stored control point, and an estimate of their error: the larger of that of
// the points, relative to the longest dL/dP_i, and that of the weights, relative to L / w_i.
struct LengthGradient {
    std::vector<double> points;  // [count][dim]
    std::vector<double> weights; // [count], or empty if they are not wanted
    double error = 0;
};

// dL = integral of <T, dC'>, where T is the unit tangent. Where the curve stands still, T counts as 0.
// weights: whether dL/dw_i are wanted, too; those of a control point at infinity are infinite. Throws
// Status::not_converged, not_representable. Precondition: a curve, with the range inside its domain.
LengthGradient length_gradient(const Spline &curve, Interval range, double relative_tolerance, bool weights);

} // namespace nrb::measure
