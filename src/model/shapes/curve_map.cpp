// SPDX-License-Identifier: MIT
#include "model/shapes/curve_map.h"

#include <algorithm>
#include <cmath>

namespace nrb::model {
namespace {

// The breaks around t; outside the domain, its ends.
Interval piece_at(const KnotVector &knots, double t) noexcept {
    const Interval domain = knots.domain();
    if (!(t > domain.lower) || !(t < domain.upper)) {
        return domain;
    }
    const std::span<const double> all = knots.knots();
    const auto behind = std::upper_bound(all.begin(), all.end(), t);
    return {*(behind - 1), *behind};
}

double tangent(ParameterLaw law, double x) noexcept {
    return law == ParameterLaw::angle ? std::tan(x) : std::tanh(x);
}
double inverse_tangent(ParameterLaw law, double x) noexcept {
    return law == ParameterLaw::angle ? std::atan(x) : std::atanh(x);
}

// The piece of a composite curve at t. Adds the lengths of the pieces before it to `offset`.
const CurvePiece &composite_piece(const CurveShape &curve, double t, double &offset) noexcept {
    for (size_t i = 0;; ++i) {
        const CurvePiece &piece = curve.pieces[i];
        const double length = piece.range.upper - piece.range.lower;
        if (i + 1 == curve.pieces.size() || t < offset + length) {
            return piece;
        }
        offset += length;
    }
}

} // namespace

// Within the spline of a composite curve the knots of a piece are shifted and possibly reversed, which does
// not change its law.
ParameterLaw law_at(const CurveShape &curve, double t) noexcept {
    const CurveShape *at = &curve;
    while (true) {
        switch (at->kind) {
        case CurveKind::circle:
        case CurveKind::ellipse:
            return ParameterLaw::angle;
        case CurveKind::hyperbola:
            return ParameterLaw::hyperbolic;
        case CurveKind::trimmed:
            t = at->pieces.front().forward ? t : -t;
            at = at->pieces.front().curve.get();
            break;
        case CurveKind::composite: {
            double offset = 0;
            const CurvePiece &piece = composite_piece(*at, t, offset);
            t = piece.forward ? piece.range.lower + (t - offset) : piece.range.upper - (t - offset);
            at = piece.curve.get();
            break;
        }
        default:
            return ParameterLaw::linear;
        }
    }
}

double to_spline_parameter(ParameterLaw law, const KnotVector &knots, double t) noexcept {
    const Interval piece = piece_at(knots, t);
    if (law == ParameterLaw::linear || !(t > piece.lower) || !(t < piece.upper)) {
        return t;
    }
    const double length = piece.upper - piece.lower, half = length / 2;
    const double x = tangent(law, (t - piece.lower - half) / 2) / tangent(law, length / 4);
    return std::clamp(piece.lower + half * (1 + x), piece.lower, piece.upper);
}

double from_spline_parameter(ParameterLaw law, const KnotVector &knots, double s) noexcept {
    const Interval piece = piece_at(knots, s);
    if (law == ParameterLaw::linear || !(s > piece.lower) || !(s < piece.upper)) {
        return s;
    }
    const double length = piece.upper - piece.lower, half = length / 2;
    const double x = (s - piece.lower - half) / half;
    return std::clamp(piece.lower + half + 2 * inverse_tangent(law, x * tangent(law, length / 4)),
                      piece.lower, piece.upper);
}

double to_spline_parameter(const CurveShape &curve, const Spline &spline, double t) {
    return to_spline_parameter(law_at(curve, t), spline.axis(0), t);
}

double from_spline_parameter(const CurveShape &curve, const Spline &spline, double s) {
    return from_spline_parameter(law_at(curve, s), spline.axis(0), s);
}

} // namespace nrb::model
