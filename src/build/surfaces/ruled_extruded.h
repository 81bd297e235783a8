// SPDX-License-Identifier: MIT
// Splines between two splines: what extruded and ruled shapes are.
#pragma once

#include "spline/spline.h"

namespace nrb::build {

// Throws Status::axes, naming the spline, for one of max_axes axes.
void check_room_for_axis(const Spline &spline, const char *name);

// (u, v) -> (1 - v) a(u) + v b(u) of homogeneous points, the new axis last, of degree 1 over [0, 1]. Control
// points and weights are those of a and b, in the form that holds both. Throws Status::overflow.
// Preconditions: the same axes and dimension; fewer than max_axes axes.
SplinePtr ruled_homogeneous(const SplinePtr &a, const SplinePtr &b);

// The spline moved along a vector of its dimension. Throws Status::axes, direction, not_representable,
// overflow.
SplinePtr extrude(const SplinePtr &spline, const double *vector);

// See nurbs_ruled(). Cartesian rulings of splines whose weights differ are the sums 1 a + 0 b and 0 a + 1 b
// over the product of the denominators (refine/algebra/sum.h). Throws Status::axes, incompatible, dimension,
// and what make_compatible(), reparametrize() and sum() throw.
SplinePtr ruled(const SplinePtr &a, const SplinePtr &b, bool cartesian);

} // namespace nrb::build
