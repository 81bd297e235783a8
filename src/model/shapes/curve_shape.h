// SPDX-License-Identifier: MIT
// Curves in analytic form, as files state them, in the parametrization of ISO 10303-42.
#pragma once

#include "build/placement.h"
#include "spline/spline.h"

#include <memory>
#include <numbers>
#include <vector>

namespace nrb::model {

// With the origin C and the axes X, Y of the frame `place`, and the sizes s0, s1:
//     line       C + t s0 X
//     circle     C + s0 (cos t X + sin t Y)               t in radians
//     ellipse    C + s0 cos t X + s1 sin t Y              t in radians
//     parabola   C + s0 (t^2 X + 2 t Y)                   s0 the focal length
//     hyperbola  C + s0 cosh t X + s1 sinh t Y
//     spline     also polylines, with the corners at 0, 1, 2, ...
//     trimmed    its piece; if that runs against the basis curve, the parameter is -t
//     composite  its pieces one after the other, the first from 0 on
enum class CurveKind { line, circle, ellipse, parabola, hyperbola, spline, trimmed, composite };

struct CurveShape;
using CurveShapePtr = std::shared_ptr<const CurveShape>;

// A part of a curve. On a closed curve the range may run past the end, by less than a period.
struct CurvePiece {
    CurveShapePtr curve;
    Interval range;
    bool forward = true; // in the direction of the curve
};

struct CurveShape {
    CurveKind kind;
    build::Placement place;         // lines and conics; every curve has its dimension in it
    double sizes[2] = {0, 0};       // s0, s1
    SplinePtr spline;               // spline; composite: the whole curve
    std::vector<CurvePiece> pieces; // trimmed: one; composite: all
};

// A full turn in radians.
inline constexpr double turn = 2 * std::numbers::pi;
// The length of a range of angles; exactly a full turn if it is one to the rounding of its ends.
double sweep_of(Interval range) noexcept;

// A point of dimension 2 or 3 as one in space.
inline Vector3 in_space(const double *point, int dim) noexcept {
    return {point[0], point[1], dim == 3 ? point[2] : 0};
}

CurveShapePtr curve_of_spline(SplinePtr spline);
CurveShapePtr curve_of_piece(CurvePiece piece);
CurveShapePtr curve_of_pieces(std::vector<CurvePiece> pieces, SplinePtr all);

// The range on which the curve is defined: with infinite ends where it is unbounded, and [0, 2 pi] for a
// circle or an ellipse.
Interval natural_range(const CurveShape &curve) noexcept;
bool bounded(const CurveShape &curve) noexcept;
// The period of a closed curve, which may be followed past the end of its range; 0 if the ends are farther
// apart than the tolerance.
double period(const CurveShape &curve, double tolerance);

// A range of parameters outside of which the curve is farther from a point than a distance; the whole range
// if that is bounded.
Interval range_near(const CurveShape &curve, const Vector3 &point, double distance);

// The parameter of the foot point of a point [dim] that lies on the curve to a tolerance. On a circle or an
// ellipse it is in [0, 2 pi).
double parameter_at(const CurveShape &curve, const double *point);

// The point at a parameter. On a spline the parameter is clamped to the domain.
Vector3 point_at(const CurveShape &curve, double t);

} // namespace nrb::model
