// SPDX-License-Identifier: MIT
// Where planes cut a surface.
#pragma once

#include "intersect/levels/level_meet.h"

namespace nrb::intersect {

// The planes x . normal = |normal| offset, tolerance > 0. Precondition: a surface in space.
Meet plane_sections(const Spline &surface, const std::array<double, 3> &normal,
                    std::span<const double> offsets, double tolerance);

} // namespace nrb::intersect
