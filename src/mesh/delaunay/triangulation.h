// SPDX-License-Identifier: MIT
// Constrained Delaunay triangulations of points on a grid: exact, whatever lies on whatever.
#pragma once

#include "mesh/delaunay/corridor.h"
#include "mesh/delaunay/flips.h"
#include "mesh/delaunay/triangle_net.h"
#include "mesh/delaunay/walks.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace nrb::mesh {

// Triangles are numbered from 0 to size(), ghosts among them: triangles outside of the edges of the hull, whose third corner is
// TriangleNet::infinite. Edge k of a triangle is that opposite of its corner k. What is given are points of
// the grid, numbers of vertices, and of triangles; after CallEnded or std::bad_alloc a triangulation can only be destroyed.
class Triangulation {
public:
    // The Delaunay triangulation of points; equal ones become one vertex. All on one line: no triangles, not even ghosts.
    // Cost: about 1 us a point, whatever order they come in and however many lie on one circle. Refuses more
    // points than TriangleNet::most_vertices.
    explicit Triangulation(std::span<const GridPoint> points, const GridMetric &metric = {});
    [[nodiscard]] VertexId vertex_of(size_t point) const noexcept { return vertex_of_[point]; }

    struct Segment {
        VertexId from, to;
        int32_t label; // from 0 to most_label
        bool border;   // whether one side of it is inside and the other one outside
    };
    static constexpr int32_t most_label = (int32_t{1} << 30) - 1;
    // A segment that crosses an earlier one, and the edge of that.
    struct Crossing {
        size_t segment;
        int32_t label;
        VertexId from, to;
    };
    // Makes segments edges that stay, one after the other, divided at the vertices on them; what is between these is Delaunay as
    // far as they let it. An edge keeps its first label; borders that lie on each other cancel in pairs. A segment
    // that crosses an earlier one between vertices is left out and told with one such edge. Without triangles, nothing happens.
    // Which triangles are inside has to be asked again if there are borders among the segments. Cost, expected: of
    // the triangles that segments pass, and of those around vertices on them and around that end where there are fewer.
    std::vector<Crossing> constrain(std::span<const Segment> segments);

    // From outside of the hull, each border leads from outside to inside or back. Returns whether it does so on all ways:
    // true if an even number of borders ends at each vertex, as at those of loops.
    bool mark_inside();
    [[nodiscard]] bool inside(TriangleId t) const noexcept { return net_.inside(t); }

    // A new vertex, found by walking from triangle `near`, and flips as far as edges that stay let them. Fills `changed` with the
    // triangles around it, which are those that are new or have other corners, without ghosts. Triangles inside stay so; those
    // beyond the hull are outside. Nothing on a vertex, without triangles, and on an edge that stays, unless
    // that may be split.
    std::optional<VertexId> insert(const GridPoint &p, TriangleId near, bool split_segments,
                                   std::vector<TriangleId> &changed);
    // The other diagonal instead of edge k of a triangle; adds both triangles to `changed`. Refused on edges
    // that stay, and where the quadrilateral is not strictly convex.
    bool flip(TriangleId t, int k, std::vector<TriangleId> &changed);

    [[nodiscard]] TriangleId size() const noexcept { return net_.size(); }
    [[nodiscard]] const std::vector<GridPoint> &vertices() const noexcept { return net_.points(); }
    [[nodiscard]] bool ghost(TriangleId t) const noexcept { return net_.ghost(t); }
    // Counterclockwise.
    [[nodiscard]] std::array<VertexId, 3> corners(TriangleId t) const noexcept {
        const EdgeId e = TriangleNet::edge_of(t, 0);
        return {net_.apex(e), net_.apex(e + 1), net_.apex(e + 2)};
    }
    [[nodiscard]] TriangleId neighbour(TriangleId t, int k) const noexcept {
        return TriangleNet::triangle_of(net_.twin(TriangleNet::edge_of(t, k)));
    }
    // Whether an edge stays, and its label or -1.
    [[nodiscard]] bool constrained(TriangleId t, int k) const noexcept { return label(t, k) >= 0; }
    [[nodiscard]] int32_t label(TriangleId t, int k) const noexcept {
        return net_.mark(TriangleNet::edge_of(t, k)) >> 1;
    }
    [[nodiscard]] bool border(TriangleId t, int k) const noexcept {
        return is_border(TriangleNet::edge_of(t, k));
    }

private:
    [[nodiscard]] bool is_border(EdgeId e) const noexcept {
        return net_.mark(e) >= 0 && (net_.mark(e) & 1) != 0;
    }
    void build(std::span<const VertexId> order);
    void add(VertexId v, const GridPlace &place);
    [[nodiscard]] TriangleId real_at(TriangleId t) const noexcept;
    [[nodiscard]] std::optional<EdgeId> first_crossed(VertexId a, VertexId b);
    void recover(VertexId a, VertexId b, int32_t mark);
    bool cross_into(EdgeId e, std::vector<bool> &reached, std::vector<TriangleId> &waiting);

    TriangleNet net_;
    std::vector<VertexId> vertex_of_;
    StarFlips star_flips_;
    Corridor corridor_;
    std::vector<EdgeId> crossed_;
};

} // namespace nrb::mesh
