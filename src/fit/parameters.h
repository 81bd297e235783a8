// SPDX-License-Identifier: MIT
// Parametrization of data points, from the distances between them.
#pragma once

#include "base/limits.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nrb::fit {

enum class ParameterRule : int32_t { uniform, chord, centripetal, power, foley_nielson };

// The shape of a grid of points with 1 to 3 axes.
struct GridShape {
    std::vector<int64_t> counts;
    int dim;
    std::array<bool, max_axes> periodic{}; // axes whose last layer repeats the first
};
// A grid with its points, packed, last axis fastest.
struct PointGrid : GridShape {
    std::vector<double> points;
};

// The layout of a grid along an axis: `outer` blocks of `count` layers of `inner` doubles each.
struct GridLayers {
    int64_t outer, count, inner;
};
GridLayers layers_of(const GridShape &grid, size_t axis) noexcept;

// For each axis in turn as many parameters as it has layers, from 0 to 1. On a line of the grid along the
// axis, the rule turns the chords between neighbouring points into lengths, and the parameters of the line
// are the partial sums of these divided by the total. The parameters of the axis are the means over its
// lines, without those of no length. Steps of no length give equal parameters. The exponent is for
// ParameterRule::power. Throws Status::length where no line of an axis has a length. Precondition: the
// points, packed, last axis fastest, are finite.
std::vector<double> parametrize(const GridShape &grid, std::span<const double> points, ParameterRule rule,
                                double exponent);

// The universal parametrization: the places where the basis functions over clamped, uniform knots on [0, 1]
// have their maxima (C.-G. Lim, "A universal parametrization in B-spline curve and surface interpolation",
// CAGD 16 (1999)). Symmetric bit for bit. Precondition: 0 <= degree < count, count > 1.
std::vector<double> universal_params(int degree, int64_t count);

} // namespace nrb::fit
