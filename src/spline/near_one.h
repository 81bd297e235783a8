// Splines brought near 1 in size, for methods whose squares would overflow or vanish, and back.
#pragma once

#include "spline/scaled.h"

#include <span>

namespace nrb::inline spline {

// What brings the coordinates, the weights and the shortest of the axes of at least a degree near 1, all axes by
// one power of two; nothing where they are not far from it. Only the control points at `places` count.
Powers powers_near_one(const Spline &spline, int degree, std::span<const int64_t> places);
Powers powers_near_one(const Spline &spline, int degree); // all that have influence

// The spline multiplied by these; what overflows, which is without influence on what is asked, becomes 0.
SplinePtr near_one(const Spline &spline, const Powers &powers);

// A result on what near_one() gave, brought back: coordinates that it has not changed are those of the given
// spline, the others are divided by the powers. Throws Status::not_representable.
SplinePtr scaled_back(const Spline &result, const Spline &near, const Spline &given, const Powers &powers);

} // namespace nrb::inline spline
