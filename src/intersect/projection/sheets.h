// SPDX-License-Identifier: MIT
// Cuts projected curves into sheets, on which the parameter t of the curve rises.
#pragma once

#include "intersect/levels/level_meet.h"
#include "numeric/vector3.h"

namespace nrb::intersect {

struct ProjectedCurve {
    const Spline &lines;      // (t, h) -> C(t) + h direction: the second surface of the branches
    const Vector3 &direction; // of length 1; 0 for normal projection
    const Spline &surface;    // the first surface of the branches
};

// Cuts branches where t has a local extremum (a turn), and directs each part along rising t. A turn does not
// count unless t goes back over a part of the curve that is longer, across the direction if there is one,
// than four deviations of the branch. A closed branch with turns is cut at these alone, not where its
// parameter begins.
Meet cut_in_sheets(Meet meet, const ProjectedCurve &projected);

} // namespace nrb::intersect
