// SPDX-License-Identifier: MIT
// Where two models meet.
#pragma once

#include "intersect/levels/level_meet.h"
#include "model/model.h"

namespace nrb::model {

// All instances of faces of the one with those of the other, which do not know each other; branches run along n_b x n_a with the
// outer normals n and are joined over edges that faces share. tolerance > 0, in the whole. Throws what instances_of() and Placement()
// do. Precondition: surfaces in space.
intersect::Meet model_intersections(const Model &a, const Model &b, double tolerance);

} // namespace nrb::model
