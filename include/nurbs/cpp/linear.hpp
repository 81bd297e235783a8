/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file linear.hpp
/// \brief Derivatives with respect to data: collocation matrices, Bezier extraction, gradients.
#ifndef NURBS_CPP_LINEAR_HPP
#define NURBS_CPP_LINEAR_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Compressed sparse rows.
struct SparseMatrix {
    std::vector<double> values;             ///< Row by row.
    std::vector<std::int64_t> columns;      ///< The column of each value.
    std::vector<std::int64_t> row_pointers; ///< Where each row starts, and where the last one ends.
};

/// Matrix of B-spline basis functions or of a derivative of them; without orders, of the functions
/// themselves.
inline Returned<SparseMatrix> collocation(View<std::int32_t> degrees, View<std::int64_t> counts,
                                          View<double> knots, Input params, View<std::int32_t> orders = {},
                                          std::uint32_t flags = 0) {
    const std::int64_t axes = detail::length(degrees);
    detail::require(counts, axes, "counts");
    const std::int64_t n = detail::records(params, axes, "params");
    detail::require_given(orders, axes, "orders");
    SparseMatrix found{};
    std::int64_t entries = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_collocation, detail::axes_of(degrees), degrees.data(), counts.data(), knots.data(),
                     detail::length(knots), detail::pointer(orders), n, params.data(), params.stride(),
                     params.component_stride(), cap, found.values.data(), found.columns.data(),
                     found.row_pointers.data(), &entries, flags);
    };
    ask(0);
    found.values = detail::room(entries);
    found.columns = detail::room<std::int64_t>(entries);
    found.row_pointers = detail::room<std::int64_t>(n + 1);
    ask(entries);
    return found;
}

/// Matrix of the rational basis functions of a spline or of a derivative of them.
inline Returned<SparseMatrix> rational_collocation(const Spline &g, Input params,
                                                   View<std::int32_t> orders = {}, std::uint32_t flags = 0) {
    const std::int64_t axes = detail::axes(g.get());
    const std::int64_t n = detail::records(params, axes, "params");
    detail::require_given(orders, axes, "orders");
    SparseMatrix found{};
    std::int64_t entries = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_rational_collocation, g.get(), detail::pointer(orders), n, params.data(),
                     params.stride(), params.component_stride(), cap, found.values.data(),
                     found.columns.data(), found.row_pointers.data(), &entries, flags);
    };
    ask(0);
    found.values = detail::room(entries);
    found.columns = detail::room<std::int64_t>(entries);
    found.row_pointers = detail::room<std::int64_t>(n + 1);
    ask(entries);
    return found;
}

/// Matrix that Spline::refine() applies along an axis.
inline Returned<SparseMatrix> refinement_matrix(const Spline &g, std::int32_t axis, View<double> knots) {
    const std::int64_t count = detail::length(knots);
    SparseMatrix found{};
    std::int64_t entries = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_refinement_matrix, g.get(), axis, count, knots.data(), cap, found.values.data(),
                     found.columns.data(), found.row_pointers.data(), &entries);
    };
    ask(0);
    found.values = detail::room(entries);
    found.columns = detail::room<std::int64_t>(entries);
    found.row_pointers = detail::room<std::int64_t>(detail::count(g.get(), axis) + count + 1);
    ask(entries);
    return found;
}

/// Operators [spans][degree + 1][degree + 1], the first control point and the domain [spans][2] of each span.
struct Extraction {
    std::vector<double> operators;    ///< [spans][degree + 1][degree + 1]
    std::vector<std::int64_t> firsts; ///< The first control point of each span.
    std::vector<double> domains;      ///< The ends of each span.
};

/// The operators that take Bernstein polynomials to the basis functions of each span.
inline Returned<Extraction> bezier_extraction(const Spline &g, std::int32_t axis) {
    Extraction found{};
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_bezier_extraction, g.get(), axis, cap, found.operators.data(), found.firsts.data(),
                     found.domains.data(), &count);
    };
    ask(0);
    found.operators =
        detail::room(count, detail::degree(g.get(), axis) + 1, detail::degree(g.get(), axis) + 1);
    found.firsts = detail::room<std::int64_t>(count);
    found.domains = detail::room(count, 2);
    ask(count);
    return found;
}

/// Gradients [N][dim], [N] and [n][axes].
struct Gradients {
    std::vector<double> points;  ///< With respect to the control points, [N][dim].
    std::vector<double> weights; ///< With respect to the weights, [N].
    std::vector<double> params;  ///< With respect to the parameters, [n][axes].
};

/// Gradients of a function of points and derivatives, from its cotangents [n][slots][dim]. An output without
/// elements is not wanted.
inline Returned<void> eval_adjoint(const Spline &g, std::int32_t order, Input params, Input cotangents,
                                   Output grad_points, Output grad_weights, Output grad_params,
                                   std::uint32_t flags = 0) {
    const std::int64_t axes = detail::axes(g.get());
    const std::int64_t n = detail::records(params, axes, "params");
    const std::int64_t dim = detail::dimension(g.get());
    cotangents.require(n, detail::slots(g.get(), order) * dim, "cotangents");
    const std::int64_t net_size = detail::point_count(g.get());
    detail::require_wanted(grad_points, net_size, dim, "grad_points");
    detail::require_wanted(grad_weights, net_size, 1, "grad_weights");
    detail::require_wanted(grad_params, n, axes, "grad_params");
    return detail::call(nurbs_eval_adjoint, g.get(), order, n, params.data(), params.stride(),
                        params.component_stride(), cotangents.data(), cotangents.stride(),
                        cotangents.component_stride(), detail::pointer(grad_points), grad_points.stride(),
                        grad_points.component_stride(), detail::pointer(grad_weights), grad_weights.step(),
                        detail::pointer(grad_params), grad_params.stride(), grad_params.component_stride(),
                        flags);
}
/// The same, as vectors.
[[nodiscard]] inline Returned<Gradients> eval_adjoint(const Spline &g, std::int32_t order, Input params,
                                                      Input cotangents, std::uint32_t flags = 0) {
    const std::int64_t axes = detail::axes(g.get());
    const std::int64_t n = detail::records(params, axes, "params");
    const std::int64_t dim = detail::dimension(g.get());
    cotangents.require(n, detail::slots(g.get(), order) * dim, "cotangents");
    const std::int64_t net_size = detail::point_count(g.get());
    Gradients found{detail::room(net_size, dim), detail::room(net_size), detail::room(n, axes)};
    detail::run([&] {
        return eval_adjoint(g, order, params, cotangents, found.points, found.weights, found.params, flags);
    });
    return found;
}

/// Gradients with respect to the knots of an axis of a function of points and derivatives, from its
/// cotangents [n][slots][dim].
inline Returned<std::vector<double>> eval_adjoint_knots(const Spline &g, std::int32_t axis,
                                                        std::int32_t order, Input params, Input cotangents,
                                                        std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(params, detail::axes(g.get()), "params");
    cotangents.require(n, detail::slots(g.get(), order) * detail::dimension(g.get()), "cotangents");
    std::vector<double> values =
        detail::room(detail::count(g.get(), axis) + detail::degree(g.get(), axis) + 1);
    detail::call(nurbs_eval_adjoint_knots, g.get(), axis, order, n, params.data(), params.stride(),
                 params.component_stride(), cotangents.data(), cotangents.stride(),
                 cotangents.component_stride(), values.data(), flags);
    return values;
}

/// Gradients [N][dim], [N] and [n][dim], and closest_ bits [n].
struct FootGradients {
    std::vector<double> points;       ///< With respect to the control points, [N][dim].
    std::vector<double> weights;      ///< With respect to the weights, [N].
    std::vector<double> queries;      ///< With respect to the query points, [n][dim].
    std::vector<std::int32_t> status; ///< closest_ bits, [n].
};

/// Gradients through the closest points of query points, whose parameters are given, from cotangents of
/// parameters, points and distances; empty ones are 0.
inline Returned<FootGradients> closest_adjoint(const Spline &g, View<double> points, View<double> params,
                                               View<double> param_cotangents = {},
                                               View<double> foot_cotangents = {},
                                               View<double> distance_cotangents = {},
                                               std::uint32_t flags = 0) {
    const std::int64_t dim = detail::dimension(g.get());
    const std::int64_t n = detail::records(points, dim, "points");
    const std::int64_t axes = detail::axes(g.get());
    detail::require(params, n * axes, "params");
    detail::require_given(param_cotangents, n * axes, "param_cotangents");
    detail::require_given(foot_cotangents, n * dim, "foot_cotangents");
    detail::require_given(distance_cotangents, n, "distance_cotangents");
    const std::int64_t net_size = detail::point_count(g.get());
    FootGradients found{detail::room(net_size, dim), detail::room(net_size), detail::room(n, dim),
                        detail::room<std::int32_t>(n)};
    detail::call(nurbs_closest_adjoint, g.get(), n, points.data(), params.data(),
                 detail::pointer(param_cotangents), detail::pointer(foot_cotangents),
                 detail::pointer(distance_cotangents), found.points.data(), found.weights.data(),
                 found.queries.data(), found.status.data(), flags);
    return found;
}

/// Gradients [N][dim] and [N] of the length of a curve, and an estimate of their relative error.
struct LengthGradients {
    std::vector<double> points;  ///< With respect to the control points, [N][dim].
    std::vector<double> weights; ///< With respect to the weights, [N].
    double error;                ///< Of the integrals, relative.
};

/// Gradients of the length of a curve over a range [2] of its domain, or all of it.
inline Returned<LengthGradients> length_adjoint(const Spline &g, double relative_tolerance = 0,
                                                double cotangent = 1, View<double> range = {},
                                                std::uint32_t flags = 0) {
    detail::require_given(range, 2 * detail::axes(g.get()), "range");
    const std::int64_t net_size = detail::point_count(g.get());
    LengthGradients found{detail::room(net_size, detail::dimension(g.get())), detail::room(net_size), 0};
    detail::call(nurbs_length_adjoint, g.get(), detail::pointer(range), relative_tolerance, cotangent,
                 found.points.data(), 0, 0, found.weights.data(), 0, &found.error, flags);
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_LINEAR_HPP
