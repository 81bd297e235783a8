// SPDX-License-Identifier: MIT
// The curves that bound a face, in its domain and in space.
#pragma once

#include "face/face.h"

#include <vector>

namespace nrb::face {

// A curve in the plane that covers the domain, and its exact image in space at equal parameters: the
// composition with the surface. `space` is null where the two cannot be composed.
struct BoundaryCurve {
    SplinePtr plane, space;
    int32_t loop;        // -1: none
    bool at_end = false; // at an end of the domain along which no loop runs
};

// The curves of the loops, segments that close gaps, and the parts of the ends of the domain that bound the
// face without a curve. What crosses a seam is divided into pieces, each of which lies in one copy of the
// domain.
std::vector<BoundaryCurve> boundary_curves(const Face &face);

// The seams at which the domain closes up, whether the face has curves there or not.
std::vector<BoundaryCurve> seam_curves(const Face &face);

} // namespace nrb::face
