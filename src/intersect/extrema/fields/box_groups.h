// SPDX-License-Identifier: MIT
// Boxes of parameters that hang together.
#pragma once

#include "spline/part.h"

#include <vector>

namespace nrb::intersect {

// Boxes that touch become the box around them, and so on. What is more than some ten thousands is not told apart.
std::vector<Part> grouped(std::vector<Part> boxes, int axes);

bool touch(const Part &a, const Part &b, int axes) noexcept;
bool contains(const Part &whole, const Part &part, int axes) noexcept;

} // namespace nrb::intersect
