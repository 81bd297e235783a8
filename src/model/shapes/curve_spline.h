// SPDX-License-Identifier: MIT
// The exact splines of parts of curves.
#pragma once

#include "model/shapes/curve_shape.h"

namespace nrb::model {

// Ends and direction of a part between two points of a curve, as an edge and a trimmed curve state it. On a closed
// curve it goes on behind the seam if it has to, and equal ends, to the tolerance, mean all of it. On an open curve the
// ends decide about the direction. Throws Status::empty_domain for a part without length.
struct CurveEnds {
    const double *start; // [dim]
    const double *end;
    bool forward;     // in the direction of the curve
    double tolerance; // ends this near to those of the curve are those; 0: 1e-9 of the size of the curve
};
CurvePiece piece_between(const CurveShapePtr &curve, const CurveEnds &ends);

// The same by parameters, from `start` to `end`: on a closed curve periods are added as the direction needs them.
CurvePiece piece_between(const CurveShapePtr &curve, double start, double end, bool forward,
                         double tolerance);

// The curve over a part of its range, exact but for rounding, over the same parameters. In between, the parameters of
// circles, ellipses and hyperbolas are others: see curve_map.h. Throws Status::empty_domain, outside_domain, and what
// the builders throw; length for infinite ranges.
SplinePtr curve_spline(const CurveShape &curve, Interval range);

// In the direction of the piece; against that of the curve the parameter is -t.
SplinePtr piece_spline(const CurvePiece &piece);

// All of a curve. Throws Status::length if it has no ends.
SplinePtr curve_spline(const CurveShape &curve);

// The composite curve of pieces whose ends are at most `tolerance` apart; 0: 1e-6 of the size of the largest piece.
// Throws Status::gap.
CurveShapePtr composite_curve(std::vector<CurvePiece> pieces, double tolerance);

} // namespace nrb::model
