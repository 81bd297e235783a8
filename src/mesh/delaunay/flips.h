// SPDX-License-Identifier: MIT
// Flips that make a triangulation Delaunay again after a vertex was added (Lawson's algorithm). Marked edges
// stay.
#pragma once

#include "mesh/delaunay/triangle_net.h"

#include <vector>

namespace nrb::mesh {

// Precondition: the triangulation is Delaunay but for new triangles at a vertex v. Flips replace edges
// opposite of v, and no others, by edges at v. So all triangles that they change are at v in the end; and
// since each flip adds an edge at v, they terminate. Cost: linear in the number of triangles at v in the end.
// C. L. Lawson: Software for C1 surface interpolation, in: Mathematical Software III, 1977.
class StarFlips {
public:
    // All triangles at v are new.
    void run(TriangleNet &net, VertexId v);
    // Only one triangle is: flips start at its edge e, opposite of v.
    void run_beyond(TriangleNet &net, EdgeId e);

private:
    void flip_waiting(TriangleNet &net);

    std::vector<EdgeId> waiting_; // edges opposite of v
};

} // namespace nrb::mesh
