// SPDX-License-Identifier: MIT
// The segments that close the loops of a face whose gaps were kept.
#pragma once

#include "face/face.h"

namespace nrb::face {

// For each curve of a loop, the segment from its end to the start of the next curve, in the plane that covers
// the domain; null where the two are no farther apart in space than the tolerance of the face.
std::vector<SplinePtr> closing_segments(const Face &face, const Loop &loop);

} // namespace nrb::face
