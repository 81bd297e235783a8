// SPDX-License-Identifier: MIT
// Offsets of curves.
#pragma once

#include "fit/offset/offset_surface.h"
#include "numeric/vector3.h"

namespace nrb::fit {

// The offset is C + d N with the unit normal N along V x C', as ISO 10303-42 defines it: V is a fixed direction, Z for curves of the
// plane, where N is to the left.
struct CurveOffset {
    double distance;
    Vector3 reference; // V, of length 1 to rounding
};

struct OffsetCurve {
    SplinePtr spline;
    double bound; // of the distance from the offset at equal parameters, proven
    // Somewhere it runs against the curve, behind a cusp where the radius of curvature is the distance. Looked for at the ends and
    // middles of the pieces.
    bool turns_back;
};

// A quintic polynomial spline within the tolerance, with the parameters of the curve: Hermite pieces with the first two derivatives,
// cut where offset_bounds() does not prove it. They join with two equal derivatives except at knots where those of the curve, up to
// the third ones, may jump. Where no more pieces are allowed, the nearest one that was met, with a bound above the tolerance; a curve
// that is as near itself, since the distance is not above the tolerance, is its own offset. Throws Status::unsupported where the curve
// has no tangent, one along V, or two at a knot; not_converged if no bound was met. Precondition: a curve of dimension 2 or 3,
// tolerance > 0.
OffsetCurve offset_curve(const SplinePtr &curve, const CurveOffset &offset, const OffsetRule &rule);

} // namespace nrb::fit
