// SPDX-License-Identifier: MIT
// Curves as files state them, in the parametrization of ISO 10303-42.
#pragma once

#include "build/placement.h"
#include "spline/spline.h"

#include <memory>
#include <numbers>
#include <vector>

namespace nrb::model {

//     line       P + t s0 X
//     circle     C + s0 (cos t X + sin t Y)               t in radians
//     ellipse    C + s0 cos t X + s1 sin t Y              t in radians
//     parabola   C + s0 (t^2 X + 2 t Y)                   s0 the focal length
//     hyperbola  C + s0 cosh t X + s1 sinh t Y
//     spline     also polylines, with the corners at 0, 1, 2, ...
//     trimmed    its piece; against the direction of the basis the parameter is -t
//     composite  its pieces one after the other, the first from 0 on
enum class CurveKind { line, circle, ellipse, parabola, hyperbola, spline, trimmed, composite };

struct CurveShape;
using CurveShapePtr = std::shared_ptr<const CurveShape>;

// A part of a curve. The range of a closed one may go on behind its end, by less than a period.
struct CurvePiece {
    CurveShapePtr curve;
    Interval range;
    bool forward = true; // in the direction of the curve
};

struct CurveShape {
    CurveKind kind;
    build::Placement place;         // line and conics; its dimension is that of every curve
    double sizes[2] = {0, 0};       // s0, s1
    SplinePtr spline;               // spline, composite: all of it
    std::vector<CurvePiece> pieces; // trimmed: one; composite
};

// The angle of a turn in radians.
inline constexpr double turn = 2 * std::numbers::pi;
// From the start of a range of angles to its end; a turn, if it is one but for the rounding of the ends.
double sweep_of(Interval range) noexcept;

// A point of dim 2 or 3 in space.
inline Vector3 in_space(const double *point, int dim) noexcept {
    return {point[0], point[1], dim == 3 ? point[2] : 0};
}

CurveShapePtr curve_of_spline(SplinePtr spline);
CurveShapePtr curve_of_piece(CurvePiece piece);
CurveShapePtr curve_of_pieces(std::vector<CurvePiece> pieces, SplinePtr all);

// Where the curve is defined: infinite ends where it has none, [0, 2 pi] for a circle and an ellipse.
Interval natural_range(const CurveShape &curve) noexcept;
bool bounded(const CurveShape &curve) noexcept;
// Of closed curves, which may be followed on behind the end of their range; 0 for others.
double period(const CurveShape &curve, double tolerance);

// The parameters between which the curve may be within a distance of a point; all of its range if it is bounded.
Interval range_near(const CurveShape &curve, const Vector3 &point, double distance);

// The parameter of the point of the curve that is nearest to a point, which lies on it but for a tolerance. On a
// closed curve in [0, period). [dim] coordinates.
double parameter_at(const CurveShape &curve, const double *point);

// The point at a parameter, which for a spline is moved into its domain.
Vector3 point_at(const CurveShape &curve, double t);

} // namespace nrb::model
