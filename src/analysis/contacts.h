// SPDX-License-Identifier: MIT
// Boundaries that meet, and boundaries that shrink to points.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::analysis {

struct AxisContact {
    bool closed; // the gap is at most the tolerance
    double gap;  // the two boundaries of the axis are nowhere farther apart, at equal parameters
};
struct BoundarySize {
    bool collapsed; // the size is at most the tolerance
    double size;    // no point of the boundary is farther from some point
};
struct Contacts {
    std::vector<AxisContact> axes;
    std::vector<BoundarySize> boundaries; // by axis, then by end
};

AxisContact axis_contact(const Spline &spline, int axis, double tolerance);
BoundarySize boundary_size(const Spline &spline, int axis, bool upper, double tolerance);

// Boundaries whose values are the same bit for bit have a gap of 0; points have a size of 0. Other bounds are
// proven. The searches go on as long as the bounds do not decide on which side of the tolerance the true
// value is.
Contacts boundary_contacts(const Spline &spline, double tolerance);

} // namespace nrb::analysis
