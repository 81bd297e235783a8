// SPDX-License-Identifier: MIT
// Ways through triangles: to the one that holds a place, and along a segment.
#pragma once

#include "mesh/delaunay/triangle_net.h"

#include <vector>

namespace nrb::mesh {

// Where a place lies: inside of the triangle of an edge (beyond the real edge of it, if that is a ghost), on the edge without
// its ends, or at the apex of the edge.
struct GridPlace {
    enum class Kind { triangle, edge, vertex };
    Kind kind;
    EdgeId edge;
};
// Walks from a triangle that is no ghost: over edges that p is beyond, some thousand at most where the triangulation is not
// Delaunay and such a walk may go round for ever, and then along a straight line from a vertex.
GridPlace locate(const TriangleNet &net, const GridPoint &p, TriangleId start);

// The part of a segment from one vertex to the next one on it.
struct SegmentPart {
    VertexId to;
    EdgeId along; // the edge that it is, with `to` at its end, or -1 if it crosses edges
};
// The first part of the segment from a to b. Adds to `crossed` the edges that it crosses in this order, each seen from where
// it comes. Cost: of the triangles at a and of those that it passes.
SegmentPart first_part(const TriangleNet &net, VertexId a, VertexId b, std::vector<EdgeId> &crossed);

// Which of two vertices has fewer triangles around it: in a planar graph, the sum of these over all edges is linear, whereas
// that of all triangles around first ends is not. Cost: of the fewer triangles.
VertexId of_fewer_triangles(const TriangleNet &net, VertexId a, VertexId b);

} // namespace nrb::mesh
