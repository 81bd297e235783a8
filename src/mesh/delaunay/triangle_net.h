// SPDX-License-Identifier: MIT
// The data structure of a triangulation: triangles with their neighbours and marks on edges, and its local
// operations.
#pragma once

#include "mesh/delaunay/grid_point.h"

#include <array>
#include <cstddef>
#include <vector>

namespace nrb::mesh {

using VertexId = int32_t;
using TriangleId = int32_t;
// A half-edge: 4 t + k is the side of triangle t opposite of its corner k, which is its apex, with t to its
// left.
using EdgeId = int32_t;

// A triangulation of the convex hull of its vertices. Outside of each edge of the hull there is a ghost, a
// triangle whose third corner is an infinite vertex, so that every edge has a twin and every vertex a closed
// fan of triangles.
class TriangleNet {
public:
    static constexpr VertexId infinite = -1;
    // There are up to twice as many triangles as vertices, and half-edges, four numbers for each triangle,
    // fit into 31 bits.
    static constexpr int32_t most_vertices = int32_t{1} << 27;
    static constexpr int32_t unmarked = -1;

    explicit TriangleNet(std::vector<GridPoint> points, const GridMetric &metric = {});

    [[nodiscard]] const std::vector<GridPoint> &points() const noexcept { return points_; }
    [[nodiscard]] const GridPoint &point(VertexId v) const noexcept {
        return points_[static_cast<size_t>(v)];
    }
    [[nodiscard]] TriangleId size() const noexcept { return static_cast<TriangleId>(triangles_.size()); }
    [[nodiscard]] bool ghost(TriangleId t) const noexcept {
        const auto &corner = at(t).corner;
        return (corner[0] | corner[1] | corner[2]) < 0;
    }

    static TriangleId triangle_of(EdgeId e) noexcept { return e >> 2; }
    static EdgeId edge_of(TriangleId t, int k) noexcept { return 4 * t + k; }
    // The next and the previous edge of a triangle, counterclockwise.
    static EdgeId next(EdgeId e) noexcept { return (e & 3) == 2 ? e - 2 : e + 1; }
    static EdgeId previous(EdgeId e) noexcept { return (e & 3) == 0 ? e + 2 : e - 1; }
    [[nodiscard]] EdgeId twin(EdgeId e) const noexcept { return at(triangle_of(e)).twin[e & 3]; }
    [[nodiscard]] VertexId apex(EdgeId e) const noexcept { return at(triangle_of(e)).corner[e & 3]; }
    [[nodiscard]] VertexId from(EdgeId e) const noexcept { return apex(next(e)); }
    [[nodiscard]] VertexId to(EdgeId e) const noexcept { return apex(previous(e)); }
    // An edge that has v as its apex, and the one after e around the apex of e, counterclockwise.
    [[nodiscard]] EdgeId fan_of(VertexId v) const noexcept { return fans_[static_cast<size_t>(v + 1)]; }
    [[nodiscard]] EdgeId next_in_fan(EdgeId e) const noexcept { return next(twin(next(e))); }

    // A number that the user attaches to an edge, the same for both half-edges.
    [[nodiscard]] int32_t mark(EdgeId e) const noexcept { return at(triangle_of(e)).mark[e & 3]; }
    void set_mark(EdgeId e, int32_t mark) noexcept;
    [[nodiscard]] bool inside(TriangleId t) const noexcept { return at(t).inside; }
    void set_inside(TriangleId t, bool inside) noexcept { at(t).inside = inside; }

    // Positive if p is to the left of an edge, 0 on its line. Precondition: no end of the edge is infinite.
    [[nodiscard]] int64_t side(EdgeId e, const GridPoint &p) const noexcept {
        return orientation(point(from(e)), point(to(e)), p);
    }
    // Whether p is strictly inside the circle through the corners of a triangle. For a ghost this is the open
    // half-plane beyond its edge of the hull.
    [[nodiscard]] bool circle_contains(TriangleId t, const GridPoint &p) const noexcept;
    // Whether the triangles at an edge are the halves of a strictly convex quadrilateral.
    [[nodiscard]] bool convex_at(EdgeId e) const noexcept;

    // Makes the first triangle, which is counterclockwise, with its ghosts.
    void start(VertexId a, VertexId b, VertexId c);
    VertexId add_point(const GridPoint &p);
    // Replaces the triangle of e by three triangles at v, of which the one on e keeps its number.
    void split_triangle(EdgeId e, VertexId v);
    // Replaces the two triangles at e by four triangles at v. The halves of e keep its mark.
    void split_edge(EdgeId e, VertexId v);
    // Replaces the edge e = ab of the triangles (p, a, b) and (q, b, a) by the other diagonal pq, which is
    // unmarked. The triangle of e becomes (p, a, q), with e from a to q; that of its twin becomes (q, b, p),
    // with the twin from b to p.
    void flip(EdgeId e) noexcept;

    // Operations for those who build triangles themselves: a new triangle (a, b, c) has no neighbours yet.
    TriangleId add_triangle(VertexId a, VertexId b, VertexId c);
    void reserve_triangles(size_t more);
    void join(EdgeId e, EdgeId twin, int32_t mark) noexcept;
    // Moves the last triangle to the number of another one, which nothing is joined to.
    void move_last_to(TriangleId t) noexcept;

private:
    struct Triangle {
        std::array<VertexId, 3> corner;
        std::array<EdgeId, 3> twin;
        std::array<int32_t, 3> mark;
        bool inside;
    };
    [[nodiscard]] const Triangle &at(TriangleId t) const noexcept {
        return triangles_[static_cast<size_t>(t)];
    }
    [[nodiscard]] Triangle &at(TriangleId t) noexcept { return triangles_[static_cast<size_t>(t)]; }
    void set_apex(EdgeId e, VertexId v) noexcept {
        at(triangle_of(e)).corner[e & 3] = v;
        set_fan(v, e);
    }
    void set_fan(VertexId v, EdgeId e) noexcept { fans_[static_cast<size_t>(v + 1)] = e; }

    std::vector<GridPoint> points_;
    GridMetric metric_;
    std::vector<Triangle> triangles_;
    std::vector<EdgeId> fans_; // an edge with this apex: of the infinite vertex, then of all others
};

} // namespace nrb::mesh
