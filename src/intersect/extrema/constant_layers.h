// SPDX-License-Identifier: MIT
// Where the control points of a scalar spline show, without any rounding, that it is constant.
#pragma once

#include "bernstein/rounded_polynomial.h"
#include "spline/spline.h"

#include <array>

namespace nrb::intersect {

// More than products of coefficients near 1 can lose by underflow.
inline constexpr double underflow = 0x1p-900;

// The whole of a piece between knots, or one of its ends.
enum class Side : unsigned char { none, lower, upper };
using Sides = std::array<Side, max_axes>; // along each axis

// For a piece between knots, or for a side or an edge of it. all: it has one value everywhere, `value`.
// layers: along each axis, from the lower and from the upper end, how many layers of its Bezier points have
// one value c, so that f - c vanishes there that many times.
struct ConstantLayers {
    bool all = false;
    double value = 0;
    std::array<std::array<int, 2>, max_axes> layers{};
};

// spans: the knot span of the piece on each axis. Nothing is found for homogeneous points, nor for a corner.
ConstantLayers constant_layers(const Spline &spline, const std::array<int64_t, max_axes> &spans,
                               const Sides &sides = {});

// Sets layers to 0 that are certainly 0, with their errors. axis: one of the three.
void set_zero(RoundedPolynomial &f, int axis, bool upper, int layers) noexcept;

} // namespace nrb::intersect
