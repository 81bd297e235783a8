// SPDX-License-Identifier: MIT
// Extrema of scalar splines of two and three axes.
#pragma once

#include "intersect/extrema/extremum.h"

namespace nrb::intersect {

// In rising order of the axes, stratum by stratum: what is found on it and across it. Throws Status::not_representable.
Extrema field_extrema(const Spline &spline);

} // namespace nrb::intersect
