// SPDX-License-Identifier: MIT
#include "io/iges/write/write_geometry.h"

#include "build/conics/angle.h"
#include "io/iges/types.h"
#include "io/iges/write/write_spline.h"
#include "io/written/similarity.h"
#include "io/written/spline_facts.h"
#include "model/shapes/curve_spline.h"
#include "spline/part.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::io::iges {

using model::CurveKind;
using model::CurvePiece;
using model::SurfaceKind;
using model::SurfaceShape;

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;

bool given(const Vector3 &way) noexcept {
    return way.x != 0 || way.y != 0 || way.z != 0;
}
Vector3 axis_of(const build::Placement &place) noexcept {
    return given(place.given_axis) ? place.given_axis : place.z;
}
Vector3 x_of(const build::Placement &place) noexcept {
    return given(place.given_x) ? place.given_x : place.x;
}

std::array<double, 3> with_neighbours(double value) noexcept {
    return {value, std::nextafter(value, -HUGE_VAL), std::nextafter(value, HUGE_VAL)};
}

// The angle in degrees from which readers compute exactly this angle, if there is one; else the nearest.
double degrees(double angle) noexcept {
    const double near = angle / radians_per_degree;
    for (const double candidate : with_neighbours(near)) {
        if (radians_per_degree * candidate == angle) {
            return candidate;
        }
    }
    return near;
}

CurvePiece all_of(const model::CurveShapePtr &curve) {
    return {curve, model::natural_range(*curve), true};
}

bool has_all_angles(Interval range) noexcept {
    return range.lower == 0 && range.upper == model::turn;
}

// A full turn ends where it begins.
double end_of(Interval range) noexcept {
    return model::sweep_of(range) == model::turn ? range.lower : range.upper;
}

// Whether the square of a size is representable in any unit; circles have a second size of 0.
bool has_square(double size) noexcept {
    constexpr double least = 1e-100, most = 1e100;
    return size == 0 || (least <= size && size <= most);
}

Vector3 point_of(const Spline &spline, int64_t i) noexcept {
    return {spline.coordinate(i, 0), spline.coordinate(i, 1), spline.coordinate(i, 2)};
}

// The first column of the matrix of a plane: the given direction of x, if it is a unit vector, else x.
Vector3 first_column(const build::Placement &place) noexcept {
    constexpr double digits = 0x1p-40;
    const Vector3 &x = place.given_x;
    return given(x) && std::abs(length(x) - 1) <= digits ? x : place.x;
}

// Readers compute the axis as the cross product of the columns. If the given axis was computed in this way, a
// vector next to y reproduces it exactly.
Vector3 second_column(const build::Placement &place, const Vector3 &x) noexcept {
    const auto same = [](const Vector3 &a, const Vector3 &b) {
        return a.x == b.x && a.y == b.y && a.z == b.z;
    };
    for (const double p : with_neighbours(place.y.x)) {
        for (const double q : with_neighbours(place.y.y)) {
            for (const double r : with_neighbours(place.y.z)) {
                if (same(cross(x, {p, q, r}), place.given_axis)) {
                    return {p, q, r};
                }
            }
        }
    }
    return place.y;
}

// Whether it is the spline that readers make of a line.
bool is_line(const Spline &spline) {
    constexpr double knots[] = {0, 0, 1, 1};
    return spline.axes() == 1 && spline.dim() == 3 && spline.axis(0).degree() == 1 && !has_weights(spline) &&
           std::ranges::equal(spline.axis(0).knots(), knots) && !spline.axis(0).periodic();
}

// The point at an angle on a circle around the origin, with coordinates from which readers compute exactly
// the same radius and angle, if there are any next to the rounded ones.
std::array<double, 2> place_on_circle(double radius, double angle) noexcept {
    const auto [cos, sin] = build::Angle::from_radians(angle).direction();
    const double x = radius * cos, y = radius * sin;
    for (const double p : with_neighbours(x)) {
        for (const double q : with_neighbours(y)) {
            const double found = std::atan2(q, p);
            if (std::hypot(p, q) == radius && (found < 0 ? found + model::turn : found) == angle) {
                return {p, q};
            }
        }
    }
    return {x, y};
}

} // namespace

bool is_line(const CurvePiece &piece) noexcept {
    return piece.curve->kind == CurveKind::line ||
           (piece.curve->kind == CurveKind::trimmed && is_line(piece.curve->pieces.front()));
}

bool statable(const CurvePiece &piece) {
    const model::CurveShape &curve = *piece.curve;
    if (!std::isfinite(piece.range.upper - piece.range.lower)) {
        return false;
    }
    switch (curve.kind) {
    case CurveKind::line:
        return curve.place.dim == 3;
    case CurveKind::circle:
    case CurveKind::ellipse:
        return curve.place.dim == 3 && piece.forward && 0 <= piece.range.lower &&
               piece.range.lower < model::turn && has_square(curve.sizes[0]) && has_square(curve.sizes[1]);
    case CurveKind::spline:
        return curve.spline->dim() == 3 && curve.spline->form() != Form::homogeneous &&
               curve.spline->axis(0).degree() > 0;
    case CurveKind::trimmed:
        return statable(curve.pieces.front());
    default:
        return false;
    }
}

bool statable(const SurfaceShape &surface) {
    switch (surface.kind) {
    case SurfaceKind::plane:
    case SurfaceKind::cylinder:
    case SurfaceKind::cone:
    case SurfaceKind::sphere:
        return true;
    case SurfaceKind::torus:
        return has_all_angles(surface.range.v);
    case SurfaceKind::revolution:
        return statable(all_of(surface.curve));
    case SurfaceKind::trimmed: {
        const SurfaceShape &basis = *surface.basis;
        return (basis.kind == SurfaceKind::revolution || basis.kind == SurfaceKind::extrusion) &&
               surface.u_forward && surface.v_forward && statable(all_of(basis.curve));
    }
    default:
        return false;
    }
}

int64_t GeometryWriter::spline(const Spline &spline) {
    if (is_line(spline)) {
        return line(point_of(spline, 0), point_of(spline, 1));
    }
    const int64_t number = begin_spline(text_, spline, dependent, length_);
    text_.end();
    return number;
}

int64_t GeometryWriter::named_spline(const Spline &spline, std::string_view name, int64_t level) {
    const bool flat = spline.dim() == 2;
    const int64_t number = begin_spline(text_, spline, flat ? independent_in_parameters : independent,
                                        flat ? 1 : length_, level);
    text_.end_named(name);
    return number;
}

int64_t GeometryWriter::parameter_curve(const Spline &curve) {
    const int64_t number = begin_spline(text_, curve, in_parameters, 1);
    text_.end();
    return number;
}

int64_t GeometryWriter::point(const Vector3 &at) {
    return text_.add({point_type, 0, dependent}, length_ * at.x, length_ * at.y, length_ * at.z, 0);
}

int64_t GeometryWriter::direction(const Vector3 &way) {
    return text_.add({direction_type, 0, definition_dependent}, way.x, way.y, way.z);
}

int64_t GeometryWriter::line(const Vector3 &from, const Vector3 &to) {
    return text_.add({line_type, 0, dependent}, length_ * from.x, length_ * from.y, length_ * from.z,
                     length_ * to.x, length_ * to.y, length_ * to.z);
}

int64_t GeometryWriter::matrix(const std::array<double, 12> &rows) {
    const auto [known, fresh] = matrices_.try_emplace(rows);
    if (fresh) {
        const Vector3 x{rows[0], rows[4], rows[8]}, y{rows[1], rows[5], rows[9]},
            z{rows[2], rows[6], rows[10]};
        known->second = text_.begin({matrix_type, dot(cross(x, y), z) < 0 ? 1 : 0, definition_dependent});
        for (size_t i = 0; i < rows.size(); ++i) {
            text_.put(i % 4 == 3 ? length_ * rows[i] : rows[i]);
        }
        text_.end();
    }
    return known->second;
}

// The matrix from the plane of a conic to its place; 0 for the identity.
int64_t GeometryWriter::frame(const build::Placement &place) {
    const Vector3 x = first_column(place), y = second_column(place, x), &z = place.z, &o = place.origin;
    const std::array<double, 12> rows{x.x, y.x, z.x, o.x, x.y, y.y, z.y, o.y, x.z, y.z, z.z, o.z};
    return is_identity(rows) ? 0 : matrix(rows);
}

// Arcs run counterclockwise around the axis.
int64_t GeometryWriter::arc(const CurvePiece &piece) {
    const auto &[curve, range, forward] = piece;
    const double r = length_ * curve->sizes[0], end = end_of(range);
    const int64_t place = frame(curve->place);
    const std::array<double, 2> from = place_on_circle(r, range.lower), to = place_on_circle(r, end);
    return text_.add({circular_arc_type, 0, dependent, 0, place}, 0.0, 0.0, 0.0, from[0], from[1], to[0],
                     to[1]);
}

// x^2 / a^2 + y^2 / b^2 = 1.
int64_t GeometryWriter::conic(const CurvePiece &piece) {
    const auto &[curve, range, forward] = piece;
    const double a = length_ * curve->sizes[0], b = length_ * curve->sizes[1];
    const int64_t place = frame(curve->place);
    const auto from = build::Angle::from_radians(range.lower).direction(),
               to = build::Angle::from_radians(end_of(range)).direction();
    return text_.add({conic_arc_type, 1, dependent, 0, place}, 1 / (a * a), 0.0, 1 / (b * b), 0.0, 0.0, -1.0,
                     0.0, a * from.cos, b * from.sin, a * to.cos, b * to.sin);
}

int64_t GeometryWriter::curve(const CurvePiece &piece) {
    const bool all = piece.forward && same(piece.range, model::natural_range(*piece.curve));
    switch (piece.curve->kind) {
    case CurveKind::line: {
        const SplinePtr spline = model::piece_spline(piece);
        return line(point_of(*spline, 0), point_of(*spline, spline->point_count() - 1));
    }
    case CurveKind::circle:
        return arc(piece);
    case CurveKind::ellipse:
        return conic(piece);
    case CurveKind::trimmed:
        return all ? curve(piece.curve->pieces.front()) : spline(*model::piece_spline(piece));
    default:
        return all && piece.curve->spline != nullptr ? spline(*piece.curve->spline)
                                                     : spline(*model::piece_spline(piece));
    }
}

// Form 1, with a reference direction, so that the surface has parameters.
int64_t GeometryWriter::elementary(const SurfaceShape &surface) {
    const int64_t at = point(surface.place.origin), axis = direction(axis_of(surface.place)),
                  x = direction(x_of(surface.place));
    const double size = length_ * surface.sizes[0];
    const auto head = [](int type) { return Head{type, 1, dependent}; };
    switch (surface.kind) {
    case SurfaceKind::cylinder:
        return text_.add(head(cylinder_type), at, axis, size, x);
    case SurfaceKind::cone:
        return text_.add(head(cone_type), at, axis, size, degrees(surface.sizes[1]), x);
    case SurfaceKind::sphere:
        return text_.add(head(sphere_type), at, size, axis, x);
    case SurfaceKind::torus:
        return text_.add(head(torus_type), at, axis, size, length_ * surface.sizes[1], x);
    default:
        return text_.add(head(plane_surface_type), at, axis, x);
    }
}

int64_t GeometryWriter::revolution(const SurfaceShape &surface, Interval angles) {
    const Vector3 from = surface.place.origin;
    const int64_t axis = line(from, from + axis_of(surface.place)), profile = curve(all_of(surface.curve));
    return text_.add({revolution_type, 0, dependent}, axis, profile, angles.lower, angles.upper);
}

int64_t GeometryWriter::extrusion(const SurfaceShape &surface) {
    const CurvePiece directrix = all_of(surface.curve);
    const Vector3 end = model::point_at(*surface.curve, directrix.range.lower) + surface.vector;
    const int64_t pointer = curve(directrix);
    return text_.add({tabulated_type, 0, dependent}, pointer, length_ * end.x, length_ * end.y,
                     length_ * end.z);
}

int64_t GeometryWriter::surface(const SurfaceShape &surface) {
    switch (surface.kind) {
    case SurfaceKind::revolution:
        return revolution(surface, {0, model::turn});
    case SurfaceKind::trimmed:
        return surface.basis->kind == SurfaceKind::revolution ? revolution(*surface.basis, surface.range.u)
                                                              : extrusion(*surface.basis);
    default:
        return elementary(surface);
    }
}

} // namespace nrb::io::iges
