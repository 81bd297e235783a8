// SPDX-License-Identifier: MIT
// Ruled and extruded shapes, which run straight from one spline to another.
#pragma once

#include "spline/spline.h"

namespace nrb::build {

// Throws Status::axes, naming the spline, if it has max_axes axes already.
void check_room_for_axis(const Spline &spline, const char *name);

// The spline (u, v) -> (1 - v) a(u) + v b(u) of homogeneous points; the new axis is the last one, of degree 1
// over [0, 1]. Control points and weights are those of a and b, in the form that can hold both. Throws
// Status::overflow. Preconditions: a and b have the same axes and dimension, and fewer than max_axes axes.
SplinePtr ruled_homogeneous(const SplinePtr &a, const SplinePtr &b);

// The shape that the spline sweeps along a vector of its dimension. Throws Status::axes, direction,
// not_representable, overflow.
SplinePtr extrude(const SplinePtr &spline, const double *vector);

// See nurbs_ruled(). For Cartesian rulings between splines with different weights, both are brought over the
// product of their denominators, as the sums 1 a + 0 b and 0 a + 1 b (refine/algebra/sum.h). Throws
// Status::axes, incompatible, dimension, and what make_compatible(), reparametrize() and sum() throw.
SplinePtr ruled(const SplinePtr &a, const SplinePtr &b, bool cartesian);

} // namespace nrb::build
