// SPDX-License-Identifier: MIT
// A spline restricted to one span of each axis, without any computation.
#pragma once

#include "spline/spline.h"

namespace nrb::inline spline {

// The spline of the control points that are active on these spans, over the knots on which their functions
// depend there. Its domain consists of these spans.
SplinePtr active_part(const Spline &spline, const std::array<int64_t, max_axes> &spans);

} // namespace nrb::inline spline
