// SPDX-License-Identifier: MIT
// Offsets of elementary surfaces that are elementary surfaces again.
#pragma once

#include "model/shapes/surface_shape.h"

namespace nrb::model {

// The surface at a distance along the normal S_u x S_v, over the same parameters and exact but for rounding.
// It is known for planes, cylinders, cones, spheres, tori, extrusions of lines, extrusions of circles along
// their axis, and for offsets and parts of these. A cylinder beyond its axis starts on the opposite side; a
// sphere beyond its centre is a trimmed surface whose v runs backwards. An offset of an offset goes along the
// normal of the first offset: where that is opposite to the normal of its basis, the total is the difference
// of both distances. Null for other surfaces, where a radius would vanish or, for cones and tori, become
// negative, and where the normal of an offset is not known to be on one side.
SurfaceShapePtr known_offset(const SurfaceShapePtr &basis, double distance);

} // namespace nrb::model
