// SPDX-License-Identifier: MIT
// A mesh as files show it: all instances of its parts, placed in the whole, in the unit of the file, with
// triangles and normals that face outwards.
#pragma once

#include "mesh/mesh.h"
#include "model/rays/instances.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace nrb::io {

using mesh::Mesh;
using mesh::MeshFace;

// The outer normals at vertices: those of the surfaces. Where a surface has none, as at some poles, the
// normalized sum of the unit normals of the triangles around the vertex, or Z if that sum vanishes.
class OuterNormals {
public:
    explicit OuterNormals(const Mesh &mesh);
    [[nodiscard]] Vector3 at(const MeshFace &face, size_t vertex) const {
        const Vector3 &own = mesh_.vertices[vertex].normal;
        const Vector3 &normal = std::isnan(own.x) ? made_.at(vertex) : own;
        return face.turned ? -1 * normal : normal;
    }

private:
    const Mesh &mesh_;
    std::unordered_map<size_t, Vector3> made_; // on the side of the normal of the surface
};

// The corners of a triangle, as numbers of vertices, counterclockwise as seen from outside.
inline std::array<size_t, 3> outer_corners(const Mesh &mesh, const MeshFace &face, size_t triangle,
                                           bool mirrored) noexcept {
    const auto &[a, b, c] = mesh.triangles[face.first_triangle + triangle];
    const bool turn = face.turned != mirrored;
    return {static_cast<size_t>(a), static_cast<size_t>(turn ? c : b), static_cast<size_t>(turn ? b : c)};
}

// An instance of a part: the part in one of its placements.
class PlacedPart {
public:
    PlacedPart(const Mesh &mesh, const std::vector<model::Instance> &instances, size_t index, double factor)
        : mesh_(&mesh), place_(instances, index), factor_(factor), part(instances[index].part),
          use(instances[index].use) {}

    [[nodiscard]] Vector3 point(int32_t index) const noexcept {
        return factor_ * place_.in_whole(mesh_->points[static_cast<size_t>(index)]);
    }
    [[nodiscard]] Vector3 point_of(size_t vertex) const noexcept {
        return point(mesh_->vertices[vertex].point);
    }
    [[nodiscard]] Vector3 normal(const OuterNormals &normals, const MeshFace &face, size_t vertex) const {
        return place_.normal_in_whole(normals.at(face, vertex));
    }
    [[nodiscard]] bool mirrors() const noexcept { return place_.mirrors(); }

private:
    const Mesh *mesh_;
    model::Placement place_;
    double factor_;

public:
    int64_t part, use;
};

// Refers to the mesh, which must outlive it. The constructor throws Status::count if there are no triangles,
// and what instances_of() and Placement throw.
class PlacedMesh {
public:
    // `factor`: from the unit of the mesh to that of the file.
    PlacedMesh(const Mesh &mesh, double factor);

    [[nodiscard]] const Mesh &mesh() const noexcept { return *mesh_; }
    [[nodiscard]] double factor() const noexcept { return factor_; }
    [[nodiscard]] const OuterNormals &normals() const noexcept { return normals_; }
    // The instances that have triangles, in the order of instances_of().
    [[nodiscard]] const std::vector<PlacedPart> &parts() const noexcept { return parts_; }
    [[nodiscard]] const std::vector<const MeshFace *> &faces_of(int64_t part) const noexcept {
        return faces_[static_cast<size_t>(part)];
    }
    [[nodiscard]] int64_t face_number(const MeshFace &face) const noexcept {
        return &face - mesh_->faces.data();
    }
    [[nodiscard]] bool has_colours() const noexcept;
    [[nodiscard]] int64_t vertex_count() const noexcept { return vertices_; }
    [[nodiscard]] int64_t triangle_count() const noexcept { return triangles_; }

    // Calls f(part, face) for the faces of all instances.
    template <class F>
    void each_face(F &&f) const {
        for (const PlacedPart &part : parts_) {
            for (const MeshFace *face : faces_of(part.part)) {
                f(part, *face);
            }
        }
    }
    // Calls f(part, face, vertex) for all vertices, in the order in which each_triangle() numbers them.
    template <class F>
    void each_vertex(F &&f) const {
        each_face([&](const PlacedPart &part, const MeshFace &face) {
            for (size_t i = 0; i < face.vertices; ++i) {
                f(part, face, face.first_vertex + i);
            }
        });
    }
    // Calls f(part, face, corners, shift) for all triangles. A corner plus `shift` is its number among the
    // vertices of each_vertex().
    template <class F>
    void each_triangle(F &&f) const {
        int64_t base = 0;
        each_face([&](const PlacedPart &part, const MeshFace &face) {
            const int64_t shift = base - static_cast<int64_t>(face.first_vertex);
            for (size_t i = 0; i < face.triangles; ++i) {
                f(part, face, outer_corners(*mesh_, face, i, part.mirrors()), shift);
            }
            base += static_cast<int64_t>(face.vertices);
        });
    }

private:
    const Mesh *mesh_;
    double factor_;
    OuterNormals normals_;
    std::vector<std::vector<const MeshFace *>> faces_; // for each part
    std::vector<PlacedPart> parts_;
    int64_t vertices_ = 0, triangles_ = 0;
};

using PlacedMeshPtr = std::shared_ptr<const PlacedMesh>;

// The unit normal of a triangle; 0 if the triangle has none.
inline Vector3 triangle_normal(const Vector3 &a, const Vector3 &b, const Vector3 &c) noexcept {
    Vector3 across = cross(b - a, c - a);
    if (!in_range(dot(across, across))) {
        across = cross(scaled_to_one(b - a), scaled_to_one(c - a));
    }
    return dot(across, across) > 0 ? unit(across) : Vector3{};
}

// The name of a use or, if that is empty, of its part.
const std::string &name_of(const Mesh &mesh, int64_t use);

// Red, green and blue from 0 to 255; grey for a face without a colour.
std::array<uint8_t, 3> colour_bytes(const MeshFace &face) noexcept;

} // namespace nrb::io
