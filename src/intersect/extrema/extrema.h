// SPDX-License-Identifier: MIT
// Where scalar splines have local extrema and saddles.
#pragma once

#include "intersect/extrema/extremum.h"

namespace nrb::intersect {

// In ascending order of the parameters. Precondition: dimension 1. Throws Status::not_representable.
Extrema extrema_of(const SplinePtr &spline);

} // namespace nrb::intersect
