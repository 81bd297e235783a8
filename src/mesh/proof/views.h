// SPDX-License-Identifier: MIT
// How far bounds of triangles (triangle_bound.h) reach that are seen along normals of other triangles.
#pragma once

#include "base/numbers.h"

namespace nrb::mesh {

// Chords of 57 and 29 degrees: a star has to lie over the plane; what comes out over sides, and the sines of angles,
// are bounded for directions up to 30 degrees off the normal.
inline constexpr double most_turned = 0.95, most_turned_by_sides = 0.5;
// Room for rounding in those sines, in altitudes and in sums.
inline constexpr double share_of_sines = 0.99, share_of_altitude = 0.99, rounded_sum = 1 + 64 * eps;

} // namespace nrb::mesh
