// SPDX-License-Identifier: MIT
#include "model/shapes/offset_curve_shape.h"

#include "base/error.h"
#include "fit/offset/offset_jet.h"
#include "fit/offset/offset_side.h"
#include "model/shapes/curve_spline.h"

#include <algorithm>
#include <cmath>

namespace nrb::model {

namespace {

using fit::CurveOffset;

// The sine below which directions count as parallel, after their rounding.
constexpr double parallel_sine = 1e-14;

Vector3 axis_of(const CurveShape &circle) noexcept {
    return circle.place.dim == 2 ? Vector3{0, 0, 1} : circle.place.z;
}

// The offset of the curve of a piece. A reversed curve has its normal on the other side.
CurveOffset along(const CurvePiece &piece, const CurveOffset &offset) noexcept {
    return {piece.forward ? offset.distance : -offset.distance, offset.reference};
}

bool is_segment(const CurveShape &curve) noexcept {
    return curve.kind == CurveKind::spline && curve.spline->axis(0).degree() == 1 &&
           curve.spline->point_count() == 2 && !curve.spline->rational();
}

// The translation that offsets a line with a direction.
Vector3 shift_of(const Vector3 &way, const CurveOffset &offset) {
    const Vector3 normal = cross(offset.reference, way);
    const double l = length(normal);
    if (!(l > fit::least_sine * length(way))) {
        fail(Status::unsupported,
             "the line runs along the reference direction, where its offset is not known");
    }
    return offset.distance / l * normal;
}

MadeCurve offset_segment(const CurveShape &segment, const CurveOffset &offset) {
    const Spline &spline = *segment.spline;
    const int dim = spline.dim();
    const std::span<const double> points = spline.points();
    const Vector3 by = shift_of(in_space(points.data() + dim, dim) - in_space(points.data(), dim), offset);
    const double ways[3] = {by.x, by.y, by.z};
    std::vector<double> moved(points.begin(), points.end());
    for (size_t i = 0; i < moved.size(); ++i) {
        moved[i] += ways[i % static_cast<size_t>(dim)];
    }
    return {curve_of_spline(make_result(spline.knot_vectors(), dim, Form::polynomial, std::move(moved)))};
}

MadeCurve offset_line(CurveShape line, const CurveOffset &offset) {
    line.place.origin = line.place.origin + shift_of(line.place.x, offset);
    return {std::make_shared<const CurveShape>(std::move(line))};
}

// Z x T points inwards, where Z is the axis and T the tangent. Beyond the centre the radius is negative: the
// offset is then a circle that starts at the opposite point.
MadeCurve offset_circle(CurveShape circle, const CurveOffset &offset) {
    const double radius =
        circle.sizes[0] -
        std::copysign(offset.distance, offset.distance * dot(axis_of(circle), offset.reference));
    if (radius == 0) {
        fail(Status::length, "the offset of the circle by its radius %s is a point",
             Number(circle.sizes[0]).text);
    }
    if (radius < 0) {
        build::Placement &place = circle.place;
        for (Vector3 *v : {&place.x, &place.y, &place.x_rest, &place.y_rest, &place.given_x}) {
            *v = -1.0 * *v;
        }
    }
    circle.sizes[0] = std::abs(radius);
    return {std::make_shared<const CurveShape>(std::move(circle)), 0, radius < 0};
}

MadeCurve offset_spline(const CurveShape &basis, const CurveOffset &offset, const fit::OffsetRule &rule) {
    fit::OffsetCurve made = fit::offset_curve(curve_spline(basis), offset, rule);
    return {curve_of_spline(std::move(made.spline)), made.bound, made.turns_back};
}

MadeCurve offset_composite(const CurveShape &basis, const CurveOffset &offset, const fit::OffsetRule &rule,
                           double gap) {
    MadeCurve all;
    std::vector<CurvePiece> pieces;
    for (const CurvePiece &piece : basis.pieces) {
        MadeCurve made = offset_curve_shape(curve_of_piece(piece), offset, rule, gap);
        all.distance = std::max(all.distance, made.distance);
        all.turns_back |= made.turns_back;
        const Interval range = natural_range(*made.curve);
        pieces.push_back({std::move(made.curve), range});
    }
    all.curve = composite_curve(std::move(pieces), gap);
    return all;
}

MadeCurve offset_part(const CurvePiece &piece, const CurveOffset &offset, const fit::OffsetRule &rule,
                      double gap) {
    MadeCurve made = offset_curve_shape(piece.curve, along(piece, offset), rule, gap);
    made.curve = curve_of_piece({std::move(made.curve), piece.range, piece.forward});
    return made;
}

} // namespace

bool has_known_offset(const CurveShape &basis, const CurveOffset &offset) {
    switch (basis.kind) {
    case CurveKind::line:
        return true;
    case CurveKind::spline:
        return is_segment(basis);
    case CurveKind::circle:
        return length(cross(axis_of(basis), offset.reference)) <= parallel_sine;
    case CurveKind::trimmed:
        return has_known_offset(*basis.pieces.front().curve, offset);
    default:
        return false;
    }
}

MadeCurve offset_curve_shape(const CurveShapePtr &basis, const CurveOffset &offset,
                             const fit::OffsetRule &rule, double gap) {
    if (offset.distance == 0) {
        return {basis};
    }
    if (basis->kind == CurveKind::composite) {
        return offset_composite(*basis, offset, rule, gap);
    }
    if (!has_known_offset(*basis, offset)) {
        return offset_spline(*basis, offset, rule);
    }
    if (basis->kind == CurveKind::trimmed) {
        return offset_part(basis->pieces.front(), offset, rule, gap);
    }
    switch (basis->kind) {
    case CurveKind::line:
        return offset_line(*basis, offset);
    case CurveKind::spline:
        return offset_segment(*basis, offset);
    default:
        return offset_circle(*basis, offset);
    }
}

MadeCurve offset_curve_shape(const CurveShapePtr &basis, std::span<const double> distances,
                             const Vector3 &reference, const fit::OffsetRule &rule, double gap) {
    if (distances.size() < 2) {
        return distances.empty() ? MadeCurve{basis}
                                 : offset_curve_shape(basis, {distances.front(), reference}, rule, gap);
    }
    if (has_known_offset(*basis, {distances.front(), reference})) { // then that of the offset is known, too
        const MadeCurve first = offset_curve_shape(basis, {distances.front(), reference}, rule, gap);
        MadeCurve all = offset_curve_shape(first.curve, distances.subspan(1), reference, rule, gap);
        all.turns_back = all.turns_back != first.turns_back;
        return all;
    }
    const SplinePtr spline = curve_spline(*basis);
    double sum = distances.front();
    for (const double distance : distances.subspan(1)) {
        const int side = fit::offset_side(spline, {sum, reference}, rule);
        if (side == 0) {
            fail(Status::unsupported,
                 "the direction of the curve at the distance %s, from which it is offset, is not known to be "
                 "that of its basis, or against it",
                 Number(sum).text);
        }
        sum += side * distance;
    }
    return offset_curve_shape(basis, {sum, reference}, rule, gap);
}

} // namespace nrb::model
