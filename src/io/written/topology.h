// SPDX-License-Identifier: MIT
// The edges of a model, as the loops of its faces use them in a file.
#pragma once

#include "model/model.h"

#include <vector>

namespace nrb::io {

struct OrientedEdge {
    size_t edge;
    bool along;      // whether the loop runs in the direction of the edge
    SplinePtr curve; // in the domain, in the direction of the loop
};

// The edges of the model, followed by those that it lacks: edges of curves of loops for which no edge was
// given, and edges of the segments that close loops whose gaps were kept. So all loops are closed, and every
// edge has its vertices.
struct Topology {
    std::vector<model::Edge> edges;
    std::vector<Vector3> vertices;
    std::vector<std::vector<std::vector<OrientedEdge>>> loops; // for each face
};

// Throws what face::edge_of() throws.
Topology topology_of(const model::Model &model);

} // namespace nrb::io
