// SPDX-License-Identifier: MIT
// A spline from which the fit of a cloud can start.
#pragma once

#include "fit/cloud/cloud.h"
#include "spline/spline.h"

namespace nrb::fit {

// A start by principal component analysis. It is linear on each axis along one of the principal directions of
// the points, the first ones first, as far as the points extend. A closed curve is the ellipse with the
// variances of the points in the plane of the first two directions. A surface that is closed along one axis
// is an elliptic cylinder around that of the first three directions about which the points vary least from
// such a cylinder. Throws Status::flags for other periodic axes, about which the directions say nothing. In
// the units of the caller.
SplinePtr cloud_start(const Cloud &cloud, const Spline::Axes &axes);

} // namespace nrb::fit
