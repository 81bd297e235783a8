// SPDX-License-Identifier: MIT
// The values of owners on both sides of the edges of an arrangement.
#pragma once

#include "face/arrange/arrangement.h"

#include <vector>

namespace nrb::face {

// The values of owners, sorted by the numbers of these, without zeros.
struct SideValues {
    PassedSums left, right;
};

// The values beside all edges. at_corner: the values at the corner of a domain both of whose axes close;
// empty for others. Each edge is probed at a place away from all other edges; edges that continue each other
// through nodes where no other edge ends are probed once. Throws Status::not_converged where rounding hides
// the values at all places that are tried.
std::vector<SideValues> values_beside(const Arrangement &arrangement, const PassedSums &at_corner);

// The values at the upper end of the column at u, from those at the corner.
PassedSums values_at_top(const Arrangement &arrangement, const PassedSums &at_corner, double u);

} // namespace nrb::face
