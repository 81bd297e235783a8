// SPDX-License-Identifier: MIT
// Multilinear patches, which are straight along every axis.
#pragma once

#include "base/records.h"
#include "spline/spline.h"

namespace nrb::build {

// The patch of degree 1 on all axes over 2^axes corners, last axis fastest. Throws
// Status::point_not_finite.
SplinePtr multilinear(int axes, const ConstRecords &corners);

// The parallelogram origin + s u + t v, whose corners are rounded once; a null origin is 0. Throws
// Status::dimension, point_not_finite, not_representable, and direction for a side that is 0 or not finite,
// or for sides with an angle whose sine is at most 4 eps.
SplinePtr parallelogram(int dim, const double *origin, const double *u, const double *v);

} // namespace nrb::build
