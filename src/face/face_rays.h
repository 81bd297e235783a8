// SPDX-License-Identifier: MIT
// Which hits of rays on the surface of a face are on the face.
#pragma once

#include "face/face.h"
#include "intersect/rays/rays.h"

namespace nrb::face {

// The filter for a RayCaster on the surface of the face. It leaves open (0) boxes that a curve of the
// boundary enters or, by rounding, may enter. The face must outlive it.
intersect::PlaceFilter trim_filter(const Face &face);

} // namespace nrb::face
