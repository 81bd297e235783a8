// SPDX-License-Identifier: MIT
// Scaling of splines by powers of two to sizes near 1, and back, for methods whose squares would overflow or
// underflow.
#pragma once

#include "spline/scaled.h"

#include <span>

namespace nrb::inline spline {

// The exponents that bring near 1: the coordinates, the weights, and the shortest of the domains of axes of
// at least this degree; all axes get the same exponent. An exponent is 0 if the size is within 2^64 of 1
// already. Only the control points at `places` count.
Powers powers_near_one(const Spline &spline, int degree, std::span<const int64_t> places);
Powers powers_near_one(const Spline &spline, int degree); // all control points with influence

// The spline scaled by these powers. Coordinates and weights that overflow are replaced by 0; they must have no influence
// on the result that is wanted.
SplinePtr near_one(const Spline &spline, const Powers &powers);

// Scales back `result`, which was computed from near = near_one(given, powers). Coordinates that equal those
// of `near` are taken from the given spline, others are divided by the powers. Throws
// Status::not_representable.
SplinePtr scaled_back(const Spline &result, const Spline &near, const Spline &given, const Powers &powers);

} // namespace nrb::inline spline
