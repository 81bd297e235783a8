// SPDX-License-Identifier: MIT
// Approximation of offsets of curves, with proof.
#pragma once

#include "fit/offset/offset_surface.h"
#include "numeric/vector3.h"

namespace nrb::fit {

// The offset is C + d N with the unit normal N along V x C', as ISO 10303-42 defines it. V is a fixed
// direction: the z axis for plane curves, for which N points to the left.
struct CurveOffset {
    double distance;
    Vector3 reference; // V, of length 1 to rounding
};

struct OffsetCurve {
    SplinePtr spline;
    double bound; // of the distance from the offset at equal parameters, proven
    // Whether the offset somewhere runs against the curve: it does beyond a cusp, which lies where the radius
    // of curvature equals the distance. Tested at the ends and middles of the pieces only.
    bool turns_back;
};

// A quintic polynomial spline within the tolerance of the offset, with the parameters of the curve. Its
// pieces are Hermite interpolants of the first two derivatives, and are cut where offset_bounds() does not
// prove the tolerance. They join with two equal derivatives, except at knots where derivatives of the curve
// up to the third may jump. Where no more pieces are allowed, the result is the closest spline that was
// found, with a bound above the tolerance. If the distance is not above the tolerance, the curve itself is
// the result. Throws Status::unsupported where the curve has no tangent, one along V, or two at a knot;
// not_converged if no bound was found. Precondition: a curve of dimension 2 or 3, tolerance > 0.
OffsetCurve offset_curve(const SplinePtr &curve, const CurveOffset &offset, const OffsetRule &rule);

} // namespace nrb::fit
