// SPDX-License-Identifier: MIT
// Area, centroid and inertia of faces.
#pragma once

#include "face/face.h"
#include "measure/moments.h"

namespace nrb::face {

// By Gauss rules on the rectangles and curved trapezoids of which the face consists (D. Gunderman, K. Weiss, J. A. Evans,
// "Spectral mesh-free quadrature for planar regions bounded by rational parametric curves", CAD 130 (2021)), those with the
// largest error first, by higher rules or halved. Throws as measure::moments(). A tolerance of 0 asks for the best that rounding
// and a limit of work allow.
measure::Moments moments(const Face &face, measure::MomentOrder order, double relative_tolerance);

} // namespace nrb::face
