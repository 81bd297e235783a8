// SPDX-License-Identifier: MIT
#include "io/mesh_formats/placed_mesh.h"

#include "base/error.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::io {

namespace {

// The grey of faces without a colour.
constexpr double no_colour = 0.8;

} // namespace

OuterNormals::OuterNormals(const Mesh &mesh) : mesh_(mesh) {
    for (size_t i = 0; i < mesh.vertices.size(); ++i) {
        if (std::isnan(mesh.vertices[i].normal.x)) {
            made_.try_emplace(i);
        }
    }
    if (made_.empty()) {
        return;
    }
    for (const auto &triangle : mesh.triangles) {
        const auto point = [&](size_t k) {
            return mesh.points[static_cast<size_t>(mesh.vertices[static_cast<size_t>(triangle[k])].point)];
        };
        for (size_t k = 0; k < 3; ++k) {
            const auto found = made_.find(static_cast<size_t>(triangle[k]));
            if (found != made_.end()) {
                found->second = found->second + triangle_normal(point(0), point(1), point(2));
            }
        }
    }
    for (auto &[vertex, sum] : made_) {
        sum = dot(sum, sum) > 0 ? unit(sum) : Vector3{0, 0, 1};
    }
}

PlacedMesh::PlacedMesh(const Mesh &mesh, double factor)
    : mesh_(&mesh), factor_(factor), normals_(mesh), faces_(mesh.parts.size()) {
    if (mesh.triangles.empty()) {
        fail(Status::count, "mesh: it has no triangles, expected one at least");
    }
    std::vector<std::array<int64_t, 2>> sizes(mesh.parts.size());
    for (const MeshFace &face : mesh.faces) {
        const auto part = static_cast<size_t>(face.part);
        faces_[part].push_back(&face);
        sizes[part][0] += static_cast<int64_t>(face.vertices);
        sizes[part][1] += static_cast<int64_t>(face.triangles);
    }
    const std::vector<model::Instance> instances = model::instances_of(mesh.parts.size(), mesh.uses);
    for (size_t i = 0; i < instances.size(); ++i) {
        const auto &[vertices, triangles] = sizes[static_cast<size_t>(instances[i].part)];
        if (triangles > 0) {
            parts_.emplace_back(mesh, instances, i, factor);
            vertices_ += vertices;
            triangles_ += triangles;
            count_work(64);
        }
    }
}

bool PlacedMesh::has_colours() const noexcept {
    return std::ranges::any_of(mesh_->faces, [](const MeshFace &face) { return face.colour.has_value(); });
}

const std::string &name_of(const Mesh &mesh, int64_t use) {
    const model::Use &own = mesh.uses[static_cast<size_t>(use)];
    return own.name.empty() ? mesh.parts[static_cast<size_t>(own.part)].name : own.name;
}

std::array<uint8_t, 3> colour_bytes(const MeshFace &face) noexcept {
    std::array<uint8_t, 3> bytes{};
    for (size_t k = 0; k < 3; ++k) {
        const double share = face.colour ? (*face.colour)[k] : no_colour;
        bytes[k] = static_cast<uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
    }
    return bytes;
}

} // namespace nrb::io
