// SPDX-License-Identifier: MIT
// Which shapes readers make the same splines of.
#pragma once

#include "io/iges/write/write_topology.h"

#include <functional>
#include <string>

namespace nrb::io::iges {

// The shapes of edges and faces that there are entities for, whatever is read of them. `tolerance`: at which ends meet.
StatedShapes statable_shapes(const model::Model &model, const Topology &topology, double tolerance);

// Leaves those of which readers make the same spline, and a shape that is written in the same way; straight edges may have other
// parameters. write(stated): a file of the edges. Another shape of the same spline takes the place of one that is written in another
// way.
using WriteEdges = std::function<std::string(const StatedShapes &stated)>;
void confirm_edges(const WriteEdges &write, const Topology &topology, double tolerance, StatedShapes &stated);

// The same for faces, with the curves in their domains. `text`: a file of them without names; `pointers`: to them.
void confirm_faces(const std::string &text, const model::Model &model, const std::vector<int64_t> &pointers,
                   StatedShapes &stated);

} // namespace nrb::io::iges
