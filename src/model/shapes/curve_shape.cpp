// SPDX-License-Identifier: MIT
#include "model/shapes/curve_shape.h"

#include "base/error.h"
#include "closest/closest.h"
#include "eval/evaluate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::model {
namespace {

// Coordinates in the frame of the curve.
Vector3 local(const CurveShape &curve, const Vector3 &point) noexcept {
    const Vector3 p = point - curve.place.origin;
    return {dot(curve.place.x, p), dot(curve.place.y, p), dot(curve.place.z, p)};
}

double angle_of(double x, double y) noexcept {
    const double angle = std::atan2(y, x);
    return angle < -0x1p-49 ? angle + turn : std::max(angle, 0.0); // rounding below 0 gives 0, not 2 pi
}

// The foot point on an ellipse by Newton's iteration. It starts from the angle of the point scaled to a
// circle, which is exact for points of the ellipse.
double ellipse_parameter(double a, double b, double x, double y) noexcept {
    double t = std::atan2(y / b, x / a);
    for (int i = 0; i < 8; ++i) {
        const double c = std::cos(t), s = std::sin(t);
        const double slope = (a * c - x) * -a * s + (b * s - y) * b * c;
        const double curvature = a * a * s * s + b * b * c * c - (a * c - x) * a * c - (b * s - y) * b * s;
        const double step = curvature > 0 ? slope / curvature : 0;
        t -= step;
        if (std::fabs(step) <= 0x1p-50) {
            break;
        }
    }
    return angle_of(std::cos(t), std::sin(t));
}

// The point lies on the curve to a tolerance, so that a long search would find nothing better.
double spline_parameter(const Spline &spline, const double *point) {
    constexpr int64_t most_pieces = 4096;
    const closest::Query query{point, nullptr, 0, std::min(closest::usual_budget(spline), most_pieces),
                               false, true};
    return closest::locator_of(spline).nearest(query).params[0];
}

Interval symmetric(double size) noexcept {
    return {-size, size};
}

// Of the parameters that differ from t by periods, the one in the range or, if none is, the nearest to it.
double turned_into(Interval range, double t, double period) noexcept {
    if (range.lower <= t && t <= range.upper) {
        return t;
    }
    const double turns = std::ceil((range.lower - t) / period);
    const double behind = t + turns * period, before = t + (turns - 1) * period;
    return behind - range.upper < range.lower - before ? behind : before;
}

double trimmed_parameter(const CurveShape &curve, const double *point) {
    const CurvePiece &piece = curve.pieces.front();
    double t = parameter_at(*piece.curve, point);
    const double around = period(*piece.curve, 0);
    t = around > 0 ? turned_into(piece.range, t, around) : t;
    t = std::clamp(t, piece.range.lower, piece.range.upper);
    return piece.forward ? t : -t;
}

CurveShapePtr shared_curve(CurveKind kind, int dim, SplinePtr spline, std::vector<CurvePiece> pieces) {
    CurveShape curve{kind, {}, {0, 0}, std::move(spline), std::move(pieces)};
    curve.place.dim = dim;
    return std::make_shared<const CurveShape>(std::move(curve));
}

} // namespace

double sweep_of(Interval range) noexcept {
    const double sweep = range.upper - range.lower;
    return std::fabs(sweep - turn) <= 0x1p-48 ? turn : sweep;
}

CurveShapePtr curve_of_spline(SplinePtr spline) {
    const int dim = spline->dim();
    return shared_curve(CurveKind::spline, dim, std::move(spline), {});
}

CurveShapePtr curve_of_piece(CurvePiece piece) {
    const int dim = piece.curve->place.dim;
    return shared_curve(CurveKind::trimmed, dim, nullptr, {std::move(piece)});
}

CurveShapePtr curve_of_pieces(std::vector<CurvePiece> pieces, SplinePtr all) {
    const int dim = all->dim();
    return shared_curve(CurveKind::composite, dim, std::move(all), std::move(pieces));
}

Interval natural_range(const CurveShape &curve) noexcept {
    switch (curve.kind) {
    case CurveKind::circle:
    case CurveKind::ellipse:
        return {0, turn};
    case CurveKind::trimmed: {
        const auto &[basis, range, forward] = curve.pieces.front();
        return forward ? range : Interval{-range.upper, -range.lower};
    }
    case CurveKind::spline:
    case CurveKind::composite:
        return curve.spline->axis(0).domain();
    default:
        return symmetric(std::numeric_limits<double>::infinity());
    }
}

bool bounded(const CurveShape &curve) noexcept {
    return std::isfinite(natural_range(curve).lower);
}

double period(const CurveShape &curve, double tolerance) {
    switch (curve.kind) {
    case CurveKind::circle:
    case CurveKind::ellipse:
        return turn;
    case CurveKind::line:
    case CurveKind::parabola:
    case CurveKind::hyperbola:
        return 0;
    default:
        break;
    }
    const Interval range = natural_range(curve);
    const bool closed = length(point_at(curve, range.upper) - point_at(curve, range.lower)) <= tolerance;
    return closed ? range.upper - range.lower : 0;
}

Interval range_near(const CurveShape &curve, const Vector3 &point, double distance) {
    const double far = length(point - curve.place.origin) + distance, size = curve.sizes[0];
    switch (curve.kind) {
    case CurveKind::line:
        return symmetric(far / size);
    case CurveKind::parabola: { // at t, s0 sqrt(t^4 + 4 t^2) from the vertex
        const double ratio = far / size;
        return symmetric(ratio / std::sqrt(2 + std::sqrt(4 + ratio * ratio)));
    }
    case CurveKind::hyperbola: // at t, at least s1 |sinh t| from the centre
        return symmetric(std::asinh(far / curve.sizes[1]));
    default:
        return natural_range(curve);
    }
}

double parameter_at(const CurveShape &curve, const double *point) {
    const Vector3 p = local(curve, in_space(point, curve.place.dim));
    switch (curve.kind) {
    case CurveKind::line:
        return p.x / curve.sizes[0];
    case CurveKind::circle:
        return angle_of(p.x, p.y);
    case CurveKind::ellipse:
        return ellipse_parameter(curve.sizes[0], curve.sizes[1], p.x, p.y);
    case CurveKind::parabola:
        return p.y / (2 * curve.sizes[0]);
    case CurveKind::hyperbola:
        return std::asinh(p.y / curve.sizes[1]);
    case CurveKind::trimmed:
        return trimmed_parameter(curve, point);
    default:
        return spline_parameter(*curve.spline, point);
    }
}

Vector3 point_at(const CurveShape &curve, double t) {
    double out[3] = {0, 0, 0};
    const double a = curve.sizes[0], b = curve.sizes[1];
    switch (curve.kind) {
    case CurveKind::line:
        curve.place.point(DoubleDouble::product(t, a), 0, 0, out);
        break;
    case CurveKind::circle:
        curve.place.point(a * std::cos(t), a * std::sin(t), 0, out);
        break;
    case CurveKind::ellipse:
        curve.place.point(a * std::cos(t), b * std::sin(t), 0, out);
        break;
    case CurveKind::parabola:
        curve.place.point(a * t * t, 2 * a * t, 0, out);
        break;
    case CurveKind::hyperbola:
        curve.place.point(a * std::cosh(t), b * std::sinh(t), 0, out);
        break;
    case CurveKind::trimmed:
        return point_at(*curve.pieces.front().curve, curve.pieces.front().forward ? t : -t);
    default: {
        const Interval domain = curve.spline->axis(0).domain();
        const double inside = std::clamp(t, domain.lower, domain.upper);
        eval::evaluate_points(*curve.spline, {}, 0, {&inside, 1, 1, 1, 1},
                              {out, 1, curve.spline->dim(), curve.spline->dim(), 1});
    }
    }
    return {out[0], out[1], out[2]};
}

} // namespace nrb::model
