// SPDX-License-Identifier: MIT
#include "io/mesh_formats/write_meshes.h"

#include "base/error.h"
#include "io/unit_factor.h"

#include <cmath>

namespace nrb::io {

namespace {

// Checks the points as doubles: placements and units may make them overflow. Throws
// Status::not_representable.
void check_points(const PlacedMesh &mesh) {
    mesh.each_vertex([](const PlacedPart &part, const MeshFace &, size_t vertex) {
        if (!std::isfinite(largest(part.point_of(vertex)))) {
            fail(Status::not_representable, "a coordinate overflows in the unit of the file");
        }
    });
    count_work(4 * mesh.vertex_count());
}

} // namespace

ByteSource mesh_source(const Mesh &mesh, int32_t format, const WriteSettings &settings) {
    constexpr auto first = static_cast<int32_t>(MeshFormat::stl),
                   last = static_cast<int32_t>(MeshFormat::vtu);
    if (format < first || format > last) {
        fail(Status::format, "format = %d, expected one of meshes, from %d for STL to %d for VTU", format,
             first, last);
    }
    const Lengths lengths = lengths_of(mesh.metres_per_unit, settings);
    const auto placed = std::make_shared<const PlacedMesh>(mesh, lengths.factor);
    check_points(*placed);
    switch (static_cast<MeshFormat>(format)) {
    case MeshFormat::stl:
        return stl_source(placed);
    case MeshFormat::stl_text:
        return stl_text_source(placed);
    case MeshFormat::obj:
        return obj_source(placed);
    case MeshFormat::ply:
        return ply_source(placed);
    case MeshFormat::glb:
        return glb_source(placed, lengths.metres);
    case MeshFormat::vtu:
        break;
    }
    return vtu_source(placed);
}

} // namespace nrb::io
