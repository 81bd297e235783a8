/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file fit.hpp
/// \brief Parameters of data, and splines through them.
#ifndef NURBS_CPP_FIT_HPP
#define NURBS_CPP_FIT_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Rules for parameters of points.
inline constexpr std::int32_t params_uniform = NURBS_PARAMS_UNIFORM;
inline constexpr std::int32_t params_chord = NURBS_PARAMS_CHORD;
inline constexpr std::int32_t params_centripetal = NURBS_PARAMS_CENTRIPETAL;
inline constexpr std::int32_t params_power = NURBS_PARAMS_POWER;
inline constexpr std::int32_t params_foley_nielson = NURBS_PARAMS_FOLEY_NIELSON;

/// Ends of interpolating splines.
inline constexpr std::int32_t ends_not_a_knot = NURBS_ENDS_NOT_A_KNOT;
inline constexpr std::int32_t ends_natural = NURBS_ENDS_NATURAL;
inline constexpr std::int32_t ends_free = NURBS_ENDS_FREE;

/// Orders of derivatives that are no number.
inline constexpr std::int32_t order_direction = NURBS_ORDER_DIRECTION;

/// Rules for tangents at points.
inline constexpr std::int32_t tangents_catmull_rom = NURBS_TANGENTS_CATMULL_ROM;
inline constexpr std::int32_t tangents_bessel = NURBS_TANGENTS_BESSEL;
inline constexpr std::int32_t tangents_akima = NURBS_TANGENTS_AKIMA;
inline constexpr std::int32_t tangents_monotone = NURBS_TANGENTS_MONOTONE;

/// Parameters of points on a grid from the distances between them, those of each axis from 0 to 1.
inline Returned<std::vector<double>> parametrize(View<std::int64_t> counts, std::int32_t dim, Input points,
                                                 std::int32_t rule, double exponent = 1,
                                                 std::uint32_t flags = 0) {
    points.require(detail::product<std::int64_t>(counts), dim, "points");
    std::vector<double> values = detail::room(detail::sum(counts));
    detail::call(nurbs_parametrize, detail::axes_of(counts), counts.data(), dim, points.data(),
                 points.stride(), points.component_stride(), rule, exponent, flags, values.data());
    return values;
}

/// Parameters where the basis functions over evenly spaced knots are largest, for interpolation over these.
inline Returned<std::vector<double>> params_universal(std::int32_t degree, std::int64_t count) {
    std::vector<double> values = detail::room(count);
    detail::call(nurbs_params_universal, degree, count, values.data());
    return values;
}

/// The spline, and the largest distance of a point from it.
struct Interpolated {
    Spline spline;   ///< The spline.
    double residual; ///< The largest distance of a point from the spline at its parameter.
};

/// The spline through points on a grid of parameters; without ends, not-a-knot.
inline Returned<Interpolated> interpolate(View<std::int32_t> degrees, View<std::int64_t> counts,
                                          View<double> params, std::int32_t dim, Input points,
                                          View<std::int32_t> ends = {}, std::uint32_t flags = 0) {
    const std::int64_t axes = detail::length(degrees);
    detail::require(counts, axes, "counts");
    detail::require_given(ends, 2 * axes, "ends");
    detail::require(params, detail::sum(counts), "params");
    points.require(detail::product<std::int64_t>(counts), dim, "points");
    Interpolated made{};
    made.spline =
        detail::made<Spline>(nurbs_interpolate, detail::axes_of(degrees), degrees.data(), counts.data(),
                             params.data(), dim, points.data(), points.stride(), points.component_stride(),
                             detail::pointer(ends), flags, &made.residual);
    return made;
}

/// The spline over full knot vectors, all axes one after the other, through points on a grid of parameters.
inline Returned<Spline> interpolate_over_knots(View<std::int32_t> degrees, View<std::int64_t> counts,
                                               View<double> params, View<double> knots, std::int32_t dim,
                                               Input points, std::uint32_t flags = 0) {
    detail::require(counts, detail::length(degrees), "counts");
    detail::require(params, detail::sum(counts), "params");
    points.require(detail::product<std::int64_t>(counts), dim, "points");
    return detail::made<Spline>(nurbs_interpolate_over_knots, detail::axes_of(degrees), degrees.data(),
                                counts.data(), params.data(), knots.data(), detail::length(knots), dim,
                                points.data(), points.stride(), points.component_stride(), flags);
}

/// The spline through layers of points and, at the ends of axes, of derivatives; mixed ones may be NaN.
inline Returned<Spline> interpolate_derivatives(View<std::int32_t> degrees, View<std::int64_t> counts,
                                                View<double> params, View<std::int32_t> orders,
                                                std::int32_t dim, Input values, View<std::int32_t> ends = {},
                                                std::uint32_t flags = 0) {
    const std::int64_t axes = detail::length(degrees);
    detail::require(counts, axes, "counts");
    detail::require_given(ends, 2 * axes, "ends");
    const std::int64_t total = detail::sum(counts);
    detail::require(params, total, "params");
    detail::require(orders, total, "orders");
    values.require(detail::product<std::int64_t>(counts), dim, "values");
    return detail::made<Spline>(nurbs_interpolate_derivatives, detail::axes_of(degrees), degrees.data(),
                                counts.data(), params.data(), orders.data(), dim, values.data(),
                                values.stride(), values.component_stride(), detail::pointer(ends), flags);
}

/// The curve with given points and derivatives; without orders, points; without knots, averaged ones.
inline Returned<Spline> curve_interpolate(std::int32_t degree, View<double> params, std::int32_t dim,
                                          Input targets, View<std::int32_t> orders = {},
                                          View<double> knots = {}, std::uint32_t flags = 0) {
    const std::int64_t n = detail::length(params);
    targets.require(n, dim, "targets");
    detail::require_given(orders, n, "orders");
    return detail::made<Spline>(nurbs_curve_interpolate, degree, n, params.data(), detail::pointer(orders),
                                dim, targets.data(), targets.stride(), targets.component_stride(),
                                detail::pointer(knots), detail::length(knots), flags);
}

/// The factors that make derivatives of targets of which curve_interpolate() is told the directions.
inline Returned<std::vector<double>> tangent_lengths(std::int32_t degree, View<double> params,
                                                     std::int32_t dim, Input targets,
                                                     View<std::int32_t> orders, View<double> knots = {},
                                                     std::uint32_t flags = 0) {
    const std::int64_t n = detail::length(params);
    targets.require(n, dim, "targets");
    detail::require(orders, n, "orders");
    std::vector<double> values = detail::room(n);
    detail::call(nurbs_tangent_lengths, degree, n, params.data(), orders.data(), dim, targets.data(),
                 targets.stride(), targets.component_stride(), detail::pointer(knots), detail::length(knots),
                 flags, values.data());
    return values;
}

/// Derivatives at the points of a curve from the points near them, as create_hermite() takes them.
inline Returned<std::vector<double>> tangents(std::int32_t rule, View<double> params, std::int32_t dim,
                                              Input points, std::uint32_t flags = 0) {
    const std::int64_t n = detail::length(params);
    points.require(n, dim, "points");
    std::vector<double> values = detail::room(n, dim);
    detail::call(nurbs_tangents, rule, n, params.data(), dim, points.data(), points.stride(),
                 points.component_stride(), flags, values.data(), 0, 0);
    return values;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_FIT_HPP
