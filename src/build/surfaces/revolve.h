// SPDX-License-Identifier: MIT
// Surfaces and volumes of revolution, from any curve or surface.
#pragma once

#include "build/placement.h"
#include "spline/spline.h"

#include <cstdint>

namespace nrb::build {

// The spline turned about the line through a point (null: the origin) in a direction (null: (0, 0, 1)). The
// angle from 0 to `sweep` becomes axis 0, an arc in one of the arc_ forms with control points (x_j, y_j) and
// weights w_j. With Z the unit vector of the axis, a control point of weight w at the vector d from its foot
// on the axis gives the control points foot + x_j d + y_j (Z x d) with the weights w w_j (Piegl & Tiller
// 8.5). Each coordinate is rounded once, from double-double precision. At the angle 0, and again after a full
// turn, the control points are the given ones bit for bit. Throws Status::axes, dimension, point_not_finite,
// direction, angle, form, overflow, not_representable.
SplinePtr revolve(const Spline &spline, const double *point, const double *axis, double sweep, int32_t form);

} // namespace nrb::build
