/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file curves.hpp
/// \brief Lines, conics and helices.
#ifndef NURBS_CPP_CURVES_HPP
#define NURBS_CPP_CURVES_HPP

#include <nurbs/cpp/placement.hpp>
#include <nurbs/cpp/spline.hpp>

#include <array>
#include <cstdint>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Kinds of conics.
inline constexpr std::int32_t conic_ellipse = NURBS_CONIC_ELLIPSE;
inline constexpr std::int32_t conic_parabola = NURBS_CONIC_PARABOLA;
inline constexpr std::int32_t conic_hyperbola = NURBS_CONIC_HYPERBOLA;
inline constexpr std::int32_t conic_chord = NURBS_CONIC_CHORD;
inline constexpr std::int32_t conic_legs = NURBS_CONIC_LEGS;
inline constexpr std::int32_t conic_line = NURBS_CONIC_LINE;

// Lines

/// From a to b.
inline Returned<Spline> line(View<double> a, View<double> b) {
    const auto dim = static_cast<std::int32_t>(a.size());
    detail::require_length(dim, {b});
    return detail::made<Spline>(nurbs_curve_line, dim, a.data(), b.data());
}

/// Through points [n][dim], at 0, 1, ..., n - 1 unless parameters are given.
inline Returned<Spline> polyline(std::int32_t dim, Input points, Input params = {}) {
    const std::int64_t n = detail::records(points, dim, "points");
    detail::require_wanted(params, n, 1, "params");
    return detail::made<Spline>(nurbs_curve_polyline, n, dim, points.data(), points.stride(),
                                points.component_stride(), detail::pointer(params), params.step());
}

/// A closed regular polygon; the radius is that of its corners.
inline Returned<Spline> polygon(const Placement &at, double radius, std::int64_t sides) {
    const detail::Place place(at);
    return detail::made<Spline>(nurbs_curve_polygon, place.dim, place.origin, place.axis, place.x, radius,
                                sides);
}

/// A rectangle about a centre, its corners quarter circles.
inline Returned<Spline> rounded_rectangle(const Placement &at, double width, double height,
                                          double corner_radius) {
    const detail::Place place(at);
    return detail::made<Spline>(nurbs_curve_rounded_rectangle, place.dim, place.origin, place.axis, place.x,
                                width, height, corner_radius);
}

// Circles

/// A full circle.
inline Returned<Spline> circle(const Placement &at, double radius, std::int32_t form = arc_quarters) {
    const detail::Place place(at);
    return detail::made<Spline>(nurbs_curve_circle, place.dim, place.origin, place.axis, place.x, radius,
                                form);
}

/// A part of a circle.
inline Returned<Spline> arc(const Placement &at, double radius, double start, double sweep,
                            std::int32_t form = arc_quarters) {
    const detail::Place place(at);
    return detail::made<Spline>(nurbs_curve_arc, place.dim, place.origin, place.axis, place.x, radius, start,
                                sweep, form);
}

/// From a through b to c.
inline Returned<Spline> arc_through(View<double> a, View<double> b, View<double> c,
                                    std::int32_t form = arc_quarters) {
    const auto dim = static_cast<std::int32_t>(a.size());
    detail::require_length(dim, {b, c});
    return detail::made<Spline>(nurbs_curve_arc_through, dim, a.data(), b.data(), c.data(), form);
}

/// From a in the direction of a tangent to b.
inline Returned<Spline> arc_tangent(View<double> a, View<double> tangent, View<double> b,
                                    std::int32_t form = arc_quarters) {
    const auto dim = static_cast<std::int32_t>(a.size());
    detail::require_length(dim, {tangent, b});
    return detail::made<Spline>(nurbs_curve_arc_tangent, dim, a.data(), tangent.data(), b.data(), form);
}

// Conics

/// Semi-axes along X and Y; angles are eccentric ones.
inline Returned<Spline> ellipse(const Placement &at, double radius_x, double radius_y, double start = 0,
                                double sweep = full_turn, std::int32_t form = arc_quarters) {
    const detail::Place place(at);
    return detail::made<Spline>(nurbs_curve_ellipse, place.dim, place.origin, place.axis, place.x, radius_x,
                                radius_y, start, sweep, form);
}

/// Over [start, end], the coordinates along Y; x points from the vertex to the focus.
inline Returned<Spline> parabola(const Placement &at, double focal_length, double start, double end) {
    const detail::Place place(at);
    return detail::made<Spline>(nurbs_curve_parabola, place.dim, place.origin, place.axis, place.x,
                                focal_length, start, end);
}

/// The branch that opens to x.
inline Returned<Spline> hyperbola(const Placement &at, double radius_x, double radius_y, double start,
                                  double end) {
    const detail::Place place(at);
    return detail::made<Spline>(nurbs_curve_hyperbola, place.dim, place.origin, place.axis, place.x, radius_x,
                                radius_y, start, end);
}

/// By a control triangle and C_sf = w1^2 / (w0 w2).
inline Returned<Spline> conic_triangle(View<double> p0, View<double> p1, View<double> p2,
                                       double shape_factor) {
    const auto dim = static_cast<std::int32_t>(p0.size());
    detail::require_length(dim, {p1, p2});
    return detail::made<Spline>(nurbs_curve_conic_triangle, dim, p0.data(), p1.data(), p2.data(),
                                shape_factor);
}

/// By two points with tangents, and how far the shoulder point is on its way from the chord to the tangents.
inline Returned<Spline> conic_shoulder(View<double> a, View<double> tangent_a, View<double> b,
                                       View<double> tangent_b, double rho) {
    const auto dim = static_cast<std::int32_t>(a.size());
    detail::require_length(dim, {tangent_a, b, tangent_b});
    return detail::made<Spline>(nurbs_curve_conic_shoulder, dim, a.data(), tangent_a.data(), b.data(),
                                tangent_b.data(), rho);
}

/// By two points with tangent lines, and a third point between them.
inline Returned<Spline> conic_point(View<double> a, View<double> tangent_a, View<double> b,
                                    View<double> tangent_b, View<double> point,
                                    std::int32_t form = arc_quarters) {
    const auto dim = static_cast<std::int32_t>(a.size());
    detail::require_length(dim, {tangent_a, b, tangent_b, point});
    return detail::made<Spline>(nurbs_curve_conic_point, dim, a.data(), tangent_a.data(), b.data(),
                                tangent_b.data(), point.data(), form);
}

/// Through five points [5][dim].
inline Returned<Spline> conic_through(std::int32_t dim, Input points, std::int32_t form = arc_quarters) {
    points.require(5, dim, "points");
    return detail::made<Spline>(nurbs_curve_conic_through, dim, points.data(), points.stride(),
                                points.component_stride(), form);
}

/// A conic of the plane: its kind, centre or vertex, the direction to its vertex or focus, and semi-axes or
/// focal length.
struct ConicAxes {
    std::int32_t type;            ///< One of the conic_ constants.
    std::array<double, 2> origin; ///< Centre or vertex.
    std::array<double, 2> x;      ///< Direction to the vertex or focus.
    std::array<double, 2> sizes;  ///< Semi-axes, or the focal length.
};

/// Kind and axes of A x^2 + B x y + C y^2 + D x + E y + F = 0.
inline Returned<ConicAxes> conic_axes(const std::array<double, 6> &coefficients) {
    ConicAxes found{};
    detail::call(nurbs_conic_axes, coefficients.data(), &found.type, found.origin.data(), found.x.data(),
                 found.sizes.data());
    return found;
}

/// An arc of the conic that `conic_axes` describes.
inline Returned<Spline> conic_implicit(const std::array<double, 6> &coefficients, double start, double end,
                                       std::int32_t form = arc_quarters) {
    return detail::made<Spline>(nurbs_curve_conic_implicit, coefficients.data(), start, end, form);
}

/// By a focus, the nearest point of the directrix, and the eccentricity; in space also by the axis.
inline Returned<Spline> conic_focus(View<double> focus, View<double> foot, double eccentricity, double start,
                                    double sweep, std::int32_t form = arc_quarters, View<double> axis = {}) {
    const std::int32_t dim = detail::dimension_of({focus, axis}, 0);
    detail::require_length(dim, {foot});
    return detail::made<Spline>(nurbs_curve_conic_focus, dim, focus.data(), detail::pointer(axis),
                                foot.data(), eccentricity, start, sweep, form);
}

/// The shape factor of a conic, and its kind.
struct ShapeFactor {
    double factor;     ///< C_sf = w1^2 / (w0 w2).
    std::int32_t type; ///< One of the conic_ constants.
};

/// C_sf and the kind, a conic_ constant, of a conic segment of degree 2.
inline Returned<ShapeFactor> shape_factor(const Spline &g) {
    ShapeFactor found{};
    detail::call(nurbs_curve_shape_factor, g.get(), &found.factor, &found.type);
    return found;
}

/// A helix, where radius and height change evenly with the angle.
struct HelixShape {
    double radius = 1; ///< At the start.
    double growth = 0; ///< Of the radius in a turn.
    double pitch = 0;  ///< Rise in a turn.
    double start = 0;  ///< The angle where it starts.
    double turns = 1;  ///< How many there are.
};

/// The curve, and a proven bound of its distance from the true one.
struct Helix {
    Spline spline; ///< The curve.
    double error;  ///< A proven bound of its distance from the true one.
};

// Helices

/// The curve, and a proven bound of its distance from the true one.
inline Returned<Helix> helix(const Placement &at, const HelixShape &shape, double tolerance) {
    const detail::Place place(at, 3);
    Helix made{};
    made.spline =
        detail::made<Spline>(nurbs_curve_helix, place.dim, place.origin, place.axis, place.x, shape.radius,
                             shape.growth, shape.pitch, shape.start, shape.turns, tolerance, &made.error);
    return made;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_CURVES_HPP
