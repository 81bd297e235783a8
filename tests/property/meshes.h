// Meshes as arrays, and what holds of them: areas, distances of points, sides of triangles.
#pragma once

#include "property/faces.h"
#include "property/models.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace support::meshes {

using Vec = std::vector<double>;
using Point = std::array<double, 3>;
using Corners = std::array<int64_t, 3>;
using Quad = std::array<int64_t, 4>;

struct DestroyMesh {
    void operator()(nurbs_mesh *mesh) const noexcept { nurbs_mesh_destroy(mesh); }
};

struct Mesh {
    std::vector<Point> points, normals;
    std::vector<std::array<double, 2>> params;
    std::vector<int64_t> at; // points of the vertices
    std::vector<Corners> triangles, welded;
    std::vector<Quad> quads;
    std::vector<int64_t> quad_triangles;
    std::vector<int64_t> first_triangles, triangle_counts; // of the faces
    std::vector<int64_t> edge_firsts, edge_sizes, edge_points;
    double from_shape = -1, from_mesh = -1;
    int32_t reached = -1;
};

template <class T>
auto *flat(std::vector<T> &records) {
    return records.empty() ? nullptr : records[0].data();
}

inline Mesh arrays_of(const nurbs_mesh *mesh) {
    int64_t points = 0, vertices = 0, triangles = 0, faces = 0, edges = 0, edge_points = 0, quads = 0;
    require_ok(nurbs_mesh_quads(mesh, 0, 0, nullptr, nullptr, &quads));
    require_ok(nurbs_mesh_counts(mesh, &points, &vertices, &triangles, &faces, &edges, &edge_points));
    const auto resize = [](auto &array, int64_t n) { array.resize(static_cast<size_t>(n)); };
    Mesh all;
    resize(all.points, points);
    resize(all.normals, vertices);
    resize(all.params, vertices);
    resize(all.at, vertices);
    resize(all.triangles, triangles);
    resize(all.welded, triangles);
    resize(all.quads, quads);
    resize(all.quad_triangles, quads);
    resize(all.first_triangles, faces);
    resize(all.triangle_counts, faces);
    resize(all.edge_firsts, edges);
    resize(all.edge_sizes, edges);
    resize(all.edge_points, edge_points);
    require_ok(nurbs_mesh_bound(mesh, &all.from_shape, &all.from_mesh, &all.reached));
    require_ok(nurbs_mesh_points(mesh, points, flat(all.points), nullptr));
    require_ok(
        nurbs_mesh_vertices(mesh, vertices, all.at.data(), flat(all.params), flat(all.normals), nullptr));
    require_ok(nurbs_mesh_triangles(mesh, 0, triangles, flat(all.triangles), nullptr));
    require_ok(nurbs_mesh_triangles(mesh, NURBS_MESH_WELDED, triangles, flat(all.welded), nullptr));
    require_ok(nurbs_mesh_quads(mesh, 0, quads, flat(all.quads), all.quad_triangles.data(), nullptr));
    require_ok(nurbs_mesh_faces(mesh, faces, nullptr, nullptr, all.first_triangles.data(),
                                all.triangle_counts.data(), nullptr, nullptr, nullptr, nullptr));
    require_ok(nurbs_mesh_edges(mesh, edges, nullptr, all.edge_firsts.data(), all.edge_sizes.data(), nullptr,
                                nullptr, nullptr));
    require_ok(nurbs_mesh_edge_points(mesh, edge_points, all.edge_points.data(), nullptr));
    return all;
}

template <class Shape, class Function>
inline Mesh mesh_of(const Shape *shape, double chord, Function make, double angle = 0) {
    nurbs_mesh_options options;
    require_ok(nurbs_mesh_options_init(&options, sizeof options));
    options.chord = chord;
    options.relative_chord = 0;
    options.angle = angle;
    nurbs_mesh *made = nullptr;
    require_ok(make(shape, &options, &made));
    const std::unique_ptr<nurbs_mesh, DestroyMesh> own(made);
    return arrays_of(made);
}
inline Mesh mesh_of(const nurbs *g, double chord, double angle = 0) {
    return mesh_of(g, chord, nurbs_mesh_surface, angle);
}
inline Mesh mesh_of(const nurbs_face *face, double chord, double angle = 0) {
    return mesh_of(face, chord, nurbs_mesh_face, angle);
}
inline Mesh mesh_of(const nurbs_model *model, double chord, double angle = 0) {
    return mesh_of(model, chord, nurbs_mesh_model, angle);
}

inline double dot(const Point &a, const Point &b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point minus(const Point &a, const Point &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point cross(const Point &a, const Point &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct Triangle {
    Point a, b, c;

    [[nodiscard]] Point across() const { return cross(minus(b, a), minus(c, a)); }
    [[nodiscard]] double area() const { return std::sqrt(dot(across(), across())) / 2; }
    [[nodiscard]] Point at(double s, double t) const {
        Point x{};
        for (size_t k = 0; k < 3; ++k) {
            x[k] = a[k] + s * (b[k] - a[k]) + t * (c[k] - a[k]);
        }
        return x;
    }
    // Over it the height, elsewhere the distance of the nearest side.
    [[nodiscard]] double distance(const Point &x) const {
        const Point normal = across(), corners[] = {a, b, c};
        double least = INFINITY;
        bool over = dot(normal, normal) > 0;
        for (size_t k = 0; k < 3; ++k) {
            const Point &from = corners[k], side = minus(corners[(k + 1) % 3], from), off = minus(x, from);
            over = over && dot(cross(normal, side), off) >= 0;
            const double share = std::clamp(dot(off, side) / dot(side, side), 0.0, 1.0);
            const Point rest{off[0] - share * side[0], off[1] - share * side[1], off[2] - share * side[2]};
            least = std::min(least, std::sqrt(dot(rest, rest)));
        }
        return over ? std::min(least, std::fabs(dot(normal, minus(x, a))) / std::sqrt(dot(normal, normal)))
                    : least;
    }
};

inline Triangle triangle(const Mesh &mesh, size_t i) {
    const Corners &at = mesh.welded[i];
    return {mesh.points[static_cast<size_t>(at[0])], mesh.points[static_cast<size_t>(at[1])],
            mesh.points[static_cast<size_t>(at[2])]};
}

inline double area_of(const Mesh &mesh) {
    double sum = 0;
    for (size_t i = 0; i < mesh.welded.size(); ++i) {
        sum += triangle(mesh, i).area();
    }
    return sum;
}

inline double distance(const Mesh &mesh, const Point &x) {
    double least = INFINITY;
    for (size_t i = 0; i < mesh.welded.size(); ++i) {
        least = std::min(least, triangle(mesh, i).distance(x));
    }
    return least;
}

// How often triangles run along a side from one point to another.
using Sides = std::map<std::array<int64_t, 2>, int>;
inline void add_sides(const Corners &at, bool turned, Sides &sides) {
    for (size_t k = 0; k < 3; ++k) {
        const int64_t from = at[k], to = at[(k + 1) % 3];
        EXPECT_NE(from, to);
        ++sides[turned ? std::array{to, from} : std::array{from, to}];
    }
}
inline Sides sides_of(const Mesh &mesh) {
    Sides sides;
    for (const Corners &at : mesh.welded) {
        add_sides(at, false, sides);
    }
    return sides;
}

// Sides without a triangle on their other side; none has two on one.
inline int64_t free_sides(const Sides &sides) {
    int64_t free = 0;
    for (const auto &[side, count] : sides) {
        EXPECT_EQ(count, 1);
        free += sides.count({side[1], side[0]}) == 0 ? 1 : 0;
    }
    return free;
}

inline int64_t euler(const Mesh &mesh, const Sides &sides) {
    std::set<int64_t> used;
    for (const Corners &at : mesh.welded) {
        used.insert(at.begin(), at.end());
    }
    const auto edges = (std::ssize(sides) + free_sides(sides)) / 2;
    return std::ssize(used) - edges + std::ssize(mesh.welded);
}

inline Handle sphere(double radius) {
    return std::move(faces::sphere(radius).surface);
}
inline Handle torus(double major, double minor) {
    return std::move(faces::torus(major, minor).surface);
}

inline Point point_of(const nurbs *g, const std::array<double, 2> &at) {
    Point x{};
    require_ok(nurbs_eval(g, 1, at.data(), 0, 0, x.data(), 0, 0, 0));
    return x;
}

// Sides of the triangles of a model about its outer normals.
inline Sides sides_of(const nurbs_model *model, const Mesh &mesh) {
    Sides sides;
    for (size_t face = 0; face < mesh.first_triangles.size(); ++face) {
        int32_t against = 0;
        nurbs_face *own = nullptr;
        require_ok(
            nurbs_model_face(model, static_cast<int64_t>(face), nullptr, nullptr, &against, nullptr, &own));
        nurbs_face_destroy(own);
        const auto first = static_cast<size_t>(mesh.first_triangles[face]);
        for (size_t i = 0; std::cmp_less(i, mesh.triangle_counts[face]); ++i) {
            add_sides(mesh.welded[first + i], against != 0, sides);
        }
    }
    return sides;
}

// Its edges are those of triangles of both faces that share them.
inline void expect_common_edges(const Mesh &mesh, const Sides &sides) {
    for (size_t i = 0; i < mesh.edge_firsts.size(); ++i) {
        const int64_t *at = &mesh.edge_points[static_cast<size_t>(mesh.edge_firsts[i])];
        for (int64_t k = 1; k < mesh.edge_sizes[i]; ++k) {
            EXPECT_EQ(sides.count({at[k - 1], at[k]}) + sides.count({at[k], at[k - 1]}), 2U) << i;
        }
    }
}

} // namespace support::meshes
