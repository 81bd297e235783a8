// SPDX-License-Identifier: MIT
// Offset surfaces that are known surfaces again.
#pragma once

#include "model/shapes/surface_shape.h"

namespace nrb::model {

// The surface at a distance along the normal S_u x S_v, over the same parameters and exact but for rounding: of planes, cylinders,
// cones, spheres, tori, extrusions of lines and of circles along their axis, and of offsets and parts of these. A cylinder beyond its
// axis starts at its other side, a sphere beyond its centre is a part whose v runs backwards. An offset of an offset goes along the
// normal of that: where it is turned around, by the difference of both distances. Null for others, where a radius would vanish or, of
// cones and tori, change its sign, and where the normal of an offset is not on one side.
SurfaceShapePtr known_offset(const SurfaceShapePtr &basis, double distance);

} // namespace nrb::model
