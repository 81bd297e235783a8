// SPDX-License-Identifier: MIT
// Meshes as files. Sources refer to the mesh; what is wrong with it for a format is thrown at once, not while they write.
#pragma once

#include "io/mesh_formats/blocks.h"
#include "io/mesh_formats/placed_mesh.h"
#include "io/write_settings.h"

#include <cstdint>

namespace nrb::io {

enum class MeshFormat : int32_t { stl = 3, stl_text = 4, obj = 5, ply = 6, glb = 7, vtu = 8 };

// A mesh as a file of a format. Throws Status::format for other numbers than those of formats, options for settings that are
// negative or not finite, count for a mesh without triangles, too_large, matrix, not_representable.
ByteSource mesh_source(const Mesh &mesh, int32_t format, const WriteSettings &settings);

// Triangles of which two corners are one point in single precision are left out; the others are as closed as before. Throws
// Status::not_representable if a coordinate overflows, or none is left.
ByteSource stl_source(const PlacedMeshPtr &mesh);
ByteSource stl_text_source(const PlacedMeshPtr &mesh);
// Points of a part are common to its faces; normals are not.
ByteSource obj_source(const PlacedMeshPtr &mesh);
ByteSource ply_source(const PlacedMeshPtr &mesh);
ByteSource vtu_source(const PlacedMeshPtr &mesh);
// Parts with their uses: nodes, of which the whole turns z upwards into y upwards and the unit of the numbers, in metres, into
// metres. Throws Status::matrix for placements that are no similarities, not_representable, too_large.
ByteSource glb_source(const PlacedMeshPtr &mesh, double metres);

} // namespace nrb::io
