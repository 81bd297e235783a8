/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file spline.hpp
/// \brief The class of curves, surfaces and volumes.
#ifndef NURBS_CPP_SPLINE_HPP
#define NURBS_CPP_SPLINE_HPP

#include <nurbs/cpp/handles.hpp>
#include <nurbs/cpp/sizes.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Control points, each once.
struct UnwrappedPoints {
    std::vector<double> points;  ///< Cartesian, [n][dim].
    std::vector<double> weights; ///< All 1 for a polynomial spline.
};

/// Knots without repetition.
struct DistinctKnots {
    std::vector<double> knots;                ///< In rising order.
    std::vector<std::int32_t> multiplicities; ///< How often each of them occurs.
};

/// Number of partial derivatives of orders 0 to `order`: binomial(order + axes, axes).
inline Returned<std::int64_t> derivative_slots(std::int32_t axes, std::int32_t order) {
    return detail::result_of<std::int64_t>([&](auto *v) { return nurbs_derivative_slots(axes, order, v); });
}

/// Active basis functions at parameters: where they start, and their values.
struct Basis {
    std::vector<std::int64_t> spans; ///< The span of each parameter.
    std::vector<double> values;      ///< Of the functions that are active there.
};

/// The gradients of active basis functions at parameters: where they start, and the vectors.
struct BasisGradients {
    std::vector<std::int64_t> spans; ///< The span of each parameter.
    std::vector<double> gradients;   ///< Of the functions that are active there.
};

/// A curve, surface or volume: a handle that is copied in constant time and freed by its destructor.
class Spline : public detail::SplineHandle {
public:
    using SplineHandle::SplineHandle;

    // Construction

    /// A spline from full knot vectors, all axes one after the other; the last axis of the points is the fastest.
    static Returned<Spline> create(View<std::int32_t> degrees, View<std::int64_t> counts, View<double> knots,
                                   std::int32_t dim, Input points, Input weights = {},
                                   std::uint32_t flags = 0) {
        detail::require(counts, detail::length(degrees), "counts");
        const std::int64_t net_size = detail::product<std::int64_t>(counts);
        points.require(net_size, dim, "points");
        detail::require_wanted(weights, net_size, 1, "weights");
        return detail::made<Spline>(nurbs_create, detail::axes_of(degrees), degrees.data(), counts.data(),
                                    knots.data(), detail::length(knots), dim, points.data(), points.stride(),
                                    points.component_stride(), detail::pointer(weights), weights.step(),
                                    flags);
    }
    /// A rational spline from points (w x, w y, ..., w).
    static Returned<Spline> create_homogeneous(View<std::int32_t> degrees, View<std::int64_t> counts,
                                               View<double> knots, std::int32_t dim, Input points,
                                               std::uint32_t flags = 0) {
        detail::require(counts, detail::length(degrees), "counts");
        points.require(detail::product<std::int64_t>(counts), std::int64_t{dim} + 1, "points");
        return detail::made<Spline>(nurbs_create_homogeneous, detail::axes_of(degrees), degrees.data(),
                                    counts.data(), knots.data(), detail::length(knots), dim, points.data(),
                                    points.stride(), points.component_stride(), flags);
    }
    /// A spline from knot vectors without their first and last knot.
    static Returned<Spline> create_short(View<std::int32_t> degrees, View<std::int64_t> counts,
                                         View<double> knots, std::int32_t dim, Input points,
                                         Input weights = {}, std::uint32_t flags = 0) {
        detail::require(counts, detail::length(degrees), "counts");
        const std::int64_t net_size = detail::product<std::int64_t>(counts);
        points.require(net_size, dim, "points");
        detail::require_wanted(weights, net_size, 1, "weights");
        return detail::made<Spline>(nurbs_create_short, detail::axes_of(degrees), degrees.data(),
                                    counts.data(), knots.data(), detail::length(knots), dim, points.data(),
                                    points.stride(), points.component_stride(), detail::pointer(weights),
                                    weights.step(), flags);
    }
    /// A spline from distinct knots with multiplicities, one pair of vectors for each axis.
    static Returned<Spline> create_multiplicities(View<std::int32_t> degrees, View<std::int64_t> counts,
                                                  View<std::int64_t> distinct_counts,
                                                  View<double> distinct_knots,
                                                  View<std::int32_t> multiplicities, std::int32_t dim,
                                                  Input points, Input weights = {}, std::uint32_t flags = 0) {
        const std::int64_t axes = detail::length(degrees);
        detail::require(counts, axes, "counts");
        detail::require(distinct_counts, axes, "distinct_counts");
        const std::int64_t total = detail::sum(distinct_counts);
        detail::require(distinct_knots, total, "distinct_knots");
        detail::require(multiplicities, total, "multiplicities");
        const std::int64_t net_size = detail::product<std::int64_t>(counts);
        points.require(net_size, dim, "points");
        detail::require_wanted(weights, net_size, 1, "weights");
        return detail::made<Spline>(
            nurbs_create_multiplicities, detail::axes_of(degrees), degrees.data(), counts.data(),
            distinct_counts.data(), distinct_knots.data(), multiplicities.data(), dim, points.data(),
            points.stride(), points.component_stride(), detail::pointer(weights), weights.step(), flags);
    }
    /// A spline whose periodic axes are given without what they repeat: counts of control points that differ, and
    /// the knots of one period with its end.
    static Returned<Spline> create_periodic(View<std::int32_t> degrees, View<std::int64_t> counts,
                                            View<double> knots, std::int32_t dim, Input points,
                                            Input weights = {}, std::uint32_t flags = 0) {
        detail::require(counts, detail::length(degrees), "counts");
        const std::int64_t net_size = detail::product<std::int64_t>(counts);
        points.require(net_size, dim, "points");
        detail::require_wanted(weights, net_size, 1, "weights");
        return detail::made<Spline>(nurbs_create_periodic, detail::axes_of(degrees), degrees.data(),
                                    counts.data(), knots.data(), detail::length(knots), dim, points.data(),
                                    points.stride(), points.component_stride(), detail::pointer(weights),
                                    weights.step(), flags);
    }
    /// A Bezier spline over [0, 1] on every axis.
    static Returned<Spline> create_bezier(View<std::int32_t> degrees, std::int32_t dim, Input points,
                                          Input weights = {}) {
        const std::int64_t net_size = detail::piece_points(degrees);
        points.require(net_size, dim, "points");
        detail::require_wanted(weights, net_size, 1, "weights");
        return detail::made<Spline>(nurbs_create_bezier, detail::axes_of(degrees), degrees.data(), dim,
                                    points.data(), points.stride(), points.component_stride(),
                                    detail::pointer(weights), weights.step());
    }
    /// The same knots with other points, and other weights if any are given.
    [[nodiscard]] Returned<Spline> with_points(Input points, Input weights = {}) const {
        const std::int64_t net_size = detail::point_count(get());
        points.require(net_size, detail::dimension(get()), "points");
        detail::require_wanted(weights, net_size, 1, "weights");
        return detail::made<Spline>(nurbs_with_points, get(), points.data(), points.stride(),
                                    points.component_stride(), detail::pointer(weights), weights.step());
    }
    /// The spline of what to_bytes() made of it, bit for bit.
    static Returned<Spline> from_bytes(std::span<const std::byte> bytes) {
        return detail::made<Spline>(nurbs_from_bytes, bytes.data(), detail::length(bytes));
    }
    /// Another handle on the same data, in constant time.
    [[nodiscard]] Returned<Spline> clone() const { return detail::made<Spline>(nurbs_clone, get()); }

    // Questions about a spline

    /// Number of parametric axes: 1, 2 or 3.
    [[nodiscard]] Returned<std::int32_t> axes() const {
        return detail::result_of<std::int32_t>([&](auto *v) { return nurbs_axes(get(), v); });
    }
    /// Number of coordinates of a point.
    [[nodiscard]] Returned<std::int32_t> dimension() const {
        return detail::result_of<std::int32_t>([&](auto *v) { return nurbs_dimension(get(), v); });
    }
    /// Degree along an axis.
    [[nodiscard]] Returned<std::int32_t> degree(std::int32_t axis) const {
        return detail::result_of<std::int32_t>([&](auto *v) { return nurbs_degree(get(), axis, v); });
    }
    /// Number of control points along an axis.
    [[nodiscard]] Returned<std::int64_t> count(std::int32_t axis) const {
        return detail::result_of<std::int64_t>([&](auto *v) { return nurbs_count(get(), axis, v); });
    }
    /// Number of control points of all axes together.
    [[nodiscard]] Returned<std::int64_t> point_count() const {
        return detail::result_of<std::int64_t>([&](auto *v) { return nurbs_point_count(get(), v); });
    }
    /// Whether it has weights.
    [[nodiscard]] Returned<bool> is_rational() const {
        return detail::result_of<std::int32_t>([&](auto *v) { return nurbs_is_rational(get(), v); }) != 0;
    }
    /// Whether homogeneous points are stored, and not Cartesian ones with or without weights.
    [[nodiscard]] Returned<bool> is_homogeneous() const {
        return detail::result_of<std::int32_t>([&](auto *v) { return nurbs_is_homogeneous(get(), v); }) != 0;
    }
    /// Sum of form_ bits.
    [[nodiscard]] Returned<std::int32_t> knot_form(std::int32_t axis) const {
        return detail::result_of<std::int32_t>([&](auto *v) { return nurbs_knot_form(get(), axis, v); });
    }
    /// The ends of the domain of an axis.
    [[nodiscard]] Returned<std::array<double, 2>> domain(std::int32_t axis) const {
        return detail::result_of<std::array<double, 2>>(
            [&](auto *v) { return nurbs_domain(get(), axis, v->data()); });
    }
    /// The full knot vector.
    [[nodiscard]] Returned<std::vector<double>> knots(std::int32_t axis) const {
        const std::int64_t knot_count = detail::count(get(), axis) + detail::degree(get(), axis) + 1;
        std::vector<double> values = detail::room(knot_count);
        detail::call(nurbs_knots, get(), axis, knot_count, values.data());
        return values;
    }
    /// The knot vector without its first and last knot.
    [[nodiscard]] Returned<std::vector<double>> short_knots(std::int32_t axis) const {
        std::vector<double> values;
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_short_knots, get(), axis, cap, values.data(), &count);
        };
        ask(0);
        values = detail::room(count);
        ask(count);
        return values;
    }
    /// Number of control points along an axis, each counted once.
    [[nodiscard]] Returned<std::int64_t> unwrapped_count(std::int32_t axis) const {
        return detail::result_of<std::int64_t>(
            [&](auto *v) { return nurbs_unwrapped_count(get(), axis, v); });
    }
    /// The knots of one period with its end; of an axis that is not periodic all of them.
    [[nodiscard]] Returned<std::vector<double>> unwrapped_knots(std::int32_t axis) const {
        std::vector<double> values;
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_unwrapped_knots, get(), axis, cap, values.data(), &count);
        };
        ask(0);
        values = detail::room(count);
        ask(count);
        return values;
    }
    /// Control points and weights, each once.
    [[nodiscard]] Returned<UnwrappedPoints> unwrapped_points() const {
        UnwrappedPoints found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_unwrapped_points, get(), cap, found.points.data(), found.weights.data(),
                         &count);
        };
        ask(0);
        found.points = detail::room(count, detail::dimension(get()));
        found.weights = detail::room(count);
        ask(count);
        return found;
    }
    /// The knots without repetition, and how often each occurs.
    [[nodiscard]] Returned<DistinctKnots> distinct_knots(std::int32_t axis) const {
        DistinctKnots found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_distinct_knots, get(), axis, cap, found.knots.data(),
                         found.multiplicities.data(), &count);
        };
        ask(0);
        found.knots = detail::room(count);
        found.multiplicities = detail::room<std::int32_t>(count);
        ask(count);
        return found;
    }
    /// The Greville abscissa of each control point along an axis.
    [[nodiscard]] Returned<std::vector<double>> greville(std::int32_t axis) const {
        const std::int64_t count = detail::count(get(), axis);
        std::vector<double> values = detail::room(count);
        detail::call(nurbs_greville, get(), axis, count, values.data());
        return values;
    }
    /// Cartesian control points, [n][dim].
    Returned<void> points(Output points) const {
        const std::int64_t net_size = detail::point_count(get());
        points.require(net_size, detail::dimension(get()), "points");
        return detail::call(nurbs_points, get(), net_size, points.data(), points.stride(),
                            points.component_stride());
    }
    /// The same, as a vector.
    [[nodiscard]] Returned<std::vector<double>> points() const {
        std::vector<double> values = detail::room(detail::point_count(get()), detail::dimension(get()));
        detail::run([&] { return points(values); });
        return values;
    }
    /// Weights, all 1 for a polynomial spline.
    Returned<void> weights(Output weights) const {
        const std::int64_t net_size = detail::point_count(get());
        weights.require(net_size, 1, "weights");
        return detail::call(nurbs_weights, get(), net_size, weights.data(), weights.step());
    }
    /// The same, as a vector.
    [[nodiscard]] Returned<std::vector<double>> weights() const {
        std::vector<double> values = detail::room(detail::point_count(get()));
        detail::run([&] { return weights(values); });
        return values;
    }
    /// Homogeneous control points, [n][dim + 1].
    Returned<void> homogeneous_points(Output points) const {
        const std::int64_t net_size = detail::point_count(get());
        points.require(net_size, detail::dimension(get()) + 1, "points");
        return detail::call(nurbs_homogeneous_points, get(), net_size, points.data(), points.stride(),
                            points.component_stride());
    }
    /// The same, as a vector.
    [[nodiscard]] Returned<std::vector<double>> homogeneous_points() const {
        std::vector<double> values = detail::room(detail::point_count(get()), detail::dimension(get()) + 1);
        detail::run([&] { return homogeneous_points(values); });
        return values;
    }
    /// The `hull` of the accuracy contract at each parameter.
    Returned<void> hull_size(Input params, Output sizes, std::uint32_t flags = 0) const {
        const std::int64_t n = detail::records(params, detail::axes(get()), "params");
        sizes.require(n, 1, "sizes");
        return detail::call(nurbs_hull_size, get(), n, params.data(), params.stride(),
                            params.component_stride(), sizes.data(), sizes.step(), flags);
    }
    /// The same, as a vector.
    [[nodiscard]] Returned<std::vector<double>> hull_size(Input params, std::uint32_t flags = 0) const {
        const std::int64_t n = detail::records(params, detail::axes(get()), "params");
        std::vector<double> values = detail::room(n);
        detail::run([&] { return hull_size(params, values, flags); });
        return values;
    }

    // Evaluation

    /// Points [n][dim] at parameters [n][axes].
    Returned<void> eval(Input params, Output points, std::uint32_t flags = 0) const {
        const std::int64_t n = detail::records(params, detail::axes(get()), "params");
        points.require(n, detail::dimension(get()), "points");
        return detail::call(nurbs_eval, get(), n, params.data(), params.stride(), params.component_stride(),
                            points.data(), points.stride(), points.component_stride(), flags);
    }
    /// The same, as a vector.
    [[nodiscard]] Returned<std::vector<double>> eval(Input params, std::uint32_t flags = 0) const {
        const std::int64_t n = detail::records(params, detail::axes(get()), "params");
        std::vector<double> values = detail::room(n, detail::dimension(get()));
        detail::run([&] { return eval(params, values, flags); });
        return values;
    }
    /// Points and partial derivatives [n][slots][dim].
    Returned<void> eval_derivs(std::int32_t order, Input params, Output derivs,
                               std::uint32_t flags = 0) const {
        const std::int64_t n = detail::records(params, detail::axes(get()), "params");
        derivs.require(n, detail::slots(get(), order) * detail::dimension(get()), "derivs");
        return detail::call(nurbs_eval_derivs, get(), order, n, params.data(), params.stride(),
                            params.component_stride(), derivs.data(), derivs.stride(),
                            derivs.component_stride(), flags);
    }
    /// The same, as a vector.
    [[nodiscard]] Returned<std::vector<double>> eval_derivs(std::int32_t order, Input params,
                                                            std::uint32_t flags = 0) const {
        const std::int64_t n = detail::records(params, detail::axes(get()), "params");
        std::vector<double> values = detail::room(n, detail::slots(get(), order), detail::dimension(get()));
        detail::run([&] { return eval_derivs(order, params, values, flags); });
        return values;
    }
    /// Points on the grid of the given parameters, those of all axes one after the other.
    Returned<void> eval_grid(View<std::int64_t> counts, View<double> params, Output points,
                             std::uint32_t flags = 0) const {
        detail::require(counts, detail::axes(get()), "counts");
        detail::require_unless_negative(params, detail::sum(counts), "params");
        points.require(detail::product<std::int64_t>(counts), detail::dimension(get()), "points");
        return detail::call(nurbs_eval_grid, get(), counts.data(), params.data(), points.data(),
                            points.stride(), points.component_stride(), flags);
    }
    /// The same, as a vector.
    [[nodiscard]] Returned<std::vector<double>> eval_grid(View<std::int64_t> counts, View<double> params,
                                                          std::uint32_t flags = 0) const {
        detail::require(counts, detail::axes(get()), "counts");
        detail::require_unless_negative(params, detail::sum(counts), "params");
        std::vector<double> values =
            detail::room(detail::product<std::int64_t>(counts), detail::dimension(get()));
        detail::run([&] { return eval_grid(counts, params, values, flags); });
        return values;
    }
    /// Points and partial derivatives on a grid.
    Returned<void> eval_grid_derivs(std::int32_t order, View<std::int64_t> counts, View<double> params,
                                    Output derivs, std::uint32_t flags = 0) const {
        detail::require(counts, detail::axes(get()), "counts");
        detail::require_unless_negative(params, detail::sum(counts), "params");
        derivs.require(detail::product<std::int64_t>(counts),
                       detail::slots(get(), order) * detail::dimension(get()), "derivs");
        return detail::call(nurbs_eval_grid_derivs, get(), order, counts.data(), params.data(), derivs.data(),
                            derivs.stride(), derivs.component_stride(), flags);
    }
    /// The same, as a vector.
    [[nodiscard]] Returned<std::vector<double>> eval_grid_derivs(std::int32_t order,
                                                                 View<std::int64_t> counts,
                                                                 View<double> params,
                                                                 std::uint32_t flags = 0) const {
        detail::require(counts, detail::axes(get()), "counts");
        detail::require_unless_negative(params, detail::sum(counts), "params");
        std::vector<double> values = detail::room(detail::product<std::int64_t>(counts),
                                                  detail::slots(get(), order), detail::dimension(get()));
        detail::run([&] { return eval_grid_derivs(order, counts, params, values, flags); });
        return values;
    }
    /// Points in single precision: those of eval(), rounded once.
    Returned<void> eval_f32(Input params, FloatOutput points, std::uint32_t flags = 0) const {
        const std::int64_t n = detail::records(params, detail::axes(get()), "params");
        points.require(n, detail::dimension(get()), "points");
        return detail::call(nurbs_eval_f32, get(), n, params.data(), params.stride(),
                            params.component_stride(), points.data(), points.stride(),
                            points.component_stride(), flags);
    }
    /// The same, as a vector.
    [[nodiscard]] Returned<std::vector<float>> eval_f32(Input params, std::uint32_t flags = 0) const {
        const std::int64_t n = detail::records(params, detail::axes(get()), "params");
        std::vector<float> values = detail::room<float>(n, detail::dimension(get()));
        detail::run([&] { return eval_f32(params, values, flags); });
        return values;
    }
    /// Points on a grid in single precision: those of eval_grid(), rounded once.
    Returned<void> eval_grid_f32(View<std::int64_t> counts, View<double> params, FloatOutput points,
                                 std::uint32_t flags = 0) const {
        detail::require(counts, detail::axes(get()), "counts");
        detail::require_unless_negative(params, detail::sum(counts), "params");
        points.require(detail::product<std::int64_t>(counts), detail::dimension(get()), "points");
        return detail::call(nurbs_eval_grid_f32, get(), counts.data(), params.data(), points.data(),
                            points.stride(), points.component_stride(), flags);
    }
    /// The same, as a vector.
    [[nodiscard]] Returned<std::vector<float>> eval_grid_f32(View<std::int64_t> counts, View<double> params,
                                                             std::uint32_t flags = 0) const {
        detail::require(counts, detail::axes(get()), "counts");
        detail::require_unless_negative(params, detail::sum(counts), "params");
        std::vector<float> values =
            detail::room<float>(detail::product<std::int64_t>(counts), detail::dimension(get()));
        detail::run([&] { return eval_grid_f32(counts, params, values, flags); });
        return values;
    }
    /// R_i at each parameter; the spans are [n][axes].
    [[nodiscard]] Returned<Basis> rational_basis(Input params, std::uint32_t flags = 0) const {
        const std::int64_t axes = detail::axes(get());
        const std::int64_t n = detail::records(params, axes, "params");
        Basis found{detail::room<std::int64_t>(n, axes), detail::room(n, detail::active(get()))};
        detail::call(nurbs_rational_basis, get(), n, params.data(), params.stride(),
                     params.component_stride(), found.spans.data(), found.values.data(), 0, 0, flags);
        return found;
    }
    /// The gradients in space of the R_i at each parameter, [n][M][dim]; the spans are [n][axes].
    [[nodiscard]] Returned<BasisGradients> basis_gradients(Input params, std::uint32_t flags = 0) const {
        const std::int64_t axes = detail::axes(get());
        const std::int64_t n = detail::records(params, axes, "params");
        BasisGradients found{detail::room<std::int64_t>(n, axes),
                             detail::room(n, detail::active(get()), detail::dimension(get()))};
        detail::call(nurbs_basis_gradients, get(), n, params.data(), params.stride(),
                     params.component_stride(), found.spans.data(), found.gradients.data(), 0, 0, flags);
        return found;
    }

    // Exact refinement, and parts of a spline

    /// The spline of one axis less on which the parameter of `axis` is fixed.
    [[nodiscard]] Returned<Spline> iso(std::int32_t axis, double param, std::uint32_t flags = 0) const {
        return detail::made<Spline>(nurbs_iso, get(), axis, param, flags);
    }
    /// The same shape with a knot inserted.
    [[nodiscard]] Returned<Spline> insert_knot(std::int32_t axis, double knot, std::int32_t times = 1) const {
        return detail::made<Spline>(nurbs_insert_knot, get(), axis, knot, times);
    }
    /// The same shape with a list of knots inserted, in any order.
    [[nodiscard]] Returned<Spline> refine(std::int32_t axis, View<double> knots) const {
        return detail::made<Spline>(nurbs_refine, get(), axis, detail::length(knots), knots.data());
    }
    /// The same shape with every non-empty span divided into equal parts.
    [[nodiscard]] Returned<Spline> refine_uniform(std::int32_t axis, std::int64_t parts) const {
        return detail::made<Spline>(nurbs_refine_uniform, get(), axis, parts);
    }
    /// The parts below and above a parameter.
    [[nodiscard]] Returned<std::pair<Spline, Spline>> split(std::int32_t axis, double param) const {
        nurbs *lower = nullptr, *upper = nullptr;
        detail::call(nurbs_split, get(), axis, param, &lower, &upper);
        return std::pair(Spline(lower), Spline(upper));
    }
    /// The part over a box in the domain: the ends on each axis.
    [[nodiscard]] Returned<Spline> extract(View<double> lower, View<double> upper) const {
        const std::int64_t axes = detail::axes(get());
        detail::require(lower, axes, "lower");
        detail::require(upper, axes, "upper");
        return detail::made<Spline>(nurbs_extract, get(), lower.data(), upper.data());
    }
    /// The same shape with clamped ends; flags 0 only open a periodic axis.
    [[nodiscard]] Returned<Spline>
    clamp(std::int32_t axis, std::uint32_t flags = NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END) const {
        return detail::made<Spline>(nurbs_clamp_ends, get(), axis, flags);
    }
    /// The same shape on a periodic axis over [param, param + period].
    [[nodiscard]] Returned<Spline> move_seam(std::int32_t axis, double param) const {
        return detail::made<Spline>(nurbs_move_seam, get(), axis, param);
    }

    // Degree, form and transformations

    /// The same shape with the degree of an axis raised by `times`.
    [[nodiscard]] Returned<Spline> elevate(std::int32_t axis, std::int32_t times = 1) const {
        return detail::made<Spline>(nurbs_elevate, get(), axis, times);
    }
    /// The axis turned round; flags: 0 or keep_domain.
    [[nodiscard]] Returned<Spline> reverse(std::int32_t axis, std::uint32_t flags = 0) const {
        return detail::made<Spline>(nurbs_reverse, get(), axis, flags);
    }
    /// Axis k of the result is axis `permutation[k]`.
    [[nodiscard]] Returned<Spline> transpose(View<std::int32_t> permutation) const {
        detail::require(permutation, detail::axes(get()), "permutation");
        return detail::made<Spline>(nurbs_transpose, get(), permutation.data());
    }
    /// The same shape over another domain.
    [[nodiscard]] Returned<Spline> reparametrize(std::int32_t axis, double lower, double upper) const {
        return detail::made<Spline>(nurbs_reparametrize, get(), axis, lower, upper);
    }
    /// The same spline with weights.
    [[nodiscard]] Returned<Spline> make_rational() const {
        return detail::made<Spline>(nurbs_make_rational, get());
    }
    /// The polynomial spline of the points (w x, w y, ..., w).
    [[nodiscard]] Returned<Spline> to_homogeneous() const {
        return detail::made<Spline>(nurbs_to_homogeneous, get());
    }
    /// The rational spline whose homogeneous points these are.
    [[nodiscard]] Returned<Spline> from_homogeneous() const {
        return detail::made<Spline>(nurbs_from_homogeneous, get());
    }
    /// The shape under x -> A x + b; matrix: [out_dim][dim], row by row; translation: [out_dim], or empty for 0.
    [[nodiscard]] Returned<Spline> transform(std::int32_t out_dim, View<double> matrix,
                                             View<double> translation = {}) const {
        detail::require_matrix(matrix, out_dim, detail::dimension(get()));
        detail::require_given(translation, out_dim, "translation");
        return detail::made<Spline>(nurbs_transform, get(), out_dim, matrix.data(),
                                    detail::pointer(translation));
    }
    /// The shape under a map of homogeneous points; matrix: [out_dim + 1][dim + 1], row by row.
    [[nodiscard]] Returned<Spline> transform_projective(std::int32_t out_dim, View<double> matrix) const {
        detail::require_matrix(matrix, std::int64_t{out_dim} + 1, detail::dimension(get()) + 1);
        return detail::made<Spline>(nurbs_transform_projective, get(), out_dim, matrix.data());
    }
};

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_SPLINE_HPP
