// SPDX-License-Identifier: MIT
// Splines that are equal bit for bit.
#pragma once

#include "spline/spline.h"

namespace nrb::inline spline {

// Whether two splines have the same degrees, knots, points and weights, whatever their axes are marked as.
bool same_numbers(const Spline &a, const Spline &b) noexcept;

} // namespace nrb::inline spline
