// SPDX-License-Identifier: MIT
// Sections of a surface with planes.
#pragma once

#include "intersect/levels/level_meet.h"

namespace nrb::intersect {

// One level for each of the planes x . normal = offset. tolerance > 0. Preconditions: a surface in space, a
// finite normal that is not 0.
Meet plane_sections(const Spline &surface, const std::array<double, 3> &normal,
                    std::span<const double> offsets, double tolerance);

} // namespace nrb::intersect
