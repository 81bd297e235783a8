// SPDX-License-Identifier: MIT
#include "io/mesh_formats/single.h"
#include "io/mesh_formats/write_meshes.h"

namespace nrb::io {

namespace {

constexpr std::string_view stl_header = "Written by libnurbs: triangles in binary STL";
constexpr size_t stl_header_size = 80;

// Calls f(points, corners) for the triangles whose corners are distinct in single precision. `points`: the
// corners in double precision.
template <class F>
void each_facet(const PlacedMesh &mesh, F &&f) {
    mesh.each_triangle(
        [&](const PlacedPart &part, const MeshFace &, const std::array<size_t, 3> &corners, int64_t) {
            const std::array points{part.point_of(corners[0]), part.point_of(corners[1]),
                                    part.point_of(corners[2])};
            const std::array<Single3, 3> rounded{checked_single(points[0]), checked_single(points[1]),
                                                 checked_single(points[2])};
            if (rounded[0] != rounded[1] && rounded[1] != rounded[2] && rounded[2] != rounded[0]) {
                f(points, rounded);
            }
        });
}

int64_t count_facets(const PlacedMesh &mesh) {
    int64_t count = 0;
    each_facet(mesh, [&](const auto &, const auto &) { ++count; });
    count_work(16 * mesh.triangle_count());
    if (count == 0) {
        fail(Status::not_representable, "two corners of each triangle are one point in single precision");
    }
    return count;
}

void write_binary_facets(const PlacedMesh &mesh, int64_t count, Blocks &out) {
    out.text(stl_header);
    out.text(std::string(stl_header_size - stl_header.size(), ' '));
    out.bytes(static_cast<uint32_t>(count));
    each_facet(mesh, [&](const auto &points, const auto &corners) {
        const Single3 normal = single(triangle_normal(points[0], points[1], points[2]));
        out.bytes(normal[0], normal[1], normal[2]);
        for (const Single3 &corner : corners) {
            out.bytes(corner[0], corner[1], corner[2]);
        }
        out.bytes(uint16_t{0});
    });
}

void write_row(std::string_view before, const Single3 &row, Blocks &out) {
    out.text(before);
    out.row(row[0], row[1], row[2]);
    out.text("\n");
}

void write_text_facets(const PlacedMesh &mesh, Blocks &out) {
    out.text("solid libnurbs\n");
    each_facet(mesh, [&](const auto &points, const auto &corners) {
        write_row("facet normal ", single(triangle_normal(points[0], points[1], points[2])), out);
        out.text("outer loop\n");
        for (const Single3 &corner : corners) {
            write_row("vertex ", corner, out);
        }
        out.text("endloop\nendfacet\n");
    });
    out.text("endsolid libnurbs\n");
}

} // namespace

ByteSource stl_source(const PlacedMeshPtr &mesh) {
    const int64_t count = count_facets(*mesh);
    if (!std::in_range<uint32_t>(count)) {
        fail(Status::too_large, "%lld triangles, STL counts to 4294967295", static_cast<long long>(count));
    }
    return source_of([mesh, count](Blocks &out) { write_binary_facets(*mesh, count, out); });
}

ByteSource stl_text_source(const PlacedMeshPtr &mesh) {
    (void)count_facets(*mesh);
    return source_of([mesh](Blocks &out) { write_text_facets(*mesh, out); });
}

} // namespace nrb::io
