// SPDX-License-Identifier: MIT
// A shape moved and resized until it fits points best.
#pragma once

#include "recognize/shape_model.h"

#include <span>

namespace nrb::recognize {

// Gauss-Newton steps on the distances of the points, over the motions and sizes that change the shape: one
// that is better than the given one, or the given one. The search ends early where distances above the
// tolerance do not get small fast. Cost: a few hundred distances for each step and freedom.
Shape refined(const Shape &shape, std::span<const Vector3> points, double tolerance);

// The largest distance of a point; infinite if one is not finite.
double largest_distance(const Shape &shape, std::span<const Vector3> points) noexcept;

} // namespace nrb::recognize
