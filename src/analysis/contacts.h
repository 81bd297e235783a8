// SPDX-License-Identifier: MIT
// Opposite boundaries that coincide, and boundaries that collapse to points.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::analysis {

struct AxisContact {
    bool closed; // the gap is at most the tolerance
    double gap;  // upper bound on the distance of both boundaries of the axis at equal parameters
};
struct BoundarySize {
    bool collapsed; // the size is at most the tolerance
    double size;    // upper bound on the distance of all points of the boundary from some point
};
struct Contacts {
    std::vector<AxisContact> axes;
    std::vector<BoundarySize> boundaries; // ordered by axis, then by end
};

AxisContact axis_contact(const Spline &spline, int axis, double tolerance);
BoundarySize boundary_size(const Spline &spline, int axis, bool upper, double tolerance);

// The gap of a periodic axis is 0 by definition; that of clamped boundaries with bitwise equal values is 0, as
// is the size of a clamped boundary that is a point. All other bounds are proven, and include the rounding of
// boundaries that are not clamped. The searches go on until the bounds decide on which side of the tolerance the true
// value is, within a limited number of steps.
Contacts boundary_contacts(const Spline &spline, double tolerance);

} // namespace nrb::analysis
