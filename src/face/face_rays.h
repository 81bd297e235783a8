// SPDX-License-Identifier: MIT
// Which hits of rays on the surface of a face are on the face.
#pragma once

#include "face/face.h"
#include "intersect/rays/rays.h"

namespace nrb::face {

// Of boxes that come near a curve of the boundary by rounding it is not known. The face has to stay.
intersect::PlaceFilter trim_filter(const Face &face);

} // namespace nrb::face
