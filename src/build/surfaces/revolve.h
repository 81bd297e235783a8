// SPDX-License-Identifier: MIT
// Shapes of revolution of any spline.
#pragma once

#include "build/placement.h"
#include "spline/spline.h"

#include <cstdint>

namespace nrb::build {

// The spline turned about the line through a point, null: the origin, in a direction, null: (0, 0, 1). The
// angle from 0 to `sweep` becomes axis 0, an arc in one of the arc_ forms with control points (x_j,
// y_j) and weights w_j: control point P of weight w, at d from its foot on the axis, gives those of foot +
// x_j d + y_j (Z x d) with weights w w_j (Piegl & Tiller 8.5), each coordinate of which is rounded once, from
// twice the precision. At the angle 0, and again after a full turn, it is P bit for bit. Throws
// Status::axes, dimension, point_not_finite, direction, angle, form, overflow, not_representable.
SplinePtr revolve(const Spline &spline, const double *point, const double *axis, double sweep, int32_t form);

} // namespace nrb::build
