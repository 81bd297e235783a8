// SPDX-License-Identifier: MIT
// Intersections of two curves, and self-intersections.
#pragma once

#include "intersect/hits.h"
#include "spline/spline.h"

namespace nrb::intersect {

// A solution on two curves. from_b corresponds to the lower end of range_a, so that from_b > to_b where an
// overlap runs against b.
struct PairHit {
    double a, b;
    Interval range_a;
    double from_b, to_b;
    HitKind kind;
};

struct PairHits {
    std::vector<PairHit> list; // ascending in a
    bool complete = true;
};

// All places where the curves are within the tolerance of each other. Connected parts that are as near as
// that are overlaps (overlap_of()), or else they yield what exact arithmetic may find in them: intersections
// proven by charts, touches as far as rounding can tell, and in the plane, crossings where a changes to the
// other side of b. If it can find nothing, they are a contact. Throws Status::dimension, incompatible.
PairHits curve_curve(const Spline &a, const Spline &b, double tolerance);

// The self-intersections of a curve, with a < b. Two places do not count if the curve between them stays
// within the tolerance, nor do the ends of a closed curve.
PairHits curve_itself(const Spline &curve, double tolerance);

} // namespace nrb::intersect
