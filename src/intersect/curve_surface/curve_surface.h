// SPDX-License-Identifier: MIT
// Where a curve meets a surface.
#pragma once

#include "intersect/hits.h"
#include "spline/spline.h"

#include <array>

namespace nrb::intersect {

// Places and ranges (t, u, v) of both.
struct SurfaceHit {
    std::array<double, 3> at;
    std::array<Interval, 3> range;
    HitKind kind;
};

struct SurfaceHits {
    std::vector<SurfaceHit> list; // t rising
    bool complete = true;
};

// All places where the curve is within the tolerance of the surface. Parts that are as near as that and hang together are
// overlaps, where the curve is near along a whole span of it, or from a knot or an end of the one or the other to the next;
// or else what exact arithmetic may have in them: meets proven by charts, touches as far as rounding can tell, and crossings
// where the curve changes its side; if it can have nothing, they are a contact. Throws Status::dimension, incompatible.
SurfaceHits curve_surface(const Spline &curve, const Spline &surface, double tolerance);

} // namespace nrb::intersect
