// SPDX-License-Identifier: MIT
// Where two faces meet.
#pragma once

#include "face/face.h"
#include "intersect/levels/level_meet.h"

namespace nrb::face {

// What their surfaces have in common inside of both, and of edges that have one key in both, these: curves beside such an edge are
// the edge. Preconditions: surfaces in space; tolerance > 0, of the curves.
intersect::Meet face_intersections(const Face &a, const Face &b, double tolerance);

// Of faces of which no edge of the one is known to be one of the other.
intersect::Meet strangers_intersections(const Face &a, const Face &b, double tolerance);

} // namespace nrb::face
