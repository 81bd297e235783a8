// SPDX-License-Identifier: MIT
// Changes of the weights that keep the shape: normalization, and rational linear reparametrization.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// Whether all weights are equal.
bool equal_weights(const Spline &spline) noexcept;

// Whether two splines have the same form and equal weights. Precondition: they have equally many control
// points.
bool same_weights(const Spline &a, const Spline &b) noexcept;

// Divides all weights by the weight of largest magnitude. If all weights are equal, the result is polynomial.
// Throws what make_result() throws.
SplinePtr normalize_weights(const SplinePtr &spline);

// The axis in the parameter u with (u - a) / (b - u) = (t - a) / (rho (b - t)), on the domain [a, b], where
// rho = ratio^(1/p). Homogeneous control point i is multiplied by the product of rho (b - a) / (rho (b - t) +
// t - a) over its knots t = t_(i+1), ..., t_(i+p). Each factor is the value of a linear function, by whose
// p-th power the polar forms in t and in u differ (Piegl & Tiller 6.4; Lee & Lucian 1991). Throws
// Status::factor, degree (at degree 0), periodic, knots_merge, not_representable.
SplinePtr reparametrize_moebius(const SplinePtr &spline, int axis, double ratio);

// The same with the ratio for which the weights at both ends of the domain become equal. Throws
// Status::end_weights if there is no such ratio.
SplinePtr equalize_end_weights(const SplinePtr &spline, int axis);

} // namespace nrb::refine
