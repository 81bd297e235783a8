// SPDX-License-Identifier: MIT
// Extrema of scalar curves.
#pragma once

#include "intersect/extrema/extremum.h"

namespace nrb::intersect {

// In rising order. The derivative's signs are proven on Bernstein pieces, by variation diminishing. Throws
// Status::not_representable.
Extrema curve_extrema(const SplinePtr &curve);

} // namespace nrb::intersect
