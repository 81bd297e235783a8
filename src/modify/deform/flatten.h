// SPDX-License-Identifier: MIT
// A part of a shape projected onto a plane.
#pragma once

#include "modify/deform/region.h"

namespace nrb::modify {

struct Flattened {
    SplinePtr spline;
    double moved; // of control points; infinite if one at infinity moved
};

// See nurbs_flatten(). Along an axis of which the part is not the whole domain, each of 3 (degree + 1) equal
// parts of the range gets a knot, so that there are control points inside the range and its middle third
// becomes flat. Throws Status::direction for a direction parallel to the plane to rounding,
// not_representable, and what refine() throws. Preconditions: all coordinates are finite, normal and
// direction are not 0; direction may be null.
Flattened flatten(const SplinePtr &spline, const Part &part, const double *point, const double *normal,
                  const double *direction);

} // namespace nrb::modify
