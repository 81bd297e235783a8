// SPDX-License-Identifier: MIT
// On which side of a curve of the plane another one lies.
#pragma once

#include "spline/spline.h"

namespace nrb::intersect {

// A way along curve a from a place on, up or down; near that place b is at a parameter of its own.
struct Way {
    double from_a, from_b;
    bool up;
    double first, most; // lengths of the first step and of all, in parameters of a
    double width;       // in space: how far from the place on b its foot may be to begin with
};

// 1 or -1: left or right of b, where a on its way first is farther from it than rounding can tell; 0 where a ends
// before, or b does, or it goes too far. Precondition: both are in the plane.
int side_along(const Spline &a, const Spline &b, const Way &way, double noise);

} // namespace nrb::intersect
