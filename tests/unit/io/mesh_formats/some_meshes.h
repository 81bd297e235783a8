// Meshes for tests of writers, made by hand, and what files have to show of them.
#pragma once

#include "mesh/mesh.h"
#include "support/mesh_files.h"
#include "support/written_models.h"

#include <random>

namespace mesh_formats_test {

using namespace nrb;
using support::mesh_files::Point;
using support::mesh_files::Soup;
using support::mesh_files::Triangle;

// The boundary of a tetrahedron at `origin`, a face for each side, as seen from outside.
inline void add_tetrahedron(mesh::Mesh &mesh, int64_t part, const Vector3 &origin) {
    const auto base = static_cast<int32_t>(mesh.points.size());
    const Vector3 corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1.5, 0}, {0, 0, 1.75}};
    for (const Vector3 &corner : corners) {
        mesh.points.push_back(origin + corner);
    }
    for (const std::array<int32_t, 3> &side : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
        mesh::MeshFace face;
        face.first_vertex = mesh.vertices.size();
        face.vertices = 3;
        face.first_triangle = mesh.triangles.size();
        face.triangles = 1;
        face.part = part;
        face.name = "face " + std::to_string(mesh.faces.size());
        const auto at = [&](size_t k) { return corners[side[k]]; };
        const Vector3 normal = unit(cross(at(1) - at(0), at(2) - at(0)));
        for (const int32_t corner : side) {
            mesh.vertices.push_back({base + corner, {0.5 * corner, 1.0 * corner}, normal});
        }
        const auto first = static_cast<int32_t>(face.first_vertex);
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.faces.push_back(face);
    }
}

// Some faces run the other way, which they say; one vertex has no normal.
inline void turn_some(mesh::Mesh &mesh) {
    for (size_t i = 0; i < mesh.faces.size(); i += 3) {
        mesh::MeshFace &face = mesh.faces[i];
        face.turned = true;
        std::swap(mesh.triangles[face.first_triangle][1], mesh.triangles[face.first_triangle][2]);
        for (size_t k = 0; k < face.vertices; ++k) {
            mesh::MeshVertex &vertex = mesh.vertices[face.first_vertex + k];
            vertex.normal = -1 * vertex.normal;
        }
    }
    mesh.vertices.front().normal = {NAN, NAN, NAN};
}

// Two parts of a tetrahedron or two: the second one in the first one twice, one of them as a mirror image, and once in the whole.
inline mesh::Mesh two_parts(unsigned seed = 1) {
    mesh::Mesh mesh;
    add_tetrahedron(mesh, 0, {1, 2, 3});
    add_tetrahedron(mesh, 1, {-1, 0.25, 2});
    add_tetrahedron(mesh, 1, {5, 5, 5});
    turn_some(mesh);
    mesh.faces[1].colour = {1, 0.5, 0};
    mesh.faces[6].colour = {0, 0.25, 1};
    mesh.faces[7].colour = {1, 0.5, 0};
    mesh.metres_per_unit = 0.001;
    mesh.parts = {{"first \"part\""}, {"b\xc3\xa4r"}};
    std::mt19937 random(seed);
    const auto motion = [&random](double side) { return write_test::random_motion(random, 1.5, side); };
    mesh.uses = {{-1, 0, motion(1), "whole"},
                 {0, 1, motion(-1), ""},
                 {0, 1, motion(1), "second"},
                 {-1, 1, model::Use{}.placement, ""}};
    return mesh;
}

inline Point placed(const std::array<double, 12> &m, const Point &x) {
    Point y{};
    for (size_t i = 0; i < 3; ++i) {
        y[i] = m[4 * i] * x[0] + m[4 * i + 1] * x[1] + m[4 * i + 2] * x[2] + m[4 * i + 3];
    }
    return y;
}

// A use of a part and all below it. They are mirrored if an odd number of placements are.
inline void add_use(const mesh::Mesh &mesh, size_t use, std::vector<std::array<double, 12>> above,
                    Soup &soup) {
    above.push_back(mesh.uses[use].placement);
    for (size_t i = 0; i < mesh.faces.size(); ++i) {
        const mesh::MeshFace &face = mesh.faces[i];
        for (size_t k = 0; face.part == mesh.uses[use].part && k < face.triangles; ++k) {
            Triangle t;
            bool turned = face.turned;
            for (size_t c = 0; c < 3; ++c) {
                const auto vertex = static_cast<size_t>(mesh.triangles[face.first_triangle + k][c]);
                const Vector3 &x = mesh.points[static_cast<size_t>(mesh.vertices[vertex].point)];
                t.corners[c] = {x.x, x.y, x.z};
            }
            for (size_t m = above.size(); m-- > 0;) {
                for (Point &corner : t.corners) {
                    corner = placed(above[m], corner);
                }
                const auto &a = above[m];
                turned ^= support::mesh_files::dot(
                              {a[0], a[4], a[8]},
                              support::mesh_files::cross({a[1], a[5], a[9]}, {a[2], a[6], a[10]})) < 0;
            }
            if (turned) {
                std::swap(t.corners[1], t.corners[2]);
            }
            t.face = static_cast<int64_t>(i);
            t.part = face.part;
            soup.push_back(t);
        }
    }
    for (size_t i = 0; i < mesh.uses.size(); ++i) {
        if (mesh.uses[i].parent == mesh.uses[use].part) {
            add_use(mesh, i, above, soup);
        }
    }
}

// What a file has to show, in any order.
inline Soup wanted(const mesh::Mesh &mesh) {
    Soup soup;
    for (size_t i = 0; i < mesh.uses.size(); ++i) {
        if (mesh.uses[i].parent < 0) {
            add_use(mesh, i, {}, soup);
        }
    }
    return soup;
}

} // namespace mesh_formats_test
