// SPDX-License-Identifier: MIT
// The intersection curves of two models.
#pragma once

#include "intersect/levels/level_meet.h"
#include "model/model.h"

namespace nrb::model {

// Intersects all instances of the faces of one model with those of the other, as faces that share no edge.
// Branches run along n_b x n_a with the outer normals n, and are joined across the edges that faces share.
// tolerance > 0, in the whole. Throws what instances_of() and Placement() throw. Precondition: surfaces in
// space.
intersect::Meet model_intersections(const Model &a, const Model &b, double tolerance);

} // namespace nrb::model
