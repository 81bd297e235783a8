// SPDX-License-Identifier: MIT
// Where two curves meet.
#pragma once

#include "intersect/hits.h"
#include "spline/spline.h"

namespace nrb::intersect {

// On two curves. The range of b begins where that of a does: it falls where an overlap runs against b.
struct PairHit {
    double a, b;
    Interval range_a;
    double from_b, to_b;
    HitKind kind;
};

struct PairHits {
    std::vector<PairHit> list; // a rising
    bool complete = true;
};

// All places where the curves are within the tolerance of each other. Parts that are as near as that and hang
// together are overlaps (overlap_of()), or else what exact arithmetic may have in them: meets proven by charts,
// touches as far as rounding can tell, and, in the plane, crossings where a changes its side; if it can have
// nothing, they are a contact. Throws Status::dimension, incompatible.
PairHits curve_curve(const Spline &a, const Spline &b, double tolerance);

// Where a curve meets itself, at a < b. Two places that stay within the tolerance on the way from one to the other
// along the curve are none, nor are the ends of a curve that closes.
PairHits curve_itself(const Spline &curve, double tolerance);

} // namespace nrb::intersect
