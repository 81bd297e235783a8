// SPDX-License-Identifier: MIT
// In which order edges leave a node.
#pragma once

#include "face/arrange/arrangement.h"

namespace nrb::face {

// Edges that leave a node, sorted counterclockwise. Those that leave it in one direction, whatever their curvatures, differ in a
// column that both come to: edges meet nowhere but in nodes. Throws Status::not_converged where rounding hides that.
void sort_around_node(const Arrangement &arrangement, std::vector<DirectedEdge> &edges);

} // namespace nrb::face
