// SPDX-License-Identifier: MIT
// The axes of a spline in another order.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// Axis k of the result is axis permutation[k] of the spline. Throws Status::axis.
SplinePtr transpose(const Spline &spline, const int32_t *permutation);

} // namespace nrb::refine
