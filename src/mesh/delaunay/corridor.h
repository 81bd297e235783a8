// SPDX-License-Identifier: MIT
// Makes a segment an edge of a constrained Delaunay triangulation: the triangles that it crosses, its
// corridor, are replaced by triangulations of the polygons on both sides of it.
#pragma once

#include "mesh/delaunay/flips.h"
#include "mesh/delaunay/triangle_net.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::mesh {

// The segment is the base of both polygons. Each corner sees a point of the base, along an edge that the
// segment crossed. So every convex corner is an ear, and stays one while other ears are cut off. First all
// ears are cut off; then they come back, the last one first, each as a vertex that is added, by flips, to the
// Delaunay triangulation of the rest of the polygon.
//
// With ears in random order, an ear takes on average as many flips as a corner has edges; in a fixed order,
// points on an arc can take as many flips as there are pairs of them. Triangles outside of the corridor need
// not change: a new segment only blocks lines of sight, so that vertices that see each other afterwards did
// so before.
//
// G. Toussaint, D. Avis: On a convex hull algorithm for polygons and its application to triangulation
// problems, Pattern Recognition 15, 1982.
// L. P. Chew: Building Voronoi diagrams for convex polygons in linear expected time, 1990.
class Corridor {
public:
    // `crossed`: the edges that a segment between two vertices crosses, in this order, each as a side of the
    // triangle that the segment comes from. None of them may be marked. The new edge gets the mark, which is
    // not negative. The new triangles take the numbers of the old ones.
    void open(TriangleNet &net, std::span<const EdgeId> crossed, int32_t mark);

private:
    // A corner of a polygon, and the side from it to the next corner.
    struct Corner {
        VertexId vertex;
        // The twin of this edge is outside of the polygon. It is an edge of an old triangle inside, or of the
        // ear that was cut off there, and then its own twin for the time being.
        EdgeId side;
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

    std::vector<TriangleId> old_;      // the triangles of the corridor
    std::vector<EdgeId> right_, left_; // sides of each polygon, counterclockwise, without the base
    std::vector<Corner> corners_;
    std::vector<int32_t> waiting_; // corners that may be ears
    uint64_t draw_ = 1;            // the last random number
    StarFlips flips_;
};

} // namespace nrb::mesh
