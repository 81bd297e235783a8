// SPDX-License-Identifier: MIT
// Where control points say, without any rounding, that a scalar spline is constant.
#pragma once

#include "bernstein/rounded_polynomial.h"
#include "spline/spline.h"

#include <array>

namespace nrb::intersect {

// More than products of coefficients near 1 lose by underflow.
inline constexpr double underflow = 0x1p-900;

// All of a piece between knots, or one of its ends.
enum class Side : unsigned char { none, lower, upper };
using Sides = std::array<Side, max_axes>; // along each axis

// Of a piece between knots or of a side or an edge of it: all of it has one value; or so have so many of its Bezier points in
// layers from an end on, along each axis from the lower and the upper end, where f - value vanishes so many times.
struct ConstantLayers {
    bool all = false;
    double value = 0;
    std::array<std::array<int, 2>, max_axes> layers{};
};

// spans: the piece's place among the knots of each axis. Of homogeneous points nothing is told, of a corner neither.
ConstantLayers constant_layers(const Spline &spline, const std::array<int64_t, max_axes> &spans,
                               const Sides &sides = {});

// Sets layers to 0 that are so for certain. axis: of the three.
void set_zero(RoundedPolynomial &f, int axis, bool upper, int layers) noexcept;

} // namespace nrb::intersect
