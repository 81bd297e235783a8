// SPDX-License-Identifier: MIT
// A segment that becomes an edge: the triangles that it crosses give way to others on both sides of it.
#pragma once

#include "mesh/delaunay/flips.h"
#include "mesh/delaunay/triangle_net.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::mesh {

// The polygons on both sides are seen from the segment, their base: each corner sees a point of it, along an edge that was
// crossed. So every convex corner is an ear, and stays so when others are cut off. What was cut off last comes back first, and
// each ear that comes back is a vertex that is added to a Delaunay triangulation of the rest.
// With ears in random order, that takes as many flips as corners have edges on average; in a fixed order, points on an arc can
// take as many as there are pairs of them. Nothing else has to change, because whatever sees another thing after a
// segment came has seen it before.
// G. Toussaint, D. Avis: On a convex hull algorithm for polygons and its application to triangulation problems, Pattern
// Recognition 15, 1982. L. P. Chew: Building Voronoi diagrams for convex polygons in linear expected time, 1990.
class Corridor {
public:
    // Edges that a segment between two vertices crosses, in this order, each seen from where it comes; none is marked. The
    // new edge carries the mark, which is not negative, and the triangles keep their numbers.
    void open(TriangleNet &net, std::span<const EdgeId> crossed, int32_t mark);

private:
    // A corner of a polygon, and the side from it to the next corner.
    struct Corner {
        VertexId vertex;
        EdgeId side; // of a triangle within the polygon, whose twin is or will be beyond
        int32_t previous, next;
        bool cut;
    };
    void find_sides(const TriangleNet &net, std::span<const EdgeId> crossed);
    EdgeId cut_ears(TriangleNet &net, std::span<const EdgeId> sides);
    void set_corners(const TriangleNet &net, std::span<const EdgeId> sides);
    int32_t take_waiting();
    [[nodiscard]] bool is_ear(const TriangleNet &net, int32_t i) const noexcept;
    void cut(TriangleNet &net, int32_t i);
    void return_ears(TriangleNet &net, TriangleId first_ear);

    std::vector<TriangleId> old_;
    std::vector<EdgeId> right_, left_; // counterclockwise around each polygon, without the base
    std::vector<Corner> corners_;
    std::vector<int32_t> waiting_; // corners that may be ears
    uint64_t draw_ = 1;            // of the last ear
    StarFlips flips_;
};

} // namespace nrb::mesh
