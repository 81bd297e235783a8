// SPDX-License-Identifier: MIT
// Copies the contents of meshes to arrays of the caller: points, vertices, triangles, quads, faces, edges and
// hexahedra.
#include "checks.h"
#include "guard.h"
#include "outputs.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

using namespace nrb;
using namespace nrb::capi;

namespace {

const mesh::Mesh &mesh_of(const nurbs_mesh *mesh) {
    require(mesh, "mesh");
    return *mesh->mesh;
}

// Stores record i of an array of records of `width` numbers.
template <class Number, size_t width>
void put_record(Number *out, size_t i, const std::array<double, width> &values) noexcept {
    for (size_t k = 0; k < width; ++k) {
        put(out, width * i + k, static_cast<Number>(values[k]));
    }
}

template <class Number>
void put_record(Number *out, size_t i, const Vector3 &x) noexcept {
    put_record(out, i, std::array{x.x, x.y, x.z});
}

template <class Number>
void give_points(const mesh::Mesh &own, int64_t cap, Number *points, int64_t *count) {
    const int64_t filled = checked_cap(cap, std::ssize(own.points));
    check_apart({memory("points", points, 3 * filled), memory("count", count, 1)}, {});
    for (size_t i = 0; std::cmp_less(i, filled); ++i) {
        put_record(points, i, own.points[i]);
    }
    put(count, int64_t{std::ssize(own.points)});
}

bool is_welded(uint32_t flags) {
    if ((flags & ~NURBS_MESH_WELDED) != 0) {
        fail(Status::flags, "flags = 0x%x, expected NURBS_MESH_WELDED or 0", flags);
    }
    return flags != 0;
}

// Stores record i of an array of corners, as numbers of vertices or, if welded, of points.
template <class Integer, size_t width>
void put_corners(const mesh::Mesh &own, bool welded, const std::array<int32_t, width> &vertices, size_t i,
                 Integer *out) noexcept {
    for (size_t k = 0; k < width; ++k) {
        const int32_t vertex = vertices[k];
        put(out, width * i + k, Integer{welded ? own.vertices[static_cast<size_t>(vertex)].point : vertex});
    }
}

template <class Integer>
void give_triangles(const mesh::Mesh &own, uint32_t flags, int64_t cap, Integer *corners, int64_t *count) {
    const bool welded = is_welded(flags);
    const int64_t filled = checked_cap(cap, std::ssize(own.triangles));
    check_apart({memory("corners", corners, 3 * filled), memory("count", count, 1)}, {});
    for (size_t i = 0; std::cmp_less(i, filled); ++i) {
        put_corners(own, welded, own.triangles[i], i, corners);
    }
    put(count, int64_t{std::ssize(own.triangles)});
}

// The quad that triangles `first` and first + 1 form. Its corners 0, 1, 2 and 0, 2, 3 are those of the two
// triangles, each of which may begin with any of its three. The triangles share the ends of the diagonal,
// `to` and `from`, which follow the third corner a[k] of the first triangle in its cyclic order.
std::array<int32_t, 4> quad_of(const mesh::Mesh &own, size_t first) {
    const std::array<int32_t, 3> &a = own.triangles[first], &b = own.triangles[first + 1];
    size_t k = 0; // a[k]: the corner that b does not have
    while (std::ranges::find(b, a[k]) != b.end()) {
        ++k;
    }
    const int32_t from = a[(k + 2) % 3], to = a[(k + 1) % 3];
    const auto *const other = std::ranges::find_if(b, [&](int32_t x) { return x != from && x != to; });
    return {from, a[k], to, *other};
}

// The lower and the upper end along each axis of a cell of a grid; the last axis varies fastest in `index`.
template <size_t axes>
std::array<double, 2 * axes> domain_of_cell(const std::array<std::vector<double>, axes> &lines,
                                            size_t index) {
    std::array<double, 2 * axes> ends{};
    for (size_t k = axes; k-- > 0;) {
        const size_t cells = lines[k].size() - 1, at = index % cells;
        ends[2 * k] = lines[k][at];
        ends[2 * k + 1] = lines[k][at + 1];
        index /= cells;
    }
    return ends;
}

} // namespace

nurbs_status nurbs_mesh_counts(const nurbs_mesh *mesh, int64_t *points, int64_t *vertices, int64_t *triangles,
                               int64_t *faces, int64_t *edges, int64_t *edge_points) {
    return guard([&] {
        const mesh::Mesh &own = mesh_of(mesh);
        check_apart({memory("points", points, 1), memory("vertices", vertices, 1),
                     memory("triangles", triangles, 1), memory("faces", faces, 1), memory("edges", edges, 1),
                     memory("edge_points", edge_points, 1)},
                    {});
        put(points, int64_t{std::ssize(own.points)});
        put(vertices, int64_t{std::ssize(own.vertices)});
        put(triangles, int64_t{std::ssize(own.triangles)});
        put(faces, int64_t{std::ssize(own.faces)});
        put(edges, int64_t{std::ssize(own.edges)});
        put(edge_points, int64_t{std::ssize(own.edge_points)});
    });
}

nurbs_status nurbs_mesh_bound(const nurbs_mesh *mesh, double *from_shape, double *from_mesh,
                              int32_t *reached) {
    return guard([&] {
        const mesh::Mesh &own = mesh_of(mesh);
        check_apart({memory("from_shape", from_shape, 1), memory("from_mesh", from_mesh, 1),
                     memory("reached", reached, 1)},
                    {});
        double shape = 0, triangles = 0;
        for (const mesh::MeshFace &face : own.faces) {
            shape = std::max(shape, face.from_shape);
            triangles = std::max(triangles, face.from_mesh);
        }
        const auto is_reached = [](const auto &part) { return part.reached; };
        put(from_shape, shape);
        put(from_mesh, triangles);
        put(reached, int32_t{std::ranges::all_of(own.faces, is_reached) &&
                             std::ranges::all_of(own.edges, is_reached)});
    });
}

nurbs_status nurbs_mesh_points(const nurbs_mesh *mesh, int64_t cap, double *points, int64_t *count) {
    return guard([&] { give_points(mesh_of(mesh), cap, points, count); });
}

nurbs_status nurbs_mesh_points_f32(const nurbs_mesh *mesh, int64_t cap, float *points, int64_t *count) {
    return guard([&] { give_points(mesh_of(mesh), cap, points, count); });
}

nurbs_status nurbs_mesh_vertices(const nurbs_mesh *mesh, int64_t cap, int64_t *own_points, double *params,
                                 double *normals, int64_t *count) {
    return guard([&] {
        const std::vector<mesh::MeshVertex> &vertices = mesh_of(mesh).vertices;
        const int64_t filled = checked_cap(cap, std::ssize(vertices));
        check_apart({memory("own_points", own_points, filled), memory("params", params, 2 * filled),
                     memory("normals", normals, 3 * filled), memory("count", count, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(own_points, i, int64_t{vertices[i].point});
            put_record(params, i, vertices[i].param);
            put_record(normals, i, vertices[i].normal);
        }
        put(count, int64_t{std::ssize(vertices)});
    });
}

nurbs_status nurbs_mesh_vertices_f32(const nurbs_mesh *mesh, int64_t cap, float *points, float *params,
                                     float *normals, int64_t *count) {
    return guard([&] {
        const mesh::Mesh &own = mesh_of(mesh);
        const int64_t filled = checked_cap(cap, std::ssize(own.vertices));
        check_apart({memory("points", points, 3 * filled), memory("params", params, 2 * filled),
                     memory("normals", normals, 3 * filled), memory("count", count, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            const mesh::MeshVertex &vertex = own.vertices[i];
            put_record(points, i, own.points[static_cast<size_t>(vertex.point)]);
            put_record(params, i, vertex.param);
            put_record(normals, i, vertex.normal);
        }
        put(count, int64_t{std::ssize(own.vertices)});
    });
}

nurbs_status nurbs_mesh_triangles(const nurbs_mesh *mesh, uint32_t flags, int64_t cap, int64_t *corners,
                                  int64_t *count) {
    return guard([&] { give_triangles(mesh_of(mesh), flags, cap, corners, count); });
}

nurbs_status nurbs_mesh_triangles_i32(const nurbs_mesh *mesh, uint32_t flags, int64_t cap, int32_t *corners,
                                      int64_t *count) {
    return guard([&] { give_triangles(mesh_of(mesh), flags, cap, corners, count); });
}

nurbs_status nurbs_mesh_quads(const nurbs_mesh *mesh, uint32_t flags, int64_t cap, int64_t *corners,
                              int64_t *own_triangles, int64_t *count) {
    return guard([&] {
        const mesh::Mesh &own = mesh_of(mesh);
        const bool welded = is_welded(flags);
        const int64_t all = std::ranges::count(own.paired, true), filled = checked_cap(cap, all);
        check_apart({memory("corners", corners, 4 * filled), memory("own_triangles", own_triangles, filled),
                     memory("count", count, 1)},
                    {});
        for (size_t i = 0, quad = 0; std::cmp_less(quad, filled); ++i) {
            if (own.paired[i]) {
                put_corners(own, welded, quad_of(own, i), quad, corners);
                put(own_triangles, quad++, static_cast<int64_t>(i));
            }
        }
        put(count, all);
    });
}

nurbs_status nurbs_mesh_faces(const nurbs_mesh *mesh, int64_t cap, int64_t *first_vertices,
                              int64_t *vertex_counts, int64_t *first_triangles, int64_t *triangle_counts,
                              double *from_shape, double *from_mesh, int32_t *reaches, int64_t *count) {
    return guard([&] {
        const std::vector<mesh::MeshFace> &faces = mesh_of(mesh).faces;
        const int64_t filled = checked_cap(cap, std::ssize(faces));
        check_apart({memory("first_vertices", first_vertices, filled),
                     memory("vertex_counts", vertex_counts, filled),
                     memory("first_triangles", first_triangles, filled),
                     memory("triangle_counts", triangle_counts, filled),
                     memory("from_shape", from_shape, filled), memory("from_mesh", from_mesh, filled),
                     memory("reaches", reaches, filled), memory("count", count, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(first_vertices, i, static_cast<int64_t>(faces[i].first_vertex));
            put(vertex_counts, i, static_cast<int64_t>(faces[i].vertices));
            put(first_triangles, i, static_cast<int64_t>(faces[i].first_triangle));
            put(triangle_counts, i, static_cast<int64_t>(faces[i].triangles));
            put(from_shape, i, faces[i].from_shape);
            put(from_mesh, i, faces[i].from_mesh);
            put(reaches, i, int32_t{faces[i].reached});
        }
        put(count, int64_t{std::ssize(faces)});
    });
}

nurbs_status nurbs_mesh_edges(const nurbs_mesh *mesh, int64_t cap, int64_t *own_edges, int64_t *firsts,
                              int64_t *sizes, double *bounds, int32_t *reaches, int64_t *count) {
    return guard([&] {
        const std::vector<mesh::MeshEdge> &edges = mesh_of(mesh).edges;
        const int64_t filled = checked_cap(cap, std::ssize(edges));
        check_apart({memory("own_edges", own_edges, filled), memory("firsts", firsts, filled),
                     memory("sizes", sizes, filled), memory("bounds", bounds, filled),
                     memory("reaches", reaches, filled), memory("count", count, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(own_edges, i, edges[i].edge);
            put(firsts, i, static_cast<int64_t>(edges[i].first));
            put(sizes, i, static_cast<int64_t>(edges[i].points));
            put(bounds, i, edges[i].bound);
            put(reaches, i, int32_t{edges[i].reached});
        }
        put(count, int64_t{std::ssize(edges)});
    });
}

nurbs_status nurbs_mesh_edge_points(const nurbs_mesh *mesh, int64_t cap, int64_t *own_points,
                                    int64_t *count) {
    return guard([&] {
        const std::vector<int32_t> &points = mesh_of(mesh).edge_points;
        const int64_t filled = checked_cap(cap, std::ssize(points));
        check_apart({memory("own_points", own_points, filled), memory("count", count, 1)}, {});
        put_all(own_points, std::span(points).first(static_cast<size_t>(filled)));
        put(count, int64_t{std::ssize(points)});
    });
}

nurbs_status nurbs_mesh_hexahedra(const nurbs_mesh *mesh, int64_t cap, int64_t *corners, double *domains,
                                  int32_t *folds, int32_t *signs, int64_t *count) {
    return guard([&] {
        const mesh::Mesh &own = mesh_of(mesh);
        const int64_t filled = checked_cap(cap, std::ssize(own.hexahedra));
        check_apart({memory("corners", corners, 8 * filled), memory("domains", domains, 6 * filled),
                     memory("folds", folds, filled), memory("signs", signs, filled),
                     memory("count", count, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            const mesh::MeshHexahedron &cell = own.hexahedra[i];
            for (size_t k = 0; k < cell.corners.size(); ++k) {
                put(corners, cell.corners.size() * i + k, int64_t{cell.corners[k]});
            }
            put_record(domains, i, domain_of_cell(own.lines, i));
            put(folds, i, int32_t{cell.fold});
            put(signs, i, int32_t{cell.sign});
        }
        put(count, int64_t{std::ssize(own.hexahedra)});
    });
}
