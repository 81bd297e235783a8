// SPDX-License-Identifier: MIT
// A part raised along a direction.
#pragma once

#include "modify/deform/region.h"

namespace nrb::modify {

// See nurbs_warp(). The bump along an axis is the B-spline of degree order + 1 over order + 3 even knots of
// the range, divided by its value in the middle, where it is largest. Of all piecewise polynomials with that
// many continuous derivatives it has the least degree. It has a knot vector of its own over the domain of the
// spline, periodic if the axis is, and is added exactly (refine/algebra/sum.h): the degree becomes at least
// order + 1, and with weights the sum of both degrees. Throws what sum() throws, and Status::knots_merge if
// the range has too few doubles. Preconditions: the direction is not 0, order >= 0.
SplinePtr warp(const SplinePtr &spline, const Part &part, const double *direction, double distance,
               int order);

} // namespace nrb::modify
