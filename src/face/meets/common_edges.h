// SPDX-License-Identifier: MIT
// Edges that two faces have in common.
#pragma once

#include "face/face.h"
#include "intersect/levels/level_meet.h"

#include <vector>

namespace nrb::face {

struct CommonEdge {
    // The edge in space and its curves in both domains, over common parameters. It runs along N_b x N_a or,
    // if both faces have the same tangent plane somewhere, along the loop of the first face. `deviation` is a
    // bound on the distances between the images of the curves and the edge; infinite if none is proven. It
    // has no nodes.
    intersect::MeetBranch branch;
    bool closes;
    // Common curves of both surfaces within this distance of the edge are taken for the edge: all that is
    // known of the edge does not tell them apart from it.
    double room;
};

// The edges whose coedges have the same key in both faces. The curves in the domains are those of the loops
// if these run over the parameters of the edge; else they are made from the edge. tolerance: that of the
// curves with which the edges are compared.
std::vector<CommonEdge> common_edges(const Face &a, const Face &b, double tolerance);

} // namespace nrb::face
