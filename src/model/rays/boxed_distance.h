// SPDX-License-Identifier: MIT
// How far edges are from the curves of their faces, where only boxes prove anything.
#pragma once

#include "face/face.h"

namespace nrb::model {

// A bound of the distance in space, at equal parameters, of a curve of a loop from its edge, for those of
// which deviation_of() proves none. It is the largest distance of points in common boxes of small parts, of
// about a hundredth of the size of the face. Precondition: it has an edge.
double boxed_distance(const face::Face &face, int32_t loop, int32_t index);

} // namespace nrb::model
