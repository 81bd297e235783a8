// SPDX-License-Identifier: MIT
// Edges that two faces have in common.
#pragma once

#include "face/face.h"
#include "intersect/levels/level_meet.h"

#include <vector>

namespace nrb::face {

struct CommonEdge {
    // The edge with its curves in both domains, over its parameters: along N_b x N_a, or along the loop of the first face if both have
    // the same tangent plane somewhere. A bound of how far all are apart, if it can be proven, is its deviation. Without nodes.
    intersect::MeetBranch branch;
    bool closes;
    // How near to it curves of both surfaces are which, for all that is known of the edge, are the edge.
    double room;
};

// Those whose curves in the loops of both have one key. The curves in the domains are those of the loops where these run over the
// parameters of the edge, else ones that are made under it. `tolerance` of the curves that they are compared with.
std::vector<CommonEdge> common_edges(const Face &a, const Face &b, double tolerance);

} // namespace nrb::face
