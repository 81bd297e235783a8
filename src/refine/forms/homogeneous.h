// SPDX-License-Identifier: MIT
// Conversions between a rational spline and the polynomial spline of its homogeneous points.
#pragma once

#include "spline/spline.h"

#include <span>

namespace nrb::refine {

// (w x, w y, ..., w) of every control point, unscaled; w = 1 in a polynomial spline.
std::vector<double> homogeneous_points(const Spline &spline);

// The Cartesian control points. A coordinate is not finite if a homogeneous point is at infinity, or if the
// division overflows.
std::vector<double> cartesian_points(const Spline &spline);

// A polynomial spline becomes rational with weights of 1; any other is returned unchanged.
SplinePtr make_rational(const SplinePtr &spline);

// The form that can represent all of the splines: the last one in the order of Form.
Form common_form(std::span<const SplinePtr> splines) noexcept;
// The same spline in the given form, which must be able to represent it. Throws Status::overflow,
// not_representable.
SplinePtr in_form(const SplinePtr &spline, Form form);

// The polynomial spline of the homogeneous points. Throws Status::dimension, overflow.
SplinePtr to_homogeneous(const Spline &spline);

// The rational spline whose homogeneous points are the points of a polynomial spline. Throws
// Status::rational, dimension, weights_vanish.
SplinePtr from_homogeneous(const Spline &spline);

} // namespace nrb::refine
