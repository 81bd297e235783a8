// SPDX-License-Identifier: MIT
// Control points on which values and derivatives at the ends of axes depend.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::modify {

// For each control point (copies count with the first one), whether it acts on a derivative up to
// keep[k][end] at the start or the end of axis k. -1 stands for none, a null keep for none at all.
std::vector<char> kept_points(const Spline &spline, const int32_t *keep);

} // namespace nrb::modify
