// SPDX-License-Identifier: MIT
// A part projected to a plane.
#pragma once

#include "modify/deform/region.h"

namespace nrb::modify {

struct Flattened {
    SplinePtr spline;
    double moved; // of control points
};

// See nurbs_flatten(). A part that is not the whole domain gets a knot in each of 3 (degree + 1) equal parts
// along an axis, so that control points are inside it and its middle third becomes flat. Throws
// Status::direction for a direction parallel to the plane to rounding, not_representable, and what refine()
// throws. Preconditions: all coordinates are finite, normal and direction are not 0; direction may be null.
Flattened flatten(const SplinePtr &spline, const Part &part, const double *point, const double *normal,
                  const double *direction);

} // namespace nrb::modify
