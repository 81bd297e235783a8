// SPDX-License-Identifier: MIT
// The edges of a model as its faces use them.
#pragma once

#include "model/model.h"

#include <vector>

namespace nrb::io {

struct OrientedEdge {
    size_t edge;
    bool along;      // whether the loop runs along the edge
    SplinePtr curve; // in the domain, as the loop runs
};

// The edges of the model, and behind them those that it does not have: of loops that no edges were given for, and of the segments
// that close loops whose gaps were kept, so that all loops are closed. Every edge has its vertices.
struct Topology {
    std::vector<model::Edge> edges;
    std::vector<Vector3> vertices;
    std::vector<std::vector<std::vector<OrientedEdge>>> loops; // of each face
};

// Throws what face::edge_of() does.
Topology topology_of(const model::Model &model);

} // namespace nrb::io
