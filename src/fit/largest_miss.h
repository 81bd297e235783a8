// SPDX-License-Identifier: MIT
// How well a spline goes through its data.
#pragma once

#include "fit/parameters.h"
#include "spline/spline.h"

#include <span>

namespace nrb::fit {

// The largest distance of the points on a grid from the polynomial spline at the parameters of all axes, which rise on
// each, in the domain or on a periodic axis.
double largest_miss(const Spline &spline, std::span<const double> params, const PointGrid &grid);

} // namespace nrb::fit
