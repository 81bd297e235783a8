// SPDX-License-Identifier: MIT
// Mixed derivatives at the corners and edges of a grid, where they are not known.
#pragma once

#include "fit/axis_layers.h"
#include "fit/parameters.h"

#include <vector>

namespace nrb::fit {

// Whether the layers of derivatives of two axes cross at a point of the grid.
bool is_mixed(const std::vector<AxisLayers> &axes, const std::vector<int64_t> &place) noexcept;

// Replaces those that are NaN by the mean over their axes of derivatives along the axis at its end: those of the polynomial of
// the degree of the axis, or less if there are fewer, through the layers of values nearest to the end. So polynomials are kept,
// and derivative m is wrong by no more than the step to the power of degree + 1 - m. Mixed derivatives along three axes are made
// of those along two. Precondition: NaN nowhere else.
void estimate_mixed(const std::vector<AxisLayers> &axes, const std::vector<int> &degrees, PointGrid &grid);

} // namespace nrb::fit
