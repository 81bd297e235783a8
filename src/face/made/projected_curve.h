// SPDX-License-Identifier: MIT
// Curves projected onto faces, along a direction or orthogonally.
#pragma once

#include "face/face.h"
#include "intersect/projection/curve_projection.h"

namespace nrb::face {

// The parts of intersect::projected_along() and projected_normally() on the surface of a face that are inside
// of its loops (trimmed()).
intersect::Meet projected_along(const SplinePtr &curve, const Face &face, const Vector3 &direction,
                                double tolerance);

intersect::Meet projected_normally(const SplinePtr &curve, const Face &face, double tolerance);

} // namespace nrb::face
