// SPDX-License-Identifier: MIT
// Which shapes readers make the same splines of.
#pragma once

#include "io/iges/write/write_topology.h"

#include <string>

namespace nrb::io::iges {

// The shapes of edges and faces that there are entities for, whatever is read of them. `tolerance`: at which ends meet.
StatedShapes statable_shapes(const model::Model &model, const Topology &topology, double tolerance);

// Leaves those whose splines are in what is read of `text`: a file of the edges that are written with these shapes.
void confirm_edges(const std::string &text, const Topology &topology, StatedShapes &stated);
// The same for faces, with the curves in their domains; the pointers of the faces, which have no names in the file.
void confirm_faces(const std::string &text, const model::Model &model, const std::vector<int64_t> &pointers,
                   StatedShapes &stated);

} // namespace nrb::io::iges
