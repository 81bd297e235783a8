// SPDX-License-Identifier: MIT
// Determines which curves and surfaces are parts of faces.
#pragma once

#include "io/iges/model/topology.h"

namespace nrb::io::iges {

// Sets the flag of each directory entry that a face, an edge or a boundary of a face refers to, whether it
// can be read or not. Curves on surfaces (142) and boundaries (141) that no face refers to use nothing.
void mark_used(const TopologyEntities &topology, const Directory &directory, std::vector<bool> &used);

} // namespace nrb::io::iges
