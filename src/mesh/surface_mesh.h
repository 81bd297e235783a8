// SPDX-License-Identifier: MIT
// Meshes of whole surfaces and of models.
#pragma once

#include "mesh/domain/domain_mesh.h"

namespace nrb::mesh {

// Throws Status::dimension for a surface of another dimension than 2 or 3, axes for what is none, overflow for more than 2^31 - 1
// vertices.
MeshPtr mesh_of(const Spline &surface, const MeshRule &rule);
MeshPtr mesh_of(const face::FacePtr &face, const MeshRule &rule);
MeshPtr mesh_of(const model::Model &model, const MeshRule &rule);

} // namespace nrb::mesh
