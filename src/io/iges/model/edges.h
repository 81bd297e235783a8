// SPDX-License-Identifier: MIT
// Edges and vertices of a model.
#pragma once

#include "io/iges/geometry/geometry.h"
#include "io/iges/model/face_source.h"
#include "io/iges/model/topology.h"
#include "model/model.h"

#include <functional>
#include <map>
#include <utility>

namespace nrb::io::iges {

// Adds the edges of all lists (504), with their vertices, to the model. Edges that cannot be read become
// damages.
EdgeLists read_edges(Geometry &geometry, const TopologyEntities &topology, model::Model &model,
                     std::vector<Damage> &damages);

// Adds the edges that belong to a face alone to the model, with vertices where two of them meet. Their keys
// begin at that of the next edge of the model. Throws what face::edge_of() throws.
void add_own_edges(Geometry &geometry, const face::Face &face, const std::vector<OwnEdge> &edges,
                   int64_t part, model::Model &model);

} // namespace nrb::io::iges
