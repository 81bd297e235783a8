// SPDX-License-Identifier: MIT
// Curves in the plane that covers a domain, cut at seams into parts that lie in the domain.
#pragma once

#include "face/covering.h"

#include <vector>

namespace nrb::face {

// A curve with the control points that are outside the domain set to its ends: on closed axes only if
// closed_too, since curves may run on there. off: raised to the largest such step along each axis.
SplinePtr set_inside(const Covering &covering, const SplinePtr &curve, bool closed_too, Point2 &off);

struct SeamParts {
    std::vector<SplinePtr> parts;
    Point2 off{}; // how far, at most, control points were off the domain, to which they are set
};

// The parts of a curve between seams, over the same parameters, each moved into the domain by periods, with
// its ends at seams set to these. None if a part is outside the domain by more than rounding.
SeamParts seam_parts(const Covering &covering, const SplinePtr &curve);

} // namespace nrb::face
