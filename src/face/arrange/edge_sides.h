// SPDX-License-Identifier: MIT
// What lies at the sides of the edges of an arrangement.
#pragma once

#include "face/arrange/arrangement.h"

#include <vector>

namespace nrb::face {

// The values of owners, by their numbers, without those that are 0.
struct SideValues {
    PassedSums left, right;
};

// Of all edges, if there are so many around the corner of a domain both of whose axes close: at a place of each that is away from all others, once for edges that go on in each other alone. Throws
// Status::not_converged where rounding hides that everywhere.
std::vector<SideValues> values_beside(const Arrangement &arrangement, const PassedSums &at_corner);

// At the upper end of the column at u, from what lies at the corner.
PassedSums values_at_top(const Arrangement &arrangement, const PassedSums &at_corner, double u);

} // namespace nrb::face
