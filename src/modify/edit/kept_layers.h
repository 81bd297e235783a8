// SPDX-License-Identifier: MIT
// Control points on which values and derivatives at the ends of axes depend.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::modify {

// For each control point, 1 if it acts on a derivative of an order up to keep[k][end] at the start or the end
// of an axis k, else 0; copies count with their original. The order -1 keeps nothing at that end, and a null
// `keep` nothing at all.
std::vector<char> kept_points(const Spline &spline, const int32_t *keep);

} // namespace nrb::modify
