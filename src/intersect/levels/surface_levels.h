// SPDX-License-Identifier: MIT
// The zero curves of functions over a surface.
#pragma once

#include "intersect/levels/fields/piece_field.h"
#include "intersect/levels/level_meet.h"

#include <cstddef>
#include <functional>

namespace nrb::intersect {

// Finds the zero curves of a field, whose function may be changed between calls.
class SurfaceLevels {
public:
    // tolerance > 0: the deviation of the curves in space, in the unit of the caller.
    SurfaceLevels(LevelField &field, double tolerance);

    // The zero curves of the present function; level: the index by which the result names it.
    Meet find(int64_t level);

private:
    LevelField &field_;
    SurfaceBorders borders_;
    double tolerance_;
};

// The zero curves of `count` functions of the pieces of `spline`, one level each, on a surface with the same
// pieces. Zeros count where `sign` is positive, if there is one. Each function has the usual work limit.
struct LevelFunction {
    PieceField::Function function, sign;
};
Meet levels_of_functions(const Spline &surface, const Spline &spline, size_t count,
                         const std::function<LevelFunction(size_t i)> &function, double tolerance);

} // namespace nrb::intersect
