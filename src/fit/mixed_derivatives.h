// SPDX-License-Identifier: MIT
// Estimates of mixed derivatives at the corners and edges of a grid, where they are not known.
#pragma once

#include "fit/axis_layers.h"
#include "fit/parameters.h"

#include <vector>

namespace nrb::fit {

// Whether layers of derivatives of two or more axes cross at a point of the grid: the datum there is a mixed
// derivative.
bool is_mixed(const std::vector<AxisLayers> &axes, const std::vector<int64_t> &place) noexcept;

// Replaces each mixed derivative that is NaN by the mean of one estimate for each of its axes. The estimate
// along an axis is a derivative, at the end of the axis, of the polynomial through the layers of values
// nearest to that end; the degree of the polynomial is that of the axis, or lower if there are too few
// layers. Polynomials are therefore reproduced, and the error of derivative m is of the order of the step to
// the power of degree + 1 - m. Mixed derivatives along three axes are estimated from those along two.
// Precondition: nothing else is NaN.
void estimate_mixed(const std::vector<AxisLayers> &axes, const std::vector<int> &degrees, PointGrid &grid);

} // namespace nrb::fit
