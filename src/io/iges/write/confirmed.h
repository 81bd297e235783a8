// SPDX-License-Identifier: MIT
// Determines which shapes survive a round trip: readers reconstruct the same splines from them.
#pragma once

#include "io/iges/write/write_topology.h"

#include <functional>
#include <string>

namespace nrb::io::iges {

// The shapes of edges and faces for which there are entities, whatever readers make of them. `tolerance`:
// within which ends meet.
StatedShapes statable_shapes(const model::Model &model, const Topology &topology, double tolerance);

// Keeps only those shapes from which readers make the same spline, and a shape that is written in the same
// way; straight edges may have other parameters. write(stated) returns a file of the edges. If a shape is
// read as another shape of the same spline, that shape replaces it and is tried in turn.
using WriteEdges = std::function<std::string(const StatedShapes &stated)>;
void confirm_edges(const WriteEdges &write, const Topology &topology, double tolerance, StatedShapes &stated);

// The same for faces, with the curves in their domains. `text`: a file of them without names; `pointers`:
// those of the faces.
void confirm_faces(const std::string &text, const model::Model &model, const std::vector<int64_t> &pointers,
                   StatedShapes &stated);

} // namespace nrb::io::iges
