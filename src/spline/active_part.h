// SPDX-License-Identifier: MIT
// What a spline is over one span of each axis.
#pragma once

#include "spline/spline.h"

namespace nrb::inline spline {

// The spline of the control points that are active on these spans and of the knots that their functions have
// there: its domain is the spans.
SplinePtr active_part(const Spline &spline, const std::array<int64_t, max_axes> &spans);

} // namespace nrb::inline spline
