// SPDX-License-Identifier: MIT
// Constrained Delaunay triangulations of points on a grid: exact, for all degenerate positions too.
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

// Triangles have the numbers 0, ..., size() - 1. Ghosts are among them: triangles outside of the edges of the
// hull, whose third corner is TriangleNet::infinite. Edge k of a triangle is opposite of its corner k. An
// edge 'stays' if it is constrained. Arguments are points of the grid and valid numbers of vertices and
// triangles. After CallEnded or std::bad_alloc a triangulation can only be destroyed.
class Triangulation {
public:
    // The Delaunay triangulation of points; equal ones become one vertex. If all are on one line, there are
    // no triangles, not even ghosts. Cost: about 1 us a point, in whatever order they come and however many
    // lie on one circle. Throws Status::overflow for more points than TriangleNet::most_vertices.
    explicit Triangulation(std::span<const GridPoint> points, const GridMetric &metric = {});
    [[nodiscard]] VertexId vertex_of(size_t point) const noexcept { return vertex_of_[point]; }

    struct Segment {
        VertexId from, to;
        int32_t label; // from 0 to most_label
        bool border;   // whether it separates inside from outside
    };
    static constexpr int32_t most_label = (int32_t{1} << 30) - 1;
    // A segment that crosses an earlier one, and the edge of that one.
    struct Crossing {
        size_t segment;
        int32_t label;
        VertexId from, to;
    };
    // Inserts segments, one after the other, as edges that stay, divided at the vertices on them; the rest
    // stays constrained Delaunay. An edge keeps its first label; borders that lie on each other cancel in
    // pairs. A segment that crosses an earlier one between vertices is left out, and returned with one edge
    // that it crosses. Without triangles, nothing happens. If there are borders among the segments,
    // mark_inside() has to be called again. Expected cost: linear in the number of triangles that the
    // segments pass, and of those around the vertices on them, where of the two ends of a segment the one
    // with fewer triangles counts.
    std::vector<Crossing> constrain(std::span<const Segment> segments);

    // Marks the triangles that are inside: starting outside of the hull, crossing a border leads from outside
    // to inside or back. Returns whether all ways agree, as they do if an even number of borders ends at each
    // vertex, such as in loops.
    bool mark_inside();
    [[nodiscard]] bool inside(TriangleId t) const noexcept { return net_.inside(t); }

    // Inserts a vertex, located by walking from triangle `near`, and flips edges that do not stay. Fills
    // `changed` with the triangles around it but for ghosts: these are the ones that are new or have other
    // corners. What was inside stays so; new triangles beyond the hull are outside. Returns nothing, and
    // inserts nothing, if p is on a vertex, or on an edge that stays unless `split_segments` is set, or if
    // there are no triangles.
    std::optional<VertexId> insert(const GridPoint &p, TriangleId near, bool split_segments,
                                   std::vector<TriangleId> &changed);
    // Replaces edge k of a triangle by the other diagonal, and adds both triangles to `changed`. Returns
    // false, and does nothing, for an edge that stays, and where the quadrilateral is not strictly convex.
    bool flip(TriangleId t, int k, std::vector<TriangleId> &changed);

    [[nodiscard]] TriangleId size() const noexcept { return net_.size(); }
    [[nodiscard]] const std::vector<GridPoint> &vertices() const noexcept { return net_.points(); }
    [[nodiscard]] bool ghost(TriangleId t) const noexcept { return net_.ghost(t); }
    // The corners of a triangle, counterclockwise.
    [[nodiscard]] std::array<VertexId, 3> corners(TriangleId t) const noexcept {
        const EdgeId e = TriangleNet::edge_of(t, 0);
        return {net_.apex(e), net_.apex(e + 1), net_.apex(e + 2)};
    }
    [[nodiscard]] TriangleId neighbour(TriangleId t, int k) const noexcept {
        return TriangleNet::triangle_of(net_.twin(TriangleNet::edge_of(t, k)));
    }
    // Whether an edge stays; and its label, -1 if it does not stay.
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
