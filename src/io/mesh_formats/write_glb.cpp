// SPDX-License-Identifier: MIT
#include "io/mesh_formats/gltf_scene.h"
#include "io/mesh_formats/single.h"
#include "io/mesh_formats/write_meshes.h"

#include <utility>

namespace nrb::io {

namespace {

// A file has a header, a chunk of JSON, and a chunk of bytes.
constexpr uint32_t glb_magic = 0x46546C67, glb_version = 2, json_chunk = 0x4E4F534A, bytes_chunk = 0x004E4942;
constexpr int64_t head_size = 12, chunk_head_size = 8, chunk_unit = 4;

struct GlbFile {
    PlacedMeshPtr mesh;
    GltfScene scene;
    std::string json; // padded to a multiple of chunk_unit

    [[nodiscard]] int64_t buffer_size() const noexcept {
        return 2 * bytes_of_vector * scene.vertices + bytes_of_index * scene.indices;
    }
    [[nodiscard]] int64_t size() const noexcept {
        return head_size + 2 * chunk_head_size + std::ssize(json) + buffer_size();
    }
};

// Calls f(face, first) for the faces in the order of the buffer. `first`: the number of the first vertex of
// the face in its primitive.
template <class F>
void each_scene_face(const GltfScene &scene, F &&f) {
    for (const std::vector<Primitive> &part : scene.parts) {
        for (const Primitive &primitive : part) {
            int64_t first = 0;
            for (const MeshFace *face : primitive.faces) {
                f(*face, first);
                first += static_cast<int64_t>(face->vertices);
            }
        }
    }
}

void write_vector(const Vector3 &x, Blocks &out) {
    const Single3 rounded = single(x);
    out.bytes(rounded[0], rounded[1], rounded[2]);
}

void write_buffer(const GlbFile &file, Blocks &out) {
    const Mesh &mesh = file.mesh->mesh();
    each_scene_face(file.scene, [&](const MeshFace &face, int64_t) {
        for (size_t i = 0; i < face.vertices; ++i) {
            const auto point = static_cast<size_t>(mesh.vertices[face.first_vertex + i].point);
            write_vector(file.mesh->factor() * mesh.points[point], out);
        }
    });
    each_scene_face(file.scene, [&](const MeshFace &face, int64_t) {
        for (size_t i = 0; i < face.vertices; ++i) {
            write_vector(file.mesh->normals().at(face, face.first_vertex + i), out);
        }
    });
    each_scene_face(file.scene, [&](const MeshFace &face, int64_t first) {
        for (size_t i = 0; i < face.triangles; ++i) {
            for (const size_t corner : outer_corners(mesh, face, i, false)) {
                out.bytes(static_cast<uint32_t>(static_cast<int64_t>(corner - face.first_vertex) + first));
            }
        }
    });
}

void write_glb(const GlbFile &file, Blocks &out) {
    out.bytes(glb_magic, glb_version, static_cast<uint32_t>(file.size()));
    out.bytes(static_cast<uint32_t>(file.json.size()), json_chunk);
    out.text(file.json);
    out.bytes(static_cast<uint32_t>(file.buffer_size()), bytes_chunk);
    write_buffer(file, out);
}

} // namespace

ByteSource glb_source(const PlacedMeshPtr &mesh, double metres) {
    GlbFile file{mesh, gltf_scene(*mesh), {}};
    file.json = gltf_text(*mesh, file.scene, metres);
    file.json.resize((file.json.size() + chunk_unit - 1) / chunk_unit * chunk_unit, ' ');
    if (!std::in_range<uint32_t>(file.size())) {
        fail(Status::too_large, "%lld bytes, expected less than 2^32", static_cast<long long>(file.size()));
    }
    const auto kept = std::make_shared<const GlbFile>(std::move(file));
    return source_of([kept](Blocks &out) { write_glb(*kept, out); });
}

} // namespace nrb::io
