// SPDX-License-Identifier: MIT
// Iso-curves of surfaces and iso-surfaces of volumes.
#pragma once

#include "eval/parameters.h"

namespace nrb::refine {

// The spline over the other axes that results from fixing the parameter of `axis`. Throws Status::axes for a
// curve, flags for a rule that gives NaN, parameter_not_finite, outside_domain, not_representable, and the
// statuses of check_spline() if extrapolation leads to weights that are not positive.
SplinePtr iso(const Spline &spline, int axis, double t, const eval::AxisRule &rule);

} // namespace nrb::refine
