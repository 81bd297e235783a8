// SPDX-License-Identifier: MIT
// Splines brought near 1 in size, and back, for methods whose squares would overflow or vanish.
#pragma once

#include "spline/scaled.h"

#include <span>

namespace nrb::inline spline {

// The powers of two that bring the coordinates, the weights, and the shortest of the axes of at least a
// degree, near 1; all axes by one power. No value if they are not far from 1. Only the control points at
// `places` count.
Powers powers_near_one(const Spline &spline, int degree, std::span<const int64_t> places);
Powers powers_near_one(const Spline &spline, int degree); // all that have influence

// The spline multiplied by these powers. A value that overflows has no influence on the result that is
// wanted; it becomes 0.
SplinePtr near_one(const Spline &spline, const Powers &powers);

// A result for the spline that near_one() returned, brought back. Coordinates that it has not changed are
// those of the given spline; the others are divided by the powers. Throws Status::not_representable.
SplinePtr scaled_back(const Spline &result, const Spline &near, const Spline &given, const Powers &powers);

} // namespace nrb::inline spline
