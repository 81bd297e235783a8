// SPDX-License-Identifier: MIT
// Estimates the work of meshing a model, from coarse cells and edges, before the mesh is made.
#pragma once

#include "mesh/mesh.h"

#include <vector>

namespace nrb::mesh {

struct ExpectedWork {
    // The chord error to mesh for: that of the rule or, if it would take more work than is left, a larger one
    // that is expected to fit. With that of the rule, the borders of faces, which come first, would then
    // leave too little work for the interiors.
    double chord;
    std::vector<double> faces{}; // of each face, in multiply-adds, roughly; empty: not needed
};

// `extent`: the longest side of the box of all control points of the model. Cost: a few hundredths of that of
// the mesh where work is limited; nothing for coarse meshes.
ExpectedWork expected_work(const model::Model &model, const MeshRule &rule, double extent);

} // namespace nrb::mesh
