// SPDX-License-Identifier: MIT
// Foot points on elementary surfaces in closed form.
#pragma once

#include "face/nearest_place.h"
#include "model/shapes/surface_shape.h"

namespace nrb::model {

// The function for the spline that surface_spline() made of a cylinder, a cone, a sphere or a torus without
// self-intersections; empty for other surfaces. Where the foot point on the whole surface is not on the
// spline, parameters are clamped to the ends of its domain.
face::NearestPlace nearest_place(const SurfaceShape &surface, const SplinePtr &spline);

} // namespace nrb::model
