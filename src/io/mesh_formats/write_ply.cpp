// SPDX-License-Identifier: MIT
#include "io/mesh_formats/single.h"
#include "io/mesh_formats/write_meshes.h"

namespace nrb::io {

namespace {

void write_ply_head(const PlacedMesh &mesh, Blocks &out) {
    out.text("ply\nformat binary_little_endian 1.0\ncomment Written by libnurbs\nelement vertex ");
    out.digits(mesh.vertex_count());
    out.text("\nproperty double x\nproperty double y\nproperty double z\n"
             "property float nx\nproperty float ny\nproperty float nz\nproperty int face_number\n");
    if (mesh.has_colours()) {
        out.text("property uchar red\nproperty uchar green\nproperty uchar blue\n");
    }
    out.text("element face ");
    out.digits(mesh.triangle_count());
    out.text("\nproperty list uchar int vertex_indices\nend_header\n");
}

// Colours are those of vertices, each of which belongs to one face: more programs know colours of vertices
// than of triangles.
void write_ply_vertices(const PlacedMesh &mesh, Blocks &out) {
    const bool coloured = mesh.has_colours();
    mesh.each_vertex([&](const PlacedPart &part, const MeshFace &face, size_t vertex) {
        const Vector3 x = part.point_of(vertex);
        const Single3 n = single(part.normal(mesh.normals(), face, vertex));
        out.bytes(x.x, x.y, x.z);
        out.bytes(n[0], n[1], n[2], static_cast<int32_t>(mesh.face_number(face)));
        if (coloured) {
            const std::array<uint8_t, 3> colour = colour_bytes(face);
            out.bytes(colour[0], colour[1], colour[2]);
        }
    });
}

void write_ply_triangles(const PlacedMesh &mesh, Blocks &out) {
    mesh.each_triangle(
        [&](const PlacedPart &, const MeshFace &, const std::array<size_t, 3> &corners, int64_t shift) {
            out.bytes(uint8_t{3});
            for (const size_t corner : corners) {
                out.bytes(static_cast<int32_t>(static_cast<int64_t>(corner) + shift));
            }
        });
}

} // namespace

ByteSource ply_source(const PlacedMeshPtr &mesh) {
    if (!std::in_range<int32_t>(mesh->vertex_count())) {
        fail(Status::too_large, "%lld vertices, expected less than 2^31",
             static_cast<long long>(mesh->vertex_count()));
    }
    return source_of([mesh](Blocks &out) {
        write_ply_head(*mesh, out);
        write_ply_vertices(*mesh, out);
        write_ply_triangles(*mesh, out);
    });
}

} // namespace nrb::io
