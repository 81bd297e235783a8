// SPDX-License-Identifier: MIT
// Refines a shape so that it fits points better, by nonlinear least squares.
#pragma once

#include "recognize/shape_model.h"

#include <span>

namespace nrb::recognize {

// Gauss-Newton iteration on the distances of the points, over the motions that change the shape and its
// sizes. Returns a better shape than the given one, or the given one. The iteration ends early if distances
// above the tolerance do not decrease fast. Cost: at most 160 distances per iteration and degree of freedom.
Shape refined(const Shape &shape, std::span<const Vector3> points, double tolerance);

// The largest distance of a point; infinite if one is not finite.
double largest_distance(const Shape &shape, std::span<const Vector3> points) noexcept;

} // namespace nrb::recognize
