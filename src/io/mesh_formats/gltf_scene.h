// SPDX-License-Identifier: MIT
// A mesh in glTF 2.0: its faces as primitives, the layout of the binary buffer, and the JSON text.
#pragma once

#include "io/mesh_formats/placed_mesh.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace nrb::io {

// The faces of a part that have one colour, which glTF draws at once.
struct Primitive {
    std::vector<const MeshFace *> faces;
    int64_t material = 0;
    int64_t first_vertex = 0, vertices = 0; // among those of all primitives
    int64_t first_index = 0, indices = 0;
    std::array<float, 3> least{}, most{}; // bounds of coordinates
};

// The meshes of the parts: each once, however often its part is placed.
struct GltfScene {
    std::vector<std::vector<Primitive>> parts; // for each part of the mesh; empty without triangles
    std::vector<std::optional<std::array<double, 3>>> materials; // one for each colour
    int64_t vertices = 0, indices = 0;
};

// Throws Status::not_representable for coordinates that overflow in single precision.
GltfScene gltf_scene(const PlacedMesh &mesh);

// Sizes of the elements in the views of the buffer: points, then normals, which are vectors, and then
// indices.
inline constexpr int64_t bytes_of_vector = 12, bytes_of_index = 4;

// `metres`: the unit of the points in metres. Throws Status::matrix for a placement that is not a similarity,
// not_representable if one overflows.
std::string gltf_text(const PlacedMesh &mesh, const GltfScene &scene, double metres);

} // namespace nrb::io
