// SPDX-License-Identifier: MIT
// The boundaries of surfaces and volumes, on which one axis is fixed at an end of its domain.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::build {

// All boundaries, by axis, then by end; bit for bit the results of iso(). Throws Status::axes for a curve,
// and what iso() throws.
std::vector<SplinePtr> boundaries_of(const Spline &spline);

} // namespace nrb::build
