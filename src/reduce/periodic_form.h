// SPDX-License-Identifier: MIT
// Converts closed splines to periodic form.
#pragma once

#include "spline/spline.h"

namespace nrb::reduce {

struct PeriodicForm {
    SplinePtr spline;
    double deviation; // an upper bound, see deviation_bound()
    int order;        // of continuity at the seam, whose knot has multiplicity degree - order
};

// Makes axis k periodic over its domain, with the highest order of continuity at the seam that moves the
// shape by at most the tolerance. Control points whose knots are on both sides of the seam are extrapolated
// from the end that has more of these knots; the layers at the start are replaced by those at the end. Throws
// Status::gap if not even the end points agree within the tolerance; also tolerance, and what extension and
// refinement throw.
PeriodicForm make_periodic(const SplinePtr &spline, int k, double tolerance);

// Whether the knots of an axis repeat, and its last layers equal the first ones bit for bit.
bool wraps(const Spline &spline, int axis) noexcept;

} // namespace nrb::reduce
