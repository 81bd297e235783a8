// SPDX-License-Identifier: MIT
// Meshes of whole surfaces and of models.
#pragma once

#include "mesh/domain/domain_mesh.h"

#include <span>

namespace nrb::mesh {

// Throws Status::dimension for a surface of another dimension than 2 or 3, axes for what is none, overflow for more than 2^31 - 1
// vertices.
MeshPtr mesh_of(const Spline &surface, const MeshRule &rule);
MeshPtr mesh_of(const face::FacePtr &face, const MeshRule &rule);
MeshPtr mesh_of(const model::Model &model, const MeshRule &rule);

// Distances that take the place of that of a rule, and how much work each mesh may take where the caller sets no limit.
struct Levels {
    std::span<const double> chords;
    int64_t usual_work;
};

// A mesh for each distance, the same, bit for bit, as by itself. Each ends at its usual limit with what there is by then.
std::vector<MeshPtr> meshes_of(const Spline &surface, const MeshRule &rule, const Levels &levels);
std::vector<MeshPtr> meshes_of(const face::FacePtr &face, const MeshRule &rule, const Levels &levels);
std::vector<MeshPtr> meshes_of(const model::Model &model, const MeshRule &rule, const Levels &levels);

} // namespace nrb::mesh
