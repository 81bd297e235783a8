// SPDX-License-Identifier: MIT
// How fast points of surfaces move.
#pragma once

#include "spline/spline.h"

#include <array>

namespace nrb::face {

// How much faster a point of the surface moves than its parameters, on each axis: bounds over the domain,
// infinite where there is none.
std::array<double, 2> fastest(const Spline &surface);

} // namespace nrb::face
