// SPDX-License-Identifier: MIT
// Which faces hang together by their edges.
#pragma once

#include "io/written/topology.h"

#include <vector>

namespace nrb::io {

struct Shell {
    int64_t part = 0;
    std::vector<size_t> faces; // in the order of the model
    // Each edge is used twice, once in each direction as the outer normals see it, so that the faces enclose something.
    bool closed = true;
    // As its faces have them.
    int64_t solid = -1;
    bool in_void = false;
    // Of a closed outer shell: the closed shells of voids in the same solid, which others do not have.
    std::vector<size_t> voids{};
    bool inner = false; // it is a void of another one
};

// In the order of their first faces; faces of different parts do not hang together, nor do those of different solids or voids.
std::vector<Shell> shells_of(const model::Model &model, const Topology &topology);

} // namespace nrb::io
