// SPDX-License-Identifier: MIT
// Exact splines of parts of curves.
#pragma once

#include "model/shapes/curve_shape.h"

namespace nrb::model {

// The ends and the direction of a part of a curve between two points, as edges and trimmed curves state them.
// On a closed curve the part crosses the seam if necessary, and ends that are equal to the tolerance mean the
// whole curve. On an open curve the ends determine the direction. Throws Status::empty_domain for a part
// without length.
struct CurveEnds {
    const double *start; // [dim]
    const double *end;
    bool forward;     // in the direction of the curve
    double tolerance; // within it, an end is that of the curve; 0: 1e-9 of the size of the curve
};
CurvePiece piece_between(const CurveShapePtr &curve, const CurveEnds &ends);

// The same between parameters. On a closed curve a period is added where the direction requires it; equal
// parameters are refused there, too.
CurvePiece piece_between(const CurveShapePtr &curve, double start, double end, bool forward,
                         double tolerance);

// The spline of the curve over a part of its range, exact but for rounding. It has the same domain, but
// between the breaks the parameters of circles, ellipses and hyperbolas differ: see curve_map.h. Throws
// Status::length for an infinite range, empty_domain, outside_domain, and what the builders throw.
SplinePtr curve_spline(const CurveShape &curve, Interval range);

// The spline of a piece in its direction. Against the direction of the curve the parameter is -t.
SplinePtr piece_spline(const CurvePiece &piece);

// The spline of the whole curve. Throws Status::length if it is unbounded.
SplinePtr curve_spline(const CurveShape &curve);

// The composite curve of pieces, consecutive ends of which are at most `tolerance` apart; 0: 1e-6 of the size
// of the largest piece. Throws Status::gap. Precondition: at least one piece.
CurveShapePtr composite_curve(std::vector<CurvePiece> pieces, double tolerance);

} // namespace nrb::model
