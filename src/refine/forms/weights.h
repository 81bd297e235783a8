// SPDX-License-Identifier: MIT
// Changes of the weights that keep the shape.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// Whether all weights are equal.
bool equal_weights(const Spline &spline) noexcept;

// Whether two splines with equally many control points have the same form and weights.
bool same_weights(const Spline &a, const Spline &b) noexcept;

// All weights divided by the weight of largest magnitude; equal weights are dropped. Throws what
// make_result() throws.
SplinePtr normalize_weights(const SplinePtr &spline);

// The axis in the parameter u with (u - a) / (b - u) = (t - a) / (rho (b - t)) on the domain [a, b], rho =
// ratio^(1/p): homogeneous control point i is multiplied by the product over its knots t_(i+1), ..., t_(i+p)
// of rho (b - a) / (rho (b - t) + t - a), the value of a linear factor whose p-th power makes the polar form
// of a spline in u from that in t (Piegl & Tiller 6.4; Lee & Lucian 1991). Throws Status::factor, degree
// (degree 0), periodic, knots_merge, not_representable.
SplinePtr reparametrize_moebius(const SplinePtr &spline, int axis, double ratio);

// The same with the ratio that makes the weights at the two ends of the domain equal. Throws
// Status::end_weights if no ratio does.
SplinePtr equalize_end_weights(const SplinePtr &spline, int axis);

} // namespace nrb::refine
