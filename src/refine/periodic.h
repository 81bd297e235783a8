// Refinement of periodic axes: the layers and knots of a period continue without end, and an operation on one
// period acts on all.
#pragma once

#include "spline/spline.h"

namespace nrb {

// Inserts a knot and its copies in all periods; the result is periodic over the same domain, its wrapped
// layers equal bit for bit. Preconditions: the axis is periodic, domain.lower <= knot < domain.upper, 0 <
// times <= degree + 1 - multiplicity.
SplinePtr insert_periodic(const Spline &spline, int axis, double knot, int times);

} // namespace nrb
