// SPDX-License-Identifier: MIT
// Meshes as files. A source refers to the mesh, which must outlive it. Errors for what a format cannot hold
// are thrown when the source is made, not while it writes.
#pragma once

#include "io/mesh_formats/blocks.h"
#include "io/mesh_formats/placed_mesh.h"
#include "io/write_settings.h"

#include <cstdint>

namespace nrb::io {

enum class MeshFormat : int32_t { stl = 3, stl_text = 4, obj = 5, ply = 6, glb = 7, vtu = 8 };

// A mesh as a file in a format. Throws Status::format for a number that is not that of a mesh format, options
// for a unit that cannot be reached from that of the mesh, count for a mesh without triangles, too_large,
// matrix, not_representable. Precondition: the settings are not negative.
ByteSource mesh_source(const Mesh &mesh, int32_t format, const WriteSettings &settings);

// Triangles with two corners that are equal in single precision are left out, which opens no gaps between the
// others. Throws Status::not_representable if a coordinate overflows, or if no triangle is left.
ByteSource stl_source(const PlacedMeshPtr &mesh);
ByteSource stl_text_source(const PlacedMeshPtr &mesh);
// The faces of a part share its points, but each has normals of its own.
ByteSource obj_source(const PlacedMeshPtr &mesh);
ByteSource ply_source(const PlacedMeshPtr &mesh);
ByteSource vtu_source(const PlacedMeshPtr &mesh);
// Parts and their uses become meshes and nodes. The root node turns z upwards into y upwards, and converts
// the unit of the numbers, which is `metres` metres, to metres. Throws Status::matrix for a placement that is
// not a similarity, not_representable, too_large.
ByteSource glb_source(const PlacedMeshPtr &mesh, double metres);

} // namespace nrb::io
