// SPDX-License-Identifier: MIT
// Proven zeros and signs of a function along a curve, and the ranges where it is near 0.
#pragma once

#include "intersect/curve_function.h"

#include "bernstein/sign_runs.h"

#include <vector>

namespace nrb::intersect {

// A range that contains a zero for certain, or in which rounding hides whether there is one.
struct ZeroRange {
    Interval range;
    double at;                 // the best estimate
    bool simple = false;       // contains exactly one zero
    bool inside = false;       // hidden, in the interior of one piece: there is no estimate
    bool exact = false;        // a zero without any rounding, at an end of a piece or all over it
    bool whole = false;        // a piece vanishes to rounding
    int order = 1;             // multiplicity of a zero at an end of a piece; of two pieces the higher one
    int before = 0, after = 0; // certain signs on both sides; 0: none, as at an end of the curve
};

// A change of certain signs without a zero, where the function jumps.
struct SignJump {
    double at;
    int before;
};

struct LevelSigns {
    // In ascending order; on a periodic axis the last one may end in the next period. Ranges that touch are
    // merged.
    std::vector<ZeroRange> zeros;
    // The ranges, in the same order, in which |f| may be at most the tolerance, if that is above 0. Outside
    // of these, and of the unknown ranges, |f| is larger.
    std::vector<Interval> near;
    std::vector<Interval> unknown; // the weight has no certain sign, or the limit of work was reached
    std::vector<SignJump> jumps;
    int first = 0, last = 0; // certain signs at the ends of the curve; 0: a zero, or unknown
};

LevelSigns level_signs(const CurveFunction &f, double tolerance);

// A place in a range where |f| is smallest. The range may end in the next period.
double place_of_least(const CurveFunction &f, Interval range);

} // namespace nrb::intersect
