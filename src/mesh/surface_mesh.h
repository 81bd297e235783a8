// SPDX-License-Identifier: MIT
// A whole surface as triangles.
#pragma once

#include "base/numbers.h"
#include "mesh/mesh.h"

namespace nrb::mesh {

struct MeshRule {
    double chord = infinity; // the largest distance, both ways
};

// Precondition: a surface of dimension 2 or 3.
MeshPtr mesh_of(const Spline &surface, const MeshRule &rule);

} // namespace nrb::mesh
