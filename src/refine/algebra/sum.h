// Linear combinations of splines.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// alpha a(t) + beta b(t). Over common degrees and knots (common_knots.h) where neither is rational, or both are
// and their weights come out equal bit for bit; otherwise over the product of the denominators. Throws
// Status::incompatible, dimension, degree, periodic_knots, not_representable. Precondition: alpha and
// beta are finite.
SplinePtr sum(const SplinePtr &a, double alpha, const SplinePtr &b, double beta);

} // namespace nrb::refine
