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

// The edges of all lists (504), with their vertices, added to the model. Those that could not be read become damages.
EdgeLists read_edges(Geometry &geometry, const TopologyEntities &topology, model::Model &model,
                     std::vector<Damage> &damages);

// The edges that a face alone has, added to the model with vertices where two of them meet. Their keys begin at that of the next
// edge of the model. Throws what face::edge_of() does.
void add_own_edges(Geometry &geometry, const face::Face &face, const std::vector<OwnEdge> &edges,
                   int64_t part, model::Model &model);

} // namespace nrb::io::iges
