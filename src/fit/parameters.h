// SPDX-License-Identifier: MIT
// Parameters of data points, from the distances between them.
#pragma once

#include "base/limits.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nrb::fit {

enum class ParameterRule : int32_t { uniform, chord, centripetal, power, foley_nielson };

// Of points on a grid of 1 to 3 axes.
struct GridShape {
    std::vector<int64_t> counts;
    int dim;
    std::array<bool, max_axes> periodic{}; // axes whose last layer repeats the first
};
// With the points, packed, last axis fastest.
struct PointGrid : GridShape {
    std::vector<double> points;
};

// An axis of the grid: outer blocks of `count` layers of `inner` doubles each.
struct GridLayers {
    int64_t outer, count, inner;
};
GridLayers layers_of(const GridShape &grid, size_t axis) noexcept;

// For each axis in turn as many parameters as it has layers, from 0 to 1: with the steps of a line of the grid, of
// which the rule makes lengths, the sums of the first ones divided by all of them; of many lines their mean. Lines of
// no length do not count. Steps of no length give equal parameters. The exponent is for ParameterRule::power. Throws
// Status::length where no line of an axis has a length. Precondition: the points, packed, last axis fastest, are finite.
std::vector<double> parametrize(const GridShape &grid, std::span<const double> points, ParameterRule rule,
                                double exponent);

// Where the basis functions over clamped, evenly spaced knots from 0 to 1 are largest (C.-G. Lim, "A universal
// parametrization in B-spline curve and surface interpolation", CAGD 16 (1999)): symmetric bit for bit. Precondition: 0 <=
// degree < count, count > 1.
std::vector<double> universal_params(int degree, int64_t count);

} // namespace nrb::fit
