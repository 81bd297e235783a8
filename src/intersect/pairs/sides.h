// SPDX-License-Identifier: MIT
// On which side of a curve in the plane another one lies.
#pragma once

#include "spline/spline.h"

namespace nrb::intersect {

// A walk along curve a from a place, up or down; near that place b has the parameter from_b.
struct Way {
    double from_a, from_b;
    bool up;
    double first, most; // distances of the first and of the last allowed sample, in parameters of a
    double width;       // in space: how far from the place on b the foot point may be at the start
};

// 1 or -1: a is to the left or right of b at the first sample that is farther from b than rounding can tell.
// 0 if a or b ends before that, or the walk becomes too long. Precondition: both curves are in the plane.
int side_along(const Spline &a, const Spline &b, const Way &way, double noise);

} // namespace nrb::intersect
