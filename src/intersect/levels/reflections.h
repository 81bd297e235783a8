// SPDX-License-Identifier: MIT
// Reflection lines and highlight lines: where a surface mirrors lines of light.
#pragma once

#include "base/records.h"
#include "intersect/levels/level_meet.h"

#include <array>

namespace nrb::intersect {

enum class ReflectionKind : int32_t {
    highlight = 1, // the line along the normal meets the line of light
    along = 2,     // the line of light is seen, mirrored, along the direction `eye`
    from = 3,      // the line of light is seen, mirrored, from the point `eye`
};

// One level for each line of light, of a common direction through each of the points. tolerance > 0,
// directions not 0. Precondition: a surface in space.
Meet surface_reflections(const Spline &surface, ReflectionKind kind, const std::array<double, 3> &eye,
                         const std::array<double, 3> &direction, const ConstRecords &points,
                         double tolerance);

} // namespace nrb::intersect
