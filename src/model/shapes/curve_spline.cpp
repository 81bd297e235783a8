// SPDX-License-Identifier: MIT
#include "model/shapes/curve_spline.h"

#include "base/error.h"
#include "bounds/box.h"
#include "build/conics/conic_curves.h"
#include "refine/forms/parametrization.h"
#include "refine/parts/cut.h"
#include "refine/parts/join.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::model {
namespace {

bool is_conic(const CurveShape &curve) noexcept {
    return curve.kind == CurveKind::circle || curve.kind == CurveKind::ellipse;
}

// The size to which tolerances are relative: the largest side of the box of control points of a spline; s0 of
// a line or a conic.
double size_of(const CurveShape &curve) {
    switch (curve.kind) {
    case CurveKind::spline:
    case CurveKind::composite:
        return bounds::extent(*curve.spline);
    case CurveKind::trimmed:
        return size_of(*curve.pieces.front().curve);
    default:
        return curve.sizes[0];
    }
}

// The piece from a to b in the given direction, across the seam if that is necessary.
CurvePiece closed_piece(const CurveShapePtr &curve, double a, double b, bool forward, double around) {
    if (!forward) {
        std::swap(a, b);
    }
    b -= around * (std::ceil((b - a) / around) - 1);
    return {curve, {a, b}, forward};
}

CurvePiece open_piece(const CurveShapePtr &curve, double a, double b) {
    return {curve, {std::min(a, b), std::max(a, b)}, a < b};
}

CurvePiece checked(CurvePiece piece) {
    if (!(piece.range.lower < piece.range.upper)) {
        fail(Status::empty_domain, "the part of the curve from %s to %s has no length",
             Number(piece.range.lower).text, Number(piece.range.upper).text);
    }
    return piece;
}

// Finds the piece between two points of a curve with a bounded range.
class BoundedEnds {
public:
    BoundedEnds(const CurveShapePtr &curve, const CurveEnds &ends)
        : curve_(curve), ends_(ends), range_(natural_range(*curve)), first_(point_at(*curve, range_.lower)),
          last_(point_at(*curve, range_.upper)),
          tolerance_(ends.tolerance > 0 ? ends.tolerance : 1e-9 * size_of(*curve)),
          around_(near(first_, last_) ? range_.upper - range_.lower : 0) {}

    [[nodiscard]] CurvePiece piece() const {
        const bool forward = ends_.forward;
        if (around_ > 0) {
            const double a = parameter(ends_.start, forward), b = parameter(ends_.end, !forward);
            return near(point(ends_.start), point(ends_.end))
                       ? CurvePiece{curve_, {std::min(a, b), std::min(a, b) + around_}, forward}
                       : closed_piece(curve_, a, b, forward, around_);
        }
        return checked(open_piece(curve_, parameter(ends_.start, true), parameter(ends_.end, false)));
    }

private:
    [[nodiscard]] bool near(const Vector3 &a, const Vector3 &b) const noexcept {
        return length(a - b) <= tolerance_;
    }
    [[nodiscard]] Vector3 point(const double *x) const noexcept { return in_space(x, curve_->place.dim); }

    // If the point is near both ends of the curve, `first` chooses between them.
    [[nodiscard]] double parameter(const double *x, bool first) const {
        const bool at_first = near(point(x), first_), at_last = near(point(x), last_);
        if (at_first || at_last) {
            return at_first && (first || !at_last) ? range_.lower : range_.upper;
        }
        return parameter_at(*curve_, x);
    }

    const CurveShapePtr &curve_;
    const CurveEnds &ends_;
    Interval range_;
    Vector3 first_;
    Vector3 last_;
    double tolerance_;
    double around_;
};

SplinePtr over(const SplinePtr &spline, Interval range) {
    return refine::reparametrize(spline, 0, range);
}

SplinePtr line_spline(const CurveShape &line, Interval range) {
    const auto dim = static_cast<size_t>(line.place.dim);
    std::vector<double> points(2 * dim);
    line.place.point(DoubleDouble::product(range.lower, line.sizes[0]), 0, 0, points.data());
    line.place.point(DoubleDouble::product(range.upper, line.sizes[0]), 0, 0, points.data() + dim);
    return make_result({make_knot_vector(1, {range.lower, range.lower, range.upper, range.upper})},
                       line.place.dim, Form::polynomial, std::move(points));
}

SplinePtr arc_spline(const CurveShape &conic, Interval range) {
    const build::Turn arc = build::make_turn(range.lower, sweep_of(range), "start of the range", "range");
    const double across = conic.kind == CurveKind::circle ? conic.sizes[0] : conic.sizes[1];
    return over(
        build::placed_arc(conic.place, conic.sizes[0], across, build::unit_arc(arc, build::arc_quarters)),
        range);
}

// A range that runs past the end of a closed spline continues at its start.
SplinePtr part_of_spline(const SplinePtr &spline, Interval range) {
    const Interval domain = spline->axis(0).domain();
    range.lower = std::max(range.lower, domain.lower);
    if (!(range.lower < std::min(range.upper, domain.upper))) {
        fail(Status::outside_domain, "the range [%s, %s] is outside the domain [%s, %s] of the spline",
             Number(range.lower).text, Number(range.upper).text, Number(domain.lower).text,
             Number(domain.upper).text);
    }
    if (range.upper <= domain.upper ||
        period(*curve_of_spline(spline), 1e-6 * bounds::extent(*spline)) == 0) {
        return refine::restrict_axis(spline, 0, range.lower, std::min(range.upper, domain.upper));
    }
    const double more = range.upper - domain.upper;
    const std::array<SplinePtr, 2> parts = {
        refine::restrict_axis(spline, 0, range.lower, domain.upper),
        refine::restrict_axis(spline, 0, domain.lower, std::min(domain.lower + more, domain.upper))};
    return refine::join(parts, 0, {std::numeric_limits<double>::infinity(), false}).spline;
}

SplinePtr trimmed_spline(const CurveShape &curve, Interval range) {
    const CurvePiece &piece = curve.pieces.front();
    return piece.forward ? curve_spline(*piece.curve, range)
                         : piece_spline({piece.curve, {-range.upper, -range.lower}, false});
}

} // namespace

CurvePiece piece_between(const CurveShapePtr &curve, const CurveEnds &ends) {
    if (!is_conic(*curve) && bounded(*curve)) {
        return BoundedEnds(curve, ends).piece();
    }
    const double a = parameter_at(*curve, ends.start), b = parameter_at(*curve, ends.end);
    if (!is_conic(*curve)) {
        return checked(open_piece(curve, a, b));
    }
    const int dim = curve->place.dim;
    const double tolerance = ends.tolerance > 0 ? ends.tolerance : 1e-9 * size_of(*curve);
    const bool closed = length(in_space(ends.start, dim) - in_space(ends.end, dim)) <= tolerance;
    return closed ? CurvePiece{curve, {a, a + turn}, ends.forward}
                  : closed_piece(curve, a, b, ends.forward, turn);
}

CurvePiece piece_between(const CurveShapePtr &curve, double start, double end, bool forward,
                         double tolerance) {
    if (!std::isfinite(end - start) || start == end) {
        fail(Status::empty_domain, "the part of the curve from %s to %s has no length", Number(start).text,
             Number(end).text);
    }
    const double around = period(*curve, tolerance);
    if (around == 0) {
        return open_piece(curve, start, end);
    }
    CurvePiece piece = closed_piece(curve, start, end, forward, around);
    const Interval range = natural_range(*curve);
    if (piece.range.lower < range.lower || piece.range.lower >= range.upper) {
        const double shift = around * std::floor((piece.range.lower - range.lower) / around);
        piece.range.lower -= shift;
        piece.range.upper -= shift;
    }
    return checked(piece);
}

SplinePtr curve_spline(const CurveShape &curve, Interval range) {
    if (!std::isfinite(range.upper - range.lower)) {
        fail(Status::length, "the curve has no ends");
    }
    switch (curve.kind) {
    case CurveKind::line:
        return line_spline(curve, range);
    case CurveKind::circle:
    case CurveKind::ellipse:
        return arc_spline(curve, range);
    case CurveKind::parabola: {
        const double doubled = 2 * curve.sizes[0];
        return over(
            build::parabola(curve.place, curve.sizes[0], doubled * range.lower, doubled * range.upper),
            range);
    }
    case CurveKind::hyperbola:
        return over(build::hyperbola(curve.place, curve.sizes[0], curve.sizes[1], range.lower, range.upper),
                    range);
    case CurveKind::trimmed:
        return trimmed_spline(curve, range);
    default:
        return part_of_spline(curve.spline, range);
    }
}

SplinePtr piece_spline(const CurvePiece &piece) {
    SplinePtr spline = curve_spline(*piece.curve, piece.range);
    return piece.forward ? spline : refine::reverse(*spline, 0, false);
}

SplinePtr curve_spline(const CurveShape &curve) {
    return curve_spline(curve, natural_range(curve));
}

CurveShapePtr composite_curve(std::vector<CurvePiece> pieces, double tolerance) {
    std::vector<SplinePtr> splines;
    splines.reserve(pieces.size());
    double size = 0;
    for (const CurvePiece &piece : pieces) {
        splines.push_back(piece_spline(piece));
        size = std::max(size, bounds::extent(*splines.back()));
    }
    const Interval first = splines.front()->axis(0).domain();
    splines.front() = over(splines.front(), {0, first.upper - first.lower});
    const double gap = tolerance > 0 ? tolerance : 1e-6 * size;
    SplinePtr all = refine::join(splines, 0, {gap, false}).spline;
    return curve_of_pieces(std::move(pieces), std::move(all));
}

} // namespace nrb::model
