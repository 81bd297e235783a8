// SPDX-License-Identifier: MIT
// Where a function along a curve is, or may be, zero, and where it is near 0.
#pragma once

#include "intersect/curve_function.h"

#include "bernstein/sign_runs.h"

#include <vector>

namespace nrb::intersect {

// A range in which a zero is proven, or hidden by rounding.
struct ZeroRange {
    Interval range;
    double at;                 // the best estimate
    bool simple = false;       // exactly one zero
    bool inside = false;       // of one piece, hidden: there is no estimate
    bool exact = false;        // one without any rounding, at an end of a piece or all over it
    bool whole = false;        // a piece vanishes to rounding
    int order = 1;             // of the zero at an end of a piece; the higher one of two pieces
    int before = 0, after = 0; // certain signs, 0: none, at an end of the curve
};

// A change from one certain sign to the other without a zero.
struct SignJump {
    double at;
    int before;
};

struct LevelSigns {
    // Rising; on a periodic axis the last one may end in the next period. Those that touch are one.
    std::vector<ZeroRange> zeros;
    // The same, if the tolerance is above 0: where |f| may be at most that. All the rest is farther away.
    std::vector<Interval> near;
    std::vector<Interval> unknown; // the weight has no certain sign, or the limit of work was reached
    std::vector<SignJump> jumps;
    int first = 0, last = 0; // at the ends of the curve; 0: a zero, or it is not certain
};

LevelSigns level_signs(const CurveFunction &f, double tolerance);

// Where |f| is smallest in a range, which may end in the next period.
double place_of_least(const CurveFunction &f, Interval range);

} // namespace nrb::intersect
