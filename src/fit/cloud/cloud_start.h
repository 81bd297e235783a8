// SPDX-License-Identifier: MIT
// A spline from which the fit of a cloud can begin.
#pragma once

#include "fit/cloud/cloud.h"
#include "spline/spline.h"

namespace nrb::fit {

// Linear on each axis along one of the principal directions of the points, the first ones first, as far as they reach; a
// closed curve is the ellipse of their variances in the plane of the first two. A surface that is closed along one axis is
// an elliptic cylinder around that of the first three directions from which the points are most evenly far. Throws
// Status::flags for other periodic axes, of which the directions tell nothing. In the units of the caller.
SplinePtr cloud_start(const Cloud &cloud, const Spline::Axes &axes);

} // namespace nrb::fit
