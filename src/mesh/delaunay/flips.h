// SPDX-License-Identifier: MIT
// Flips that make a triangulation Delaunay, except where edges are marked, after a vertex was added.
#pragma once

#include "mesh/delaunay/triangle_net.h"

#include <vector>

namespace nrb::mesh {

// What was Delaunay without the triangles at a vertex v, where they are new, is so again. Flips turn edges opposite of v into
// edges at v, and no others, so that all triangles that they change are at v in the end; as each of them adds an edge
// at v, they come to an end. Cost: of the triangles that are at v in the end.
// C. L. Lawson: Software for C1 surface interpolation, in: Mathematical Software III, 1977.
class StarFlips {
public:
    // Of all triangles at v.
    void run(TriangleNet &net, VertexId v);
    // Of one triangle, beyond the edge opposite of v.
    void run_beyond(TriangleNet &net, EdgeId e);

private:
    void flip_waiting(TriangleNet &net);

    std::vector<EdgeId> waiting_; // opposite of v
};

} // namespace nrb::mesh
