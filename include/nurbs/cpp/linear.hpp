/* SPDX-License-Identifier: MIT */
/// \file linear.hpp
/// \brief Derivatives with respect to data: collocation matrices, Bezier extraction, gradients.
#ifndef NURBS_CPP_LINEAR_HPP
#define NURBS_CPP_LINEAR_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Compressed sparse rows.
struct SparseMatrix {
    std::vector<double> values;
    std::vector<std::int64_t> columns;
    std::vector<std::int64_t> row_pointers;
};

/// Operators [spans][degree + 1][degree + 1], the first control point and the domain [spans][2] of each
/// span.
struct Extraction {
    std::vector<double> operators;
    std::vector<std::int64_t> firsts;
    std::vector<double> domains;
};

struct Gradients {
    std::vector<double> points;
    std::vector<double> weights;
    std::vector<double> params;
};

namespace detail {

// f(cap, values, columns, row_pointers, entries), asked for the size first.
template <class F>
SparseMatrix sparse(std::int64_t n, F &&f) {
    std::int64_t entries = 0;
    attempt([&] { return f(0, nullptr, nullptr, nullptr, &entries); });
    SparseMatrix m{std::vector<double>(to_size(entries)), std::vector<std::int64_t>(to_size(entries)),
                   std::vector<std::int64_t>(to_size(n + 1))};
    attempt([&] { return f(entries, m.values.data(), m.columns.data(), m.row_pointers.data(), nullptr); });
    return m;
}

inline const std::int32_t *orders_for(View<std::int32_t> orders, std::size_t axes) {
    if (!orders.empty() && orders.size() != axes) {
        wrong_size("orders", orders.size(), std::to_string(axes));
    }
    return orders.empty() ? nullptr : orders.data();
}

} // namespace detail

/// Matrix of B-spline basis functions or of a derivative of them; without orders, of the functions
/// themselves.
inline Returned<SparseMatrix> collocation(View<std::int32_t> degrees, View<std::int64_t> counts,
                                          View<double> knots, Input params, View<std::int32_t> orders = {},
                                          std::uint32_t flags = 0) {
    if (counts.size() != degrees.size()) {
        detail::wrong_size("counts", counts.size(), std::to_string(degrees.size()));
    }
    const std::int32_t axes = degrees.size() > 3 ? max_axes + 1 : static_cast<std::int32_t>(degrees.size());
    const std::int32_t *of = detail::orders_for(orders, degrees.size());
    const std::int64_t n = detail::records(params, axes, "params");
    return detail::sparse(n, [&](std::int64_t cap, double *values, std::int64_t *columns, std::int64_t *rows,
                                 std::int64_t *entries) {
        return nurbs_collocation(axes, degrees.data(), counts.data(), knots.data(), detail::length(knots), of,
                                 n, params.data(), params.stride(), params.component_stride(), cap, values,
                                 columns, rows, entries, flags);
    });
}

/// Matrix of the rational basis functions of a spline or of a derivative of them.
inline Returned<SparseMatrix> rational_collocation(const Spline &g, Input params,
                                                   View<std::int32_t> orders = {}, std::uint32_t flags = 0) {
    const std::int32_t axes = detail::axes(g.get());
    const std::int32_t *of = detail::orders_for(orders, detail::to_size(axes));
    const std::int64_t n = detail::records(params, axes, "params");
    return detail::sparse(n, [&](std::int64_t cap, double *values, std::int64_t *columns, std::int64_t *rows,
                                 std::int64_t *entries) {
        return nurbs_rational_collocation(g.get(), of, n, params.data(), params.stride(),
                                          params.component_stride(), cap, values, columns, rows, entries,
                                          flags);
    });
}

/// Matrix that Spline::refine() applies along an axis.
inline Returned<SparseMatrix> refinement_matrix(const Spline &g, std::int32_t axis, View<double> knots) {
    const std::int64_t count = detail::length(knots);
    return detail::sparse(detail::count(g.get(), axis) + count,
                          [&](std::int64_t cap, double *values, std::int64_t *columns, std::int64_t *rows,
                              std::int64_t *entries) {
                              return nurbs_refinement_matrix(g.get(), axis, count, knots.data(), cap, values,
                                                             columns, rows, entries);
                          });
}

inline Returned<Extraction> bezier_extraction(const Spline &g, std::int32_t axis) {
    auto spans = detail::result_of<std::int64_t>(
        [&](auto *v) { return nurbs_bezier_extraction(g.get(), axis, 0, nullptr, nullptr, nullptr, v); });
    const std::int64_t width = detail::degree(g.get(), axis) + 1;
    Extraction result{std::vector<double>(detail::to_size(spans * width * width)),
                      std::vector<std::int64_t>(detail::to_size(spans)),
                      std::vector<double>(detail::to_size(2 * spans))};
    detail::call(nurbs_bezier_extraction, g.get(), axis, spans, result.operators.data(), result.firsts.data(),
                 result.domains.data(), &spans);
    return result;
}

/// Gradients of a function of points and derivatives, from its cotangents [n][slots][dim]. An output without
/// elements is not wanted.
inline Returned<void> eval_adjoint(const Spline &g, std::int32_t order, Input params, Input cotangents,
                                   Output grad_points, Output grad_weights, Output grad_params,
                                   std::uint32_t flags = 0) {
    const std::int32_t axes = detail::axes(g.get());
    const std::int64_t n = detail::records(params, axes, "params");
    cotangents.require(n, detail::derivative_slots(axes, order) * detail::dimension(g.get()), "cotangents");
    double *points =
        detail::wanted(grad_points, detail::point_count(g.get()), detail::dimension(g.get()), "grad_points");
    double *weights = detail::wanted(grad_weights, detail::point_count(g.get()), 1, "grad_weights");
    double *to_params = detail::wanted(grad_params, n, axes, "grad_params");
    return detail::call(nurbs_eval_adjoint, g.get(), order, n, params.data(), params.stride(),
                        params.component_stride(), cotangents.data(), cotangents.stride(),
                        cotangents.component_stride(), points, grad_points.stride(),
                        grad_points.component_stride(), weights, grad_weights.step(), to_params,
                        grad_params.stride(), grad_params.component_stride(), flags);
}
inline Returned<Gradients> eval_adjoint(const Spline &g, std::int32_t order, Input params, Input cotangents,
                                        std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(params, detail::axes(g.get()), "params");
    Gradients result{
        std::vector<double>(detail::to_size(detail::point_count(g.get()) * detail::dimension(g.get()))),
        std::vector<double>(detail::to_size(detail::point_count(g.get()))),
        std::vector<double>(detail::to_size(n * detail::axes(g.get())))};
    detail::run([&] {
        return eval_adjoint(g, order, params, cotangents, result.points, result.weights, result.params,
                            flags);
    });
    return result;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_LINEAR_HPP
