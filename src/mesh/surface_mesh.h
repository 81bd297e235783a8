// SPDX-License-Identifier: MIT
// Meshes of whole surfaces and of models.
#pragma once

#include "mesh/domain_mesh.h"

namespace nrb::mesh {

// Precondition: a surface of dimension 2 or 3.
MeshPtr mesh_of(const Spline &surface, const MeshRule &rule);
// In the coordinates of their parts.
MeshPtr mesh_of(const model::Model &model, const MeshRule &rule);

} // namespace nrb::mesh
