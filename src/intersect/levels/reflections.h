// SPDX-License-Identifier: MIT
// Where a surface mirrors lines of light.
#pragma once

#include "base/records.h"
#include "intersect/levels/level_meet.h"

#include <array>

namespace nrb::intersect {

enum class ReflectionKind : int32_t {
    highlight = 1, // normals meet the line
    along = 2,     // it is seen along a direction
    from = 3,      // it is seen from a point
};

// Of lines of one direction through each of some points, one after the other. tolerance > 0, directions not 0.
// Precondition: a surface in space.
Meet surface_reflections(const Spline &surface, ReflectionKind kind, const std::array<double, 3> &eye,
                         const std::array<double, 3> &direction, const ConstRecords &points,
                         double tolerance);

} // namespace nrb::intersect
