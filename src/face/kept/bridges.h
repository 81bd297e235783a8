// SPDX-License-Identifier: MIT
// How the curves in which a surface meets a face go on where they are not told apart.
#pragma once

#include "face/face.h"
#include "intersect/levels/level_meet.h"

namespace nrb::face {

// Meets tell branches as far as parts in which a derivative vanishes, or in which surfaces only touch. Of such parts, and of those
// that are left open but no larger than some tolerances, each is a place: branches that end there are continued to the pole of the
// face that is in it, or to its middle; if one comes and one leaves, from the one to the other.
struct Bridges {
    std::vector<SplinePtr> curves; // that divide the face, in the plane that covers the domain
    std::vector<bool> nodes;       // those of which nothing is left open
};

// Of the branches, but those along which surfaces touch. What they are continued by are segments no farther from the surface than
// the tolerance, or it is nothing.
Bridges bridges(const Face &face, const Spline &surface, const intersect::Meet &meet, double tolerance);

} // namespace nrb::face
