// SPDX-License-Identifier: MIT
// Ruled surfaces (entity 118): (1 - v) C1(t) + v C2(s).
#include "base/error.h"
#include "build/polylines.h"
#include "build/surfaces/ruled_extruded.h"
#include "io/iges/geometry/geometry.h"
#include "io/iges/geometry/shapes.h"
#include "model/shapes/curve_spline.h"
#include "refine/forms/parametrization.h"

#include <algorithm>
#include <cmath>

namespace nrb::io::iges {
namespace {

using model::CurveKind;
using model::CurvePiece;

constexpr double point_digits = 1e-9;

const CurvePiece &innermost(const CurvePiece &piece) noexcept {
    const CurvePiece *at = &piece;
    while (at->curve->kind == CurveKind::trimmed) {
        at = &at->curve->pieces.front();
    }
    return *at;
}

// Whether the parameter of its spline is everywhere a linear function of that of the curve.
bool linear(const CurvePiece &piece) noexcept {
    switch (piece.curve->kind) {
    case CurveKind::circle:
    case CurveKind::ellipse:
    case CurveKind::hyperbola:
        return false;
    case CurveKind::trimmed:
    case CurveKind::composite:
        return std::ranges::all_of(piece.curve->pieces, linear);
    default:
        return true;
    }
}

bool circles_of_one_sweep(const CurvePiece &a, const CurvePiece &b) noexcept {
    const CurvePiece &first = innermost(a), &second = innermost(b);
    const double sweep = first.range.upper - first.range.lower;
    return first.curve->kind == CurveKind::circle && second.curve->kind == CurveKind::circle &&
           std::fabs(second.range.upper - second.range.lower - sweep) <= point_digits * sweep;
}

bool straight(const CurvePiece &piece) noexcept {
    return piece.curve->kind == CurveKind::spline && piece.curve->spline->axis(0).degree() == 1 &&
           piece.curve->spline->point_count() == 2;
}

Vector3 point_of(const Spline &spline, int64_t i) noexcept {
    return {spline.coordinate(i, 0), spline.coordinate(i, 1), spline.coordinate(i, 2)};
}

// Whether one is a translate of the other, control point by control point.
bool moved(const Spline &a, const Spline &b) {
    if (a.point_count() != b.point_count() || !std::ranges::equal(a.axis(0).knots(), b.axis(0).knots()) ||
        !std::ranges::equal(a.weights(), b.weights())) {
        return false;
    }
    const Vector3 way = point_of(b, 0) - point_of(a, 0);
    const double size = largest(way) + largest(point_of(a, 0));
    for (int64_t i = 1; i < a.point_count(); ++i) {
        if (largest(point_of(b, i) - point_of(a, i) - way) > point_digits * size) {
            return false;
        }
    }
    return true;
}

} // namespace

// A boundary curve reparametrised to [0, 1]; a point (116) is a degenerate rail.
Geometry::Rail Geometry::rail(Reading &reading, const char *what) {
    const int64_t pointer = reading.record.integer(what);
    Rail rail;
    if (entities_.at(pointer, what).type == point_type) {
        const Vector3 p = point(pointer, reading.outer());
        rail.piece =
            whole(model::curve_of_spline(build::polyline(3, {p.x, p.y, p.z, p.x, p.y, p.z}, {0, 1})));
        rail.is_point = true;
    } else {
        rail.piece = any_curve(pointer, reading.outer(), false);
    }
    reading.parts.push_back(pointer);
    entities_.spend(size_of(rail.piece));
    rail.spline = refine::reparametrize(spline_of(rail.piece), 0, {0, 1});
    return rail;
}

// Form 0 joins points of equal relative arc length, form 1 those of equal relative parameters; the spline
// joins points of equal parameters of both splines.
Surface Geometry::ruled(Reading &reading) {
    Rail first = rail(reading, "first curve"), second = rail(reading, "second curve");
    const bool reversed = reading.record.integer("direction flag") == 1;
    reading.record.skip(1); // whether the surface is developable
    if (reversed) {
        second.spline = refine::reverse(*second.spline, 0, true);
    }
    const bool simple = first.is_point || second.is_point || circles_of_one_sweep(first.piece, second.piece);
    const bool exact = reading.entry.form == 1
                           ? simple || (linear(first.piece) && linear(second.piece))
                           : simple || (straight(first.piece) && straight(second.piece)) ||
                                 moved(*first.spline, *second.spline);
    if (!exact) {
        remarks_.push_back(
            {reading.entry.line,
             reading.entry.form == 1
                 ? "its rulings join points of equal parameters of splines, not of equal angles"
                 : "its rulings join points of equal parameters, not of equal arc length"});
    }
    // over the knots of both, with the sum of their degrees if the weights differ
    const bool rational = first.spline->rational() || second.spline->rational();
    entities_.spend((size_of(first.piece) + size_of(second.piece)) * (rational ? 16 : 4));
    return surface_of_spline(build::ruled(first.spline, second.spline, true));
}

} // namespace nrb::io::iges
