// SPDX-License-Identifier: MIT
// Linear combinations of splines.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// alpha a(t) + beta b(t). The sum is over common degrees and knots (common_knots.h) if neither is rational,
// or if both are and their weights come out equal bit for bit; otherwise it is over the product of the
// denominators. Throws Status::incompatible, dimension, degree, periodic_knots, not_representable.
// Precondition: alpha and beta are finite.
SplinePtr sum(const SplinePtr &a, double alpha, const SplinePtr &b, double beta);

} // namespace nrb::refine
