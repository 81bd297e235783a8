// SPDX-License-Identifier: MIT
// Iso-curves of surfaces and iso-surfaces of volumes.
#pragma once

#include "eval/parameters.h"

namespace nrb::refine {

// The spline over the other axes on which `axis` is fixed at a parameter. Throws Error: Status::axes for
// a curve, Status::flags for a rule that gives NaN, parameter_not_finite, outside_domain,
// not_representable, and the statuses of check_spline() when extrapolation leaves the positive weights.
SplinePtr iso(const Spline &spline, int axis, double t, const eval::AxisRule &rule);

} // namespace nrb::refine
