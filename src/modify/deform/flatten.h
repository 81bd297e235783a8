// A region projected to a plane.
#pragma once

#include "modify/deform/region.h"

namespace nrb {

struct Flattened {
    SplinePtr spline;
    double moved; // of control points
};

// See nurbs_flatten(). A region that is a part of the domain is refined to 3 (degree + 1) spans along an axis at
// least, so that control points are inside it and its middle third becomes flat. Throws NURBS_ERROR_DIRECTION for
// a direction parallel to the plane to rounding, _NOT_REPRESENTABLE, and what refine() throws. Preconditions: all
// coordinates are finite, normal and direction are not 0; direction may be null.
Flattened flatten(const SplinePtr &spline, const Region &region, const double *point, const double *normal,
                  const double *direction);

} // namespace nrb
