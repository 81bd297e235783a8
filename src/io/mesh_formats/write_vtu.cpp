// SPDX-License-Identifier: MIT
#include "io/mesh_formats/single.h"
#include "io/mesh_formats/vtu.h"
#include "io/mesh_formats/write_meshes.h"

namespace nrb::io {

namespace {

using vtu::Array;
using vtu::NumberType;

// An array with a row for each vertex, which f(out, mesh, part, face, vertex) writes.
template <class F>
Array of_vertices(const PlacedMeshPtr &mesh, const char *name, NumberType type, int64_t components, F f) {
    const auto write = [mesh, f](Blocks &out) {
        mesh->each_vertex([&](const PlacedPart &part, const MeshFace &face, size_t vertex) {
            f(out, *mesh, part, face, vertex);
        });
    };
    return {name, type, components, mesh->vertex_count(), write};
}

// The same for triangles: f(out, mesh, part, face) writes the row of each.
template <class F>
Array of_triangles(const PlacedMeshPtr &mesh, const char *name, NumberType type, int64_t components, F f) {
    const auto write = [mesh, f](Blocks &out) {
        mesh->each_triangle([&](const PlacedPart &part, const MeshFace &face, const std::array<size_t, 3> &,
                                int64_t) { f(out, *mesh, part, face); });
    };
    return {name, type, components, mesh->triangle_count(), write};
}

Array points_array(const PlacedMeshPtr &mesh) {
    return of_vertices(
        mesh, "Points", NumberType::float64, 3,
        [](Blocks &out, const PlacedMesh &, const PlacedPart &part, const MeshFace &, size_t vertex) {
            const Vector3 x = part.point_of(vertex);
            out.bytes(x.x, x.y, x.z);
        });
}

Array normals_array(const PlacedMeshPtr &mesh) {
    Array array = of_vertices(
        mesh, "normals", NumberType::float32, 3,
        [](Blocks &out, const PlacedMesh &own, const PlacedPart &part, const MeshFace &face, size_t vertex) {
            const Single3 n = single(part.normal(own.normals(), face, vertex));
            out.bytes(n[0], n[1], n[2]);
        });
    array.role = "Normals";
    return array;
}

Array params_array(const PlacedMeshPtr &mesh) {
    return of_vertices(
        mesh, "params", NumberType::float64, 2,
        [](Blocks &out, const PlacedMesh &own, const PlacedPart &, const MeshFace &, size_t vertex) {
            const auto &[u, v] = own.mesh().vertices[vertex].param;
            out.bytes(u, v);
        });
}

Array connectivity_array(const PlacedMeshPtr &mesh) {
    const auto write = [mesh](Blocks &out) {
        mesh->each_triangle(
            [&](const PlacedPart &, const MeshFace &, const std::array<size_t, 3> &corners, int64_t shift) {
                for (const size_t corner : corners) {
                    out.bytes(static_cast<int64_t>(corner) + shift);
                }
            });
    };
    return {"connectivity", NumberType::int64, 1, 3 * mesh->triangle_count(), write};
}

std::vector<Array> cell_arrays(const PlacedMeshPtr &mesh) {
    std::vector<Array> arrays;
    arrays.push_back(
        of_triangles(mesh, "face", NumberType::int32, 1,
                     [](Blocks &out, const PlacedMesh &own, const PlacedPart &, const MeshFace &face) {
                         out.bytes(static_cast<int32_t>(own.face_number(face)));
                     }));
    arrays.push_back(of_triangles(mesh, "part", NumberType::int32, 1,
                                  [](Blocks &out, const PlacedMesh &, const PlacedPart &part,
                                     const MeshFace &) { out.bytes(static_cast<int32_t>(part.part)); }));
    if (mesh->has_colours()) {
        arrays.push_back(
            of_triangles(mesh, "colour", NumberType::uint8, 3,
                         [](Blocks &out, const PlacedMesh &, const PlacedPart &, const MeshFace &face) {
                             const std::array<uint8_t, 3> colour = colour_bytes(face);
                             out.bytes(colour[0], colour[1], colour[2]);
                         }));
    }
    return arrays;
}

} // namespace

ByteSource vtu_source(const PlacedMeshPtr &mesh) {
    return source_of([mesh](Blocks &out) {
        vtu::Grid grid{points_array(mesh), connectivity_array(mesh),
                       vtu::even_offsets(mesh->triangle_count(), 3),
                       vtu::even_types(mesh->triangle_count(), vtu::triangle)};
        grid.point_data = {normals_array(mesh), params_array(mesh)};
        grid.cell_data = cell_arrays(mesh);
        vtu::write(grid, out);
    });
}

} // namespace nrb::io
