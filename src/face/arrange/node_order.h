// SPDX-License-Identifier: MIT
// The cyclic order of edges around a node.
#pragma once

#include "face/arrange/arrangement.h"

namespace nrb::face {

// Sorts edges that leave a node counterclockwise. Edges that leave it in the same quadrant, tangent ones of
// any curvature included, are compared in a column that both reach: since edges meet only at nodes, the one
// that is above there is above everywhere. Throws Status::not_converged where rounding hides the order.
void sort_around_node(const Arrangement &arrangement, std::vector<DirectedEdge> &edges);

} // namespace nrb::face
