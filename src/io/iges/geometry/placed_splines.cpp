// SPDX-License-Identifier: MIT
#include "io/iges/geometry/placed_splines.h"

#include "model/shapes/curve_spline.h"
#include "refine/forms/transform.h"

#include <algorithm>

namespace nrb::io::iges {

SplinePtr placed_spline(const Spline &spline, const Placement &place) {
    const Transform map = place.transform.value_or(Transform{});
    double matrix[9], way[3];
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j) {
            matrix[3 * i + j] = place.factor * map.r[i][j];
        }
        way[i] = place.factor * map.t[i];
    }
    return refine::transform(spline, {place.dim(), 3, matrix}, way);
}

model::CurvePiece whole(model::CurveShapePtr curve) {
    const Interval range = model::natural_range(*curve);
    return {std::move(curve), range, true};
}

SplinePtr spline_of(const model::CurvePiece &piece) {
    const Interval all = model::natural_range(*piece.curve);
    const bool spline = piece.curve->kind == model::CurveKind::spline && piece.forward &&
                        piece.range.lower == all.lower && piece.range.upper == all.upper;
    return spline ? piece.curve->spline : model::piece_spline(piece);
}

int64_t size_of(const model::CurvePiece &piece) noexcept {
    const model::CurveShape &curve = *piece.curve;
    if (curve.kind == model::CurveKind::trimmed) {
        return size_of(curve.pieces.front());
    }
    if (curve.spline != nullptr) {
        return curve.spline->point_count() * (curve.spline->dim() + 2);
    }
    if (curve.kind == model::CurveKind::hyperbola) { // a few control points for each unit of the parameter
        const double length = piece.range.upper - piece.range.lower;
        return 64 + static_cast<int64_t>(32 * std::min(length, 4096.0));
    }
    return 64;
}

} // namespace nrb::io::iges
