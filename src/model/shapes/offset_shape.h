// SPDX-License-Identifier: MIT
// Offset surfaces that are known surfaces again.
#pragma once

#include "model/shapes/surface_shape.h"

namespace nrb::model {

// The surface at a distance along the normal S_u x S_v, over the same parameters and exact but for rounding: of planes, cylinders,
// cones, spheres, tori, extrusions of lines and of circles along their axis, and of offsets and parts of these. Null for others, and
// where a radius would vanish or change its sign.
SurfaceShapePtr known_offset(const SurfaceShapePtr &basis, double distance);

} // namespace nrb::model
