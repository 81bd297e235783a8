// SPDX-License-Identifier: MIT
// Nearest points of elementary surfaces, in closed form.
#pragma once

#include "face/nearest_place.h"
#include "model/shapes/surface_shape.h"

namespace nrb::model {

// For the spline that surface_spline() made of a cylinder, a cone, a sphere or a torus that does not meet itself; empty for other
// surfaces. Where the nearest point of the whole surface is not on the spline, the parameters are those of an end of its domain.
face::NearestPlace nearest_place(const SurfaceShape &surface, const SplinePtr &spline);

} // namespace nrb::model
