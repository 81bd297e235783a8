// SPDX-License-Identifier: MIT
// Equality of splines as numbers.
#pragma once

#include "spline/spline.h"

namespace nrb::inline spline {

// Whether two splines have equal forms, degrees, knots, points and weights, whether or not their axes are
// declared periodic. (0 and -0 are equal.)
bool same_numbers(const Spline &a, const Spline &b) noexcept;

} // namespace nrb::inline spline
