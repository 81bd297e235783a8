// SPDX-License-Identifier: MIT
// The curves along which functions over a surface vanish.
#pragma once

#include "intersect/levels/level_field.h"
#include "intersect/levels/level_meet.h"
#include "intersect/levels/surface_borders.h"

namespace nrb::intersect {

// Adds those of one function after the other.
class SurfaceLevels {
public:
    // tolerance > 0: of the curves, in space and in the unit of the caller.
    SurfaceLevels(LevelField &field, double tolerance);

    // Of the function as it is now; level: what it is called in the answer.
    Meet find(int64_t level);

private:
    LevelField &field_;
    SurfaceBorders borders_;
    double tolerance_;
};

} // namespace nrb::intersect
