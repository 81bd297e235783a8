// SPDX-License-Identifier: MIT
// Derivatives at data points, each from the points near it: local interpolation.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::fit {

enum class TangentRule : int32_t { catmull_rom, bessel, akima, monotone };

// tangents[n][dim] at points[n][dim], n >= 2, with strictly increasing parameters. The last point of closed
// data repeats the first one, and so does its tangent.
std::vector<double> tangents_of(TangentRule rule, std::span<const double> params, int dim,
                                std::span<const double> points, bool closed);

} // namespace nrb::fit
