// SPDX-License-Identifier: MIT
#include "io/iges/geometry/shapes.h"

#include "base/error.h"
#include "eval/evaluate.h"
#include "model/shapes/surface_spline.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::io::iges {
namespace {

using model::CurveKind;
using model::CurvePiece;
using model::CurveShapePtr;
using model::SurfaceKind;
using model::SurfaceShape;

model::SurfaceShapePtr trimmed(SurfaceShape basis, const model::Rectangle &range) {
    SurfaceShape shape = shape_of(SurfaceKind::trimmed);
    shape.basis = std::make_shared<const SurfaceShape>(std::move(basis));
    shape.range = range;
    return std::make_shared<const SurfaceShape>(std::move(shape));
}

// The accuracy of angles in files.
constexpr double angle_digits = 1e-8;

Interval checked_angles(double start, double end) {
    const double sweep = end - start;
    if (!(sweep > 0) || !(sweep <= model::turn + angle_digits)) {
        fail(Status::angle, "from %s to %s, expected more than nothing and at most a turn",
             Number(start).text, Number(end).text);
    }
    return {start, sweep > model::turn - angle_digits ? start + model::turn : end};
}

// A finite part of a range.
Interval finite_part(Interval range) noexcept {
    const bool lower = std::isfinite(range.lower), upper = std::isfinite(range.upper);
    return {lower ? range.lower : (upper ? range.upper - 1 : -1),
            upper ? range.upper : (lower ? range.lower + 1 : 1)};
}

} // namespace

CurveShapePtr shape_of_piece(const CurvePiece &piece) {
    const Interval all = model::natural_range(*piece.curve);
    const bool is_all = piece.forward && piece.range.lower == all.lower && piece.range.upper == all.upper;
    return is_all ? piece.curve : model::curve_of_piece(piece);
}

SurfaceShape shape_of(SurfaceKind kind) {
    SurfaceShape shape{kind, {}, {0, 0}, {}, nullptr, {}, nullptr, 0, true, true, nullptr};
    shape.place.dim = 3;
    return shape;
}

Surface surface_of_spline(SplinePtr spline) {
    SurfaceShape shape = shape_of(SurfaceKind::spline);
    shape.spline = std::move(spline);
    return {std::make_shared<const SurfaceShape>(std::move(shape))};
}

Surface revolved(const CurvePiece &profile, const build::Placement &axis, double start, double end) {
    const Interval angles = checked_angles(start, end);
    SurfaceShape shape = shape_of(SurfaceKind::revolution);
    shape.curve = shape_of_piece(profile);
    shape.place = axis;
    const Interval along = model::natural_range(*shape.curve);
    const bool all = angles.lower == 0 && angles.upper == model::turn;
    Surface surface{nullptr, {true}, standard_parameters(profile)};
    surface.shape = all || !model::bounded(*shape.curve)
                        ? std::make_shared<const SurfaceShape>(std::move(shape))
                        : trimmed(std::move(shape), {angles, along});
    return surface;
}

Surface extruded(const CurvePiece &directrix, const Vector3 &way) {
    if (!(length(way) > 0)) {
        fail(Status::length, "the generatrix has no length");
    }
    SurfaceShape shape = shape_of(SurfaceKind::extrusion);
    shape.curve = shape_of_piece(directrix);
    shape.vector = way;
    const Interval along = model::natural_range(*shape.curve);
    const ParameterMap map{false, {along.upper - along.lower, 1}, {along.lower, 0}};
    return {trimmed(std::move(shape), {along, {0, 1}}), map, standard_parameters(directrix)};
}

Vector3 start_of(const CurvePiece &piece) {
    return model::point_at(*piece.curve, piece.forward ? piece.range.lower : piece.range.upper);
}

Vector3 normal_in_the_middle(const SurfaceShape &surface) {
    if (surface.kind == SurfaceKind::offset) {
        return normal_in_the_middle(*surface.basis);
    }
    const model::Rectangle all = model::natural_range(surface);
    const model::Rectangle range = {finite_part(all.u), finite_part(all.v)};
    const SplinePtr spline = model::surface_spline(surface, range);
    const double middle[2] = {std::midpoint(range.u.lower, range.u.upper),
                              std::midpoint(range.v.lower, range.v.upper)};
    double out[9];
    eval::evaluate_points(*spline, {}, 1, {middle, 1, 2, 2, 1}, {out, 1, 9, 9, 1});
    return cross({out[3], out[4], out[5]}, {out[6], out[7], out[8]});
}

int64_t size_of(const SurfaceShape &surface) noexcept {
    constexpr int64_t elementary = 700, around = 10, along = 4; // layers across the profile
    switch (surface.kind) {
    case SurfaceKind::revolution:
        return around * size_of(whole(surface.curve));
    case SurfaceKind::extrusion:
        return along * size_of(whole(surface.curve));
    case SurfaceKind::offset:
    case SurfaceKind::trimmed:
        return size_of(*surface.basis);
    case SurfaceKind::spline:
        return 0; // it exists already
    default:
        return elementary;
    }
}

bool standard_parameters(const CurvePiece &piece) noexcept {
    switch (piece.curve->kind) {
    case CurveKind::parabola:
    case CurveKind::hyperbola:
        return false;
    case CurveKind::trimmed:
    case CurveKind::composite:
        return std::ranges::all_of(piece.curve->pieces, standard_parameters);
    default:
        return true;
    }
}

} // namespace nrb::io::iges
