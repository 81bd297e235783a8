// SPDX-License-Identifier: MIT
// What closes the loops of a face whose gaps were kept.
#pragma once

#include "face/face.h"

namespace nrb::face {

// Of each curve of a loop: the segment in the plane that covers the domain from its end to the start of the next one, where
// the two are farther apart in space than the tolerance of the face; null where they meet.
std::vector<SplinePtr> closing_segments(const Face &face, const Loop &loop);

} // namespace nrb::face
