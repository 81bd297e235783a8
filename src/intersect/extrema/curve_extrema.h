// SPDX-License-Identifier: MIT
// Extrema of scalar curves.
#pragma once

#include "intersect/extrema/extremum.h"

namespace nrb::intersect {

// In ascending order. The signs of the derivative are proven on Bernstein pieces by the variation diminishing
// property. Throws Status::not_representable.
Extrema curve_extrema(const SplinePtr &curve);

} // namespace nrb::intersect
