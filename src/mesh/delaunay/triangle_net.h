// SPDX-License-Identifier: MIT
// Triangles with their neighbours and the marks of their edges, and the steps that change them.
#pragma once

#include "mesh/delaunay/grid_point.h"

#include <array>
#include <cstddef>
#include <vector>

namespace nrb::mesh {

using VertexId = int32_t;
using TriangleId = int32_t;
// 4 t + k: the edge of triangle t opposite of its corner k, seen from t, with t to its left.
using EdgeId = int32_t;

// A triangulation of the convex hull of its vertices. Outside of each edge of the hull stands a ghost, a triangle whose third
// corner is infinitely far away, so that every edge has two sides and every vertex a closed fan of triangles.
class TriangleNet {
public:
    static constexpr VertexId infinite = -1;
    // There are up to twice as many triangles as vertices, and their edges are numbered in 31 bits.
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
    // The edges of a triangle, counterclockwise.
    static EdgeId next(EdgeId e) noexcept { return (e & 3) == 2 ? e - 2 : e + 1; }
    static EdgeId previous(EdgeId e) noexcept { return (e & 3) == 0 ? e + 2 : e - 1; }
    [[nodiscard]] EdgeId twin(EdgeId e) const noexcept { return at(triangle_of(e)).twin[e & 3]; }
    [[nodiscard]] VertexId apex(EdgeId e) const noexcept { return at(triangle_of(e)).corner[e & 3]; }
    [[nodiscard]] VertexId from(EdgeId e) const noexcept { return apex(next(e)); }
    [[nodiscard]] VertexId to(EdgeId e) const noexcept { return apex(previous(e)); }
    // An edge with this apex, and the next one around it, counterclockwise.
    [[nodiscard]] EdgeId fan_of(VertexId v) const noexcept { return fans_[static_cast<size_t>(v + 1)]; }
    [[nodiscard]] EdgeId next_in_fan(EdgeId e) const noexcept { return next(twin(next(e))); }

    // A number that an edge carries.
    [[nodiscard]] int32_t mark(EdgeId e) const noexcept { return at(triangle_of(e)).mark[e & 3]; }
    void set_mark(EdgeId e, int32_t mark) noexcept;
    [[nodiscard]] bool inside(TriangleId t) const noexcept { return at(t).inside; }
    void set_inside(TriangleId t, bool inside) noexcept { at(t).inside = inside; }

    // Positive if p is to the left of an edge between two vertices.
    [[nodiscard]] int64_t side(EdgeId e, const GridPoint &p) const noexcept {
        return orientation(point(from(e)), point(to(e)), p);
    }
    // Whether p is inside of the circle of a triangle. That of a ghost is the half plane beyond its edge.
    [[nodiscard]] bool circle_contains(TriangleId t, const GridPoint &p) const noexcept;
    // Whether the triangles at an edge are the halves of a strictly convex quadrilateral.
    [[nodiscard]] bool convex_at(EdgeId e) const noexcept;

    // The first triangle, counterclockwise, with its ghosts.
    void start(VertexId a, VertexId b, VertexId c);
    VertexId add_point(const GridPoint &p);
    // Three triangles at v instead of that of e, which keeps e.
    void split_triangle(EdgeId e, VertexId v);
    // Four triangles at v instead of the two at e; the halves of e keep its mark.
    void split_edge(EdgeId e, VertexId v);
    // The other diagonal. The triangle of e keeps e's apex opposite of e, the other one keeps the apex of the twin, and finds
    // the apex of e in place of from(e). What the new diagonal carries is unmarked.
    void flip(EdgeId e) noexcept;

    // Pieces for those who build triangles of their own: the new triangle (a, b, c) has no neighbours yet.
    TriangleId add_triangle(VertexId a, VertexId b, VertexId c);
    void reserve_triangles(size_t more);
    void join(EdgeId e, EdgeId twin, int32_t mark) noexcept;
    // The last triangle takes the number of one that nobody is joined to.
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
    std::vector<EdgeId> fans_; // of the infinite vertex, then of all others
};

} // namespace nrb::mesh
