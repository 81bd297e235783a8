// SPDX-License-Identifier: MIT
// Meshes of whole surfaces, of faces and of models.
#pragma once

#include "mesh/domain/domain_mesh.h"

#include <span>

namespace nrb::mesh {

// Throws Status::axes for a spline that is not a surface, dimension for a surface in another dimension than 2
// or 3, overflow if a face has more points between its border and the cells inside than
// TriangleNet::most_vertices.
MeshPtr mesh_of(const Spline &surface, const MeshRule &rule);
MeshPtr mesh_of(const face::FacePtr &face, const MeshRule &rule);
MeshPtr mesh_of(const model::Model &model, const MeshRule &rule);

// Levels of detail: chord errors, each of which replaces that of a rule, and the work that each mesh may take
// where the caller sets no limit.
struct Levels {
    std::span<const double> chords;
    int64_t usual_work;
};

// One mesh for each chord, bit for bit the same as if it were made alone. At its usual limit of work each
// mesh ends with what there is by then.
std::vector<MeshPtr> meshes_of(const Spline &surface, const MeshRule &rule, const Levels &levels);
std::vector<MeshPtr> meshes_of(const face::FacePtr &face, const MeshRule &rule, const Levels &levels);
std::vector<MeshPtr> meshes_of(const model::Model &model, const MeshRule &rule, const Levels &levels);

} // namespace nrb::mesh
