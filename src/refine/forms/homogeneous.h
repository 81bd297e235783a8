// SPDX-License-Identifier: MIT
// Conversions between a rational spline and the polynomial spline of its homogeneous points.
#pragma once

#include "spline/spline.h"

#include <span>

namespace nrb::refine {

// (w x, w y, ..., w) of every control point, unscaled; w = 1 in a polynomial spline.
std::vector<double> homogeneous_points(const Spline &spline);

// The Cartesian places of the control points; not finite if a homogeneous point has no such place or
// overflows.
std::vector<double> cartesian_points(const Spline &spline);

// A polynomial spline with weights of 1; any other spline unchanged.
SplinePtr make_rational(const SplinePtr &spline);

// The form that can hold all of them: the last in the order of Form.
Form common_form(std::span<const SplinePtr> splines) noexcept;
// The same spline in a form that can hold it. Throws Status::overflow, not_representable.
SplinePtr in_form(const SplinePtr &spline, Form form);

// Throws Status::dimension, overflow.
SplinePtr to_homogeneous(const Spline &spline);

// Throws Status::rational, dimension, weights_vanish.
SplinePtr from_homogeneous(const Spline &spline);

} // namespace nrb::refine
