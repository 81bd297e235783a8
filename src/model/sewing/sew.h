// SPDX-License-Identifier: MIT
// Models of patches without topology.
#pragma once

#include "model/model.h"

namespace nrb::model {

// One part and one use of it, of faces in their order. Pieces of their sides are one edge where they are proven to be within the
// tolerance of each other, both ways; its curve is one of them, which the others are off as coedges may be. Sides are cut where
// others begin or end. What is no larger than the tolerance is left out of loops. Faces at edges of two uses are seen as the first
// of those that hang together is. Throws Status::same for a patch that is given twice, and what Face() and edge_over() do, with
// the number of the face. Precondition: surfaces of dimension 3, tolerance > 0.
Model sew(const std::vector<face::FacePtr> &faces, double tolerance, double metres_per_unit);

} // namespace nrb::model
