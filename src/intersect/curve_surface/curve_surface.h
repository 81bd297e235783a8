// SPDX-License-Identifier: MIT
// Intersections of a curve and a surface.
#pragma once

#include "intersect/hits.h"
#include "spline/spline.h"

#include <array>

namespace nrb::intersect {

// Parameters (t, u, v) on both, and their ranges.
struct SurfaceHit {
    std::array<double, 3> at;
    std::array<Interval, 3> range;
    HitKind kind;
};

struct SurfaceHits {
    std::vector<SurfaceHit> list; // ascending in t
    bool complete = true;
};

// All places where the curve is within the tolerance of the surface. Connected parts that are as near as that
// are overlaps if the curve stays near along a whole span of it, or from a knot or an end of either to the
// next one. Otherwise they yield what exact arithmetic may find in them: intersections proven by charts,
// touches as far as rounding can tell, and crossings where the curve changes to the other side. If it can
// find nothing, they are a contact. Throws Status::dimension, incompatible.
SurfaceHits curve_surface(const Spline &curve, const Spline &surface, double tolerance);

} // namespace nrb::intersect
