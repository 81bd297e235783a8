// SPDX-License-Identifier: MIT
// Shells: sets of faces that are connected by their edges.
#pragma once

#include "io/written/topology.h"

#include <vector>

namespace nrb::io {

struct Shell {
    int64_t part = 0;
    std::vector<size_t> faces; // in the order of the model
    // Whether each edge is used exactly twice, once in each direction with respect to the outer normals, so
    // that the faces enclose a volume.
    bool closed = true;
    // The solid and the side of its faces, as in model::ModelFace.
    int64_t solid = -1;
    bool in_void = false;
    // For the first closed outer shell of a solid: the closed shells of voids in the same solid. Others have
    // none.
    std::vector<size_t> voids{};
    bool inner = false; // whether it is among the voids of another shell
};

// The shells in the order of their first faces. Faces that share an edge are connected if they belong to the
// same part and the same solid, and both or neither to a void.
std::vector<Shell> shells_of(const model::Model &model, const Topology &topology);

} // namespace nrb::io
