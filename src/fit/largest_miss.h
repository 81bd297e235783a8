// SPDX-License-Identifier: MIT
// The interpolation error of a spline at its data.
#pragma once

#include "fit/parameters.h"
#include "spline/spline.h"

#include <span>

namespace nrb::fit {

// The largest distance of a point on the grid from the polynomial spline at its parameters. `params` lists
// the parameters of one axis after the other; they rise on each axis, and lie in the domain unless the axis
// is periodic.
double largest_miss(const Spline &spline, std::span<const double> params, const PointGrid &grid);

} // namespace nrb::fit
