// SPDX-License-Identifier: MIT
// Models of faces.
#pragma once

#include "model/model.h"

namespace nrb::model {

// One part and one use of it. Coedges with the same key share an edge, if their edges are no farther from each other than the
// tolerances of their faces add up to, else a note tells; others have edges of their own, made where none was given.
// Vertices are the ends of edges, one where they are equal bit for bit. Throws what face::edge_of() does. Precondition: surfaces of
// dimension 3.
Model model_of_faces(const std::vector<face::FacePtr> &faces, double metres_per_unit);

// Fills the uses of edges from the keys of coedges, of which k is edge k - 1. Precondition: they are those of the model.
void index_uses(Model &model);

} // namespace nrb::model
