// SPDX-License-Identifier: MIT
// The curves along which functions over a surface vanish.
#pragma once

#include "intersect/levels/fields/piece_field.h"
#include "intersect/levels/level_meet.h"

#include <cstddef>
#include <functional>

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

// Where functions of a spline's pieces vanish on a surface with the same pieces, one after the other. Each has the usual limit of
// work.
struct LevelFunction {
    PieceField::Function function, sign;
};
Meet levels_of_functions(const Spline &surface, const Spline &spline, size_t count,
                         const std::function<LevelFunction(size_t i)> &function, double tolerance);

} // namespace nrb::intersect
