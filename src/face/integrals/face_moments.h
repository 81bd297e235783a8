// SPDX-License-Identifier: MIT
// Area, centroid and inertia of faces.
#pragma once

#include "face/face.h"
#include "measure/moments.h"

namespace nrb::face {

// By integrate(). Throws as measure::moments(), and Status::orientation for loops that cross.
measure::Moments moments(const Face &face, measure::MomentOrder order, double relative_tolerance);

} // namespace nrb::face
