// SPDX-License-Identifier: MIT
// What of the curves on a surface lies in a face.
#pragma once

#include "face/face.h"
#include "intersect/levels/level_meet.h"

namespace nrb::face {

// The parts of the branches of a meet of the face's surface that are inside of its loops, by where their curves in the parameter
// domain cross those of the loops (curve_curve()); they end in nodes on the border. A closed branch that is cut is cut where it
// begins as well, in a node of the kind seam. Touches whose middle is outside are left out; where crossings are undecided, and for
// what is undecided before, there are undecided nodes. Precondition: both are of one surface.
intersect::Meet trimmed(const Face &face, const intersect::Meet &meet);

} // namespace nrb::face
