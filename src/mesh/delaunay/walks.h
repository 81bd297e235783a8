// SPDX-License-Identifier: MIT
// Walks through a triangulation: point location, and the edges that a segment crosses.
#pragma once

#include "mesh/delaunay/triangle_net.h"

#include <vector>

namespace nrb::mesh {

// Where a point lies: strictly inside the triangle of an edge (for a ghost: beyond its edge of the hull), on
// the edge without its ends, or at the apex of the edge.
struct GridPlace {
    enum class Kind { triangle, edge, vertex };
    Kind kind;
    EdgeId edge;
};
// Locates p by walking from a triangle that is no ghost: across edges that p is beyond (visibility walk).
// Where the triangulation is not Delaunay such a walk may never end, so that after some thousand steps a walk
// along a straight line from a vertex takes over.
GridPlace locate(const TriangleNet &net, const GridPoint &p, TriangleId start);

// The part of a segment from one vertex to the next one on it.
struct SegmentPart {
    VertexId to;
    EdgeId along; // the edge that it is, with `to` at its end, or -1 if it crosses edges
};
// The first part of the segment from a to b. Adds to `crossed` the edges that it crosses, in this order, each
// as a side of the triangle that it comes from. Cost: linear in the number of triangles at a and of those
// that it passes.
SegmentPart first_part(const TriangleNet &net, VertexId a, VertexId b, std::vector<EdgeId> &crossed);

// Which of two vertices has fewer triangles around it. In a planar graph, the sum of the smaller degree over
// all edges is linear in their number, whereas that of the degree of the first end is not. Cost: linear in
// the smaller degree.
VertexId of_fewer_triangles(const TriangleNet &net, VertexId a, VertexId b);

} // namespace nrb::mesh
