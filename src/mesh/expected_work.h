// SPDX-License-Identifier: MIT
// What a mesh of a model takes, told from coarse cells and edges before it is made.
#pragma once

#include "mesh/mesh.h"

#include <vector>

namespace nrb::mesh {

struct ExpectedWork {
    // That of the rule, or a larger distance for which the work that is left is expected to last, where it would be exceeded: else
    // the borders of faces, which come first, leave too little for what is between them.
    double chord;
    std::vector<double> faces{}; // multiply-adds, roughly; empty: nobody needs to know
};

// Of a model whose largest face has a size of `extent`. Cost: a few hundredths of the mesh where work is limited, nothing for coarse
// meshes.
ExpectedWork expected_work(const model::Model &model, const MeshRule &rule, double extent);

} // namespace nrb::mesh
