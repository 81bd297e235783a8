// SPDX-License-Identifier: MIT
#include "io/iges/geometry/conics.h"

#include "base/error.h"
#include "io/iges/geometry/placed_splines.h"
#include "model/shapes/curve_spline.h"
#include "recognize/conic_axes.h"

#include <algorithm>
#include <cmath>

namespace nrb::io::iges {
namespace {

using model::CurveKind;
using model::CurvePiece;
using model::CurveShape;
using recognize::ConicAxes;

// End points closer than this times the size of the curve count as equal.
constexpr double same_point = 1e-9;

struct Point2 {
    double x = 0;
    double y = 0;
};

Point2 read_plane_point(Record &record, const char *name) {
    const double x = record.real(name, 0);
    return {x, record.real(name, 1)};
}

double distance(const Point2 &a, const Point2 &b) noexcept {
    return std::hypot(a.x - b.x, a.y - b.y);
}

// A conic in the plane z of its definition space.
struct PlaneConic {
    CurveKind kind;
    Point2 origin;
    Point2 x; // a unit vector
    double sizes[2];
    double z;
};

CurveShape in_frame(const PlaneConic &conic, build::Placement frame, double scale) {
    return {conic.kind, frame, {scale * conic.sizes[0], scale * conic.sizes[1]}, nullptr, {}};
}

// The shape in the definition space.
CurveShape unplaced(const PlaneConic &conic) {
    const double origin[3] = {conic.origin.x, conic.origin.y, conic.z}, axis[3] = {0, 0, 1};
    const double x[3] = {conic.x.x, conic.x.y, 0};
    return in_frame(conic, build::make_placement(3, origin, axis, x, "centre"), 1);
}

// Any affine image is exact as a spline; a similar image keeps its kind.
CurvePiece placed(const PlaneConic &conic, Interval range, bool forward, const Placement &place) {
    const PlaneImage image = place.plane({conic.origin.x, conic.origin.y, conic.z}, {conic.x.x, conic.x.y, 0},
                                         {-conic.x.y, conic.x.x, 0});
    if (image.similar) {
        return {std::make_shared<const CurveShape>(in_frame(conic, image.frame, image.scale)), range,
                forward};
    }
    const auto shape = std::make_shared<const CurveShape>(unplaced(conic));
    return whole(model::curve_of_spline(placed_spline(*model::piece_spline({shape, range, forward}), place)));
}

double angle_at(const Point2 &centre, const Point2 &point) noexcept {
    const double angle = std::atan2(point.y - centre.y, point.x - centre.x);
    return angle < 0 ? angle + model::turn : angle;
}

// The parabola of an equation whose discriminant is 0 up to rounding: in its principal axes it has only one
// quadratic term.
ConicAxes parabola_axes(const double *q) {
    const double angle = std::atan2(q[1], q[0] - q[2]) / 2 + (q[0] + q[2] < 0 ? std::atan(1) * 2 : 0);
    const double c = std::cos(angle), s = std::sin(angle);
    const double turned[6] = {
        q[0] * c * c + q[1] * c * s + q[2] * s * s, 0, 0, q[3] * c + q[4] * s, q[4] * c - q[3] * s, q[5]};
    ConicAxes axes = recognize::conic_axes(turned);
    const auto turn_back = [c, s](double *v) {
        const double x = c * v[0] - s * v[1];
        v[1] = s * v[0] + c * v[1];
        v[0] = x;
    };
    turn_back(axes.origin);
    turn_back(axes.x);
    return axes;
}

bool nearly_parabolic(const double *q) noexcept {
    const double discriminant = q[1] * q[1] - 4 * q[0] * q[2];
    const double size = std::max({std::fabs(q[0]), std::fabs(q[1]), std::fabs(q[2])});
    return discriminant != 0 && std::fabs(discriminant) <= 1e-6 * size * size;
}

// Puts the principal axis nearest to the x axis of the definition space first, so that the parameters are
// those of the standard, which knows only conics along the axes.
void lead_with_x(PlaneConic &ellipse) noexcept {
    if (std::fabs(ellipse.x.x) < std::fabs(ellipse.x.y)) {
        const double sign = ellipse.x.y > 0 ? 1 : -1;
        ellipse.x = {sign * ellipse.x.y, -sign * ellipse.x.x + 0.0};
        std::swap(ellipse.sizes[0], ellipse.sizes[1]);
    }
}

PlaneConic conic_of(const double *coefficients, double z, int64_t form) {
    constexpr int64_t parabola_form = 3;
    const bool parabola = form == parabola_form && nearly_parabolic(coefficients);
    const ConicAxes axes = parabola ? parabola_axes(coefficients) : recognize::conic_axes(coefficients);
    PlaneConic conic{CurveKind::ellipse,
                     {axes.origin[0], axes.origin[1]},
                     {axes.x[0], axes.x[1]},
                     {axes.sizes[0], axes.sizes[1]},
                     z};
    if (axes.type == recognize::conic_parabola) {
        conic.kind = CurveKind::parabola;
    } else if (axes.type == recognize::conic_hyperbola) {
        conic.kind = CurveKind::hyperbola;
    } else {
        lead_with_x(conic);
    }
    return conic;
}

// Chooses the branch of a hyperbola that contains the point.
void choose_branch(PlaneConic &hyperbola, const Point2 &point) noexcept {
    const double along =
        (point.x - hyperbola.origin.x) * hyperbola.x.x + (point.y - hyperbola.origin.y) * hyperbola.x.y;
    if (along < 0) {
        hyperbola.x = {-hyperbola.x.x, -hyperbola.x.y};
    }
}

} // namespace

CurvePiece read_circular_arc(Record &record, const Placement &place) {
    const double z = record.real("ZT");
    const Point2 centre = read_plane_point(record, "centre"), start = read_plane_point(record, "start"),
                 end = read_plane_point(record, "end");
    const double radius = distance(start, centre);
    build::check_positive_length(radius, "distance of start from centre");
    const double from = angle_at(centre, start), to = angle_at(centre, end);
    const bool closed = distance(start, end) <= same_point * radius;
    const double upper = closed ? from + model::turn : (to > from ? to : to + model::turn);
    return placed({CurveKind::circle, centre, {1, 0}, {radius, 0}, z}, {from, upper}, true, place);
}

CurvePiece read_conic_arc(Record &record, const Placement &place, int64_t form) {
    double coefficients[6];
    for (size_t i = 0; i < 6; ++i) {
        coefficients[i] = record.real("coefficients", static_cast<int64_t>(i));
    }
    const double z = record.real("ZT");
    const Point2 start = read_plane_point(record, "start"), end = read_plane_point(record, "end");
    PlaneConic conic = conic_of(coefficients, z, form);
    if (conic.kind == CurveKind::hyperbola) {
        choose_branch(conic, start);
    }
    const double first[3] = {start.x, start.y, z}, last[3] = {end.x, end.y, z};
    const CurvePiece piece = model::piece_between(std::make_shared<const CurveShape>(unplaced(conic)),
                                                  {first, last, true, same_point * conic.sizes[0]});
    return placed(conic, piece.range, piece.forward, place);
}

} // namespace nrb::io::iges
