// SPDX-License-Identifier: MIT
// The curves in space that bound a face.
#pragma once

#include "face/face.h"

#include <vector>

namespace nrb::face {

// In the plane that covers the domain, and in space at equal parameters: exact, or null where the surface cannot be composed with it.
struct BoundaryCurve {
    SplinePtr plane, space;
    int32_t loop;        // -1: of none
    bool at_end = false; // of the domain, where no loop runs
};

// Of the loops, of segments that close gaps, and of ends of the domain without a curve. What runs over seams is in pieces,
// each in one copy of the domain.
std::vector<BoundaryCurve> boundary_curves(const Face &face);

// Where the domain closes up, though no curve need be there.
std::vector<BoundaryCurve> seam_curves(const Face &face);

} // namespace nrb::face
