// SPDX-License-Identifier: MIT
// Makes models from faces alone.
#pragma once

#include "model/model.h"

namespace nrb::model {

// A model with one part and one use of it. Coedges with the same key share an edge, unless their edges are
// farther apart than the sum of the tolerances of their faces: then each has its own edge, and a note says
// so. Coedges without a key have edges of their own. Edges in space are made where none was given. Vertices
// are the ends of edges; ends that are equal bit for bit are one vertex. Throws what face::edge_of() throws.
// Precondition: surfaces of dimension 3.
Model model_of_faces(const std::vector<face::FacePtr> &faces, double metres_per_unit);

// Sets the uses of edges from the keys of coedges: the key k > 0 stands for edge k - 1. Precondition: every
// key is that of an edge of the model.
void index_uses(Model &model);

} // namespace nrb::model
