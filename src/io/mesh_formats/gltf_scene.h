// SPDX-License-Identifier: MIT
// A mesh as glTF 2.0 describes it: the JSON text, and what of the mesh the buffer behind it holds.
#pragma once

#include "io/mesh_formats/placed_mesh.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace nrb::io {

// Faces of a part with one colour: what glTF draws at once.
struct Primitive {
    std::vector<const MeshFace *> faces;
    int64_t material = 0;
    int64_t first_vertex = 0, vertices = 0; // among those of all primitives
    int64_t first_index = 0, indices = 0;
    std::array<float, 3> least{}, most{}; // of coordinates
};

// The meshes of parts, once for all places where these stand.
struct GltfScene {
    std::vector<std::vector<Primitive>> parts; // of the mesh; those without triangles are empty
    std::vector<std::optional<std::array<double, 3>>> materials; // each of one colour
    int64_t vertices = 0, indices = 0;
};

// Throws Status::not_representable for coordinates that overflow in single precision.
GltfScene gltf_scene(const PlacedMesh &mesh);

// Sizes of the views of the buffer: points, then normals, then indices.
inline constexpr int64_t bytes_of_vector = 12, bytes_of_index = 4;

// `metres`: of the unit of the points. Throws Status::matrix for placements that are no similarities.
std::string gltf_text(const PlacedMesh &mesh, const GltfScene &scene, double metres);

} // namespace nrb::io
