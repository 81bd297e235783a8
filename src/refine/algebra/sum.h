// SPDX-License-Identifier: MIT
// Linear combinations of splines.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// The linear combination alpha a(t) + beta b(t). If neither spline is rational, it is formed over common
// degrees and knots (common_knots.h). So it is if both are rational, have the same form, and have equal
// weights there, bit for bit. Otherwise it is formed over the product of the denominators. Throws
// Status::incompatible, dimension, degree, periodic_knots, not_representable. Precondition: alpha and beta
// are finite.
SplinePtr sum(const SplinePtr &a, double alpha, const SplinePtr &b, double beta);

} // namespace nrb::refine
