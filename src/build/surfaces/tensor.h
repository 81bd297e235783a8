// SPDX-License-Identifier: MIT
// Tensor products of two splines: surfaces and volumes over the axes of both.
#pragma once

#include "spline/spline.h"

namespace nrb::build {

// Control point (i, j) is a function of control point i of a and control point j of b. The axes of b follow
// those of a, and weights are multiplied. If a and b have Cartesian control points, so has the result, and
// each is accurate to 3 eps / 2 times the sum of the magnitudes of its terms. All functions throw
// Status::axes, dimension, overflow, not_representable, weights_vanish. Cost: linear in the points of the
// result.

// alpha a(u) + beta b(v). Precondition: alpha and beta are finite.
SplinePtr tensor_sum(const Spline &a, double alpha, const Spline &b, double beta);

// a(u) b(v), component by component; a spline of dimension 1 multiplies all components of the other one.
SplinePtr tensor_product(const Spline &a, const Spline &b);

// The swung surface (scale r(v) x(u), scale r(v) y(u), z(v)) of the curves (x, y) and (r, z). Throws
// Status::factor.
SplinePtr swung(const Spline &trajectory, const Spline &profile, double scale);

} // namespace nrb::build
