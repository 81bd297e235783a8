// SPDX-License-Identifier: MIT
// How intersection curves of a face and a surface continue through places where they cannot be separated.
#pragma once

#include "face/face.h"
#include "intersect/levels/level_meet.h"

namespace nrb::face {

// The branches of an intersection end at parts in which a derivative vanishes or the surfaces only touch.
// Each such part, and each part that is undecided but no larger than some tolerances, counts as one place.
// The branches that end there are continued to the pole of the face in it, or to its middle; if exactly two
// end there, one is continued to the end of the other.
struct Bridges {
    std::vector<SplinePtr> curves; // dividing curves, in the plane that covers the domain
    std::vector<bool> nodes;       // by nodes of the meet: whether nothing is left open there
};

// For all branches except those along which the surfaces touch. They are continued by segments in the domain
// whose images are, at samples, within the tolerance of the surface; where one is not, no branch of the
// place is continued.
Bridges bridges(const Face &face, const Spline &surface, const intersect::Meet &meet, double tolerance);

} // namespace nrb::face
