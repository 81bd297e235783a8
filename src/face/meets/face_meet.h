// SPDX-License-Identifier: MIT
// Intersections of two faces.
#pragma once

#include "face/face.h"
#include "intersect/levels/level_meet.h"

namespace nrb::face {

// What the surfaces of two faces have in common inside of both faces, with the edges that have the same key
// in both. Curves beside such an edge, within its room (CommonEdge), are dropped in favour of the edge.
// Preconditions: surfaces in space; tolerance > 0, of the curves.
intersect::Meet face_intersections(const Face &a, const Face &b, double tolerance);

// The same for faces of which no edge of one is known to be an edge of the other.
intersect::Meet strangers_intersections(const Face &a, const Face &b, double tolerance);

} // namespace nrb::face
