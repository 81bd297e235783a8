// SPDX-License-Identifier: MIT
// The parts of projected curves on which the parameter of the curve rises.
#pragma once

#include "intersect/levels/level_meet.h"
#include "numeric/vector3.h"

namespace nrb::intersect {

struct ProjectedCurve {
    const Spline &lines;      // on which branches have their second curves: (t, h) -> C(t) + h direction
    const Vector3 &direction; // of length 1, or 0
    const Spline &surface;    // over whose domain the first curves are
};

// Branches cut where t turns, each of them along rising t. Turns of t along no more of the curve, across the direction if there is one, than what
// four deviations of the branch may make are none. A closed branch with turns is cut there only.
Meet cut_in_sheets(Meet meet, const ProjectedCurve &projected);

} // namespace nrb::intersect
