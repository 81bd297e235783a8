// SPDX-License-Identifier: MIT
#include "io/mesh_formats/gltf_scene.h"

#include "io/mesh_formats/single.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace nrb::io {

namespace {

using Colour = std::optional<std::array<double, 3>>;

void add_bounds(const PlacedMesh &mesh, const MeshFace &face, Primitive &primitive) {
    const Mesh &own = mesh.mesh();
    for (size_t i = 0; i < face.vertices; ++i) {
        const auto point = static_cast<size_t>(own.vertices[face.first_vertex + i].point);
        const Single3 x = checked_single(mesh.factor() * own.points[point]);
        for (size_t k = 0; k < 3; ++k) {
            primitive.least[k] = std::min(primitive.least[k], x[k]);
            primitive.most[k] = std::max(primitive.most[k], x[k]);
        }
    }
}

class SceneMaker {
public:
    explicit SceneMaker(const PlacedMesh &mesh) : mesh_(mesh) {}

    GltfScene scene() {
        scene_.parts.resize(mesh_.mesh().parts.size());
        for (size_t part = 0; part < scene_.parts.size(); ++part) {
            for (const MeshFace *face : mesh_.faces_of(static_cast<int64_t>(part))) {
                if (face->triangles > 0) {
                    add(scene_.parts[part], *face);
                }
            }
            place(scene_.parts[part]);
        }
        return std::move(scene_);
    }

private:
    void add(std::vector<Primitive> &part, const MeshFace &face) {
        const int64_t material = material_of(face.colour);
        auto found = std::ranges::find(part, material, &Primitive::material);
        if (found == part.end()) {
            part.push_back({{}, material});
            found = part.end() - 1;
            found->least.fill(std::numeric_limits<float>::infinity());
            found->most.fill(-std::numeric_limits<float>::infinity());
        }
        found->faces.push_back(&face);
        found->vertices += static_cast<int64_t>(face.vertices);
        found->indices += static_cast<int64_t>(3 * face.triangles);
        add_bounds(mesh_, face, *found);
    }

    void place(std::vector<Primitive> &part) {
        for (Primitive &primitive : part) {
            primitive.first_vertex = scene_.vertices;
            primitive.first_index = scene_.indices;
            scene_.vertices += primitive.vertices;
            scene_.indices += primitive.indices;
        }
    }

    int64_t material_of(const Colour &colour) {
        const auto [at, is_new] = materials_.try_emplace(colour, std::ssize(scene_.materials));
        if (is_new) {
            scene_.materials.push_back(colour);
        }
        return at->second;
    }

    const PlacedMesh &mesh_;
    GltfScene scene_;
    std::map<Colour, int64_t> materials_;
};

} // namespace

GltfScene gltf_scene(const PlacedMesh &mesh) {
    return SceneMaker(mesh).scene();
}

} // namespace nrb::io
