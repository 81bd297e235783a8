/* SPDX-License-Identifier: MIT */
/// \file knots.hpp
/// \brief Knot generators, span search and basis functions: what needs knots but no spline.
#ifndef NURBS_CPP_KNOTS_HPP
#define NURBS_CPP_KNOTS_HPP

#include <nurbs/cpp/arrays.hpp>
#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <numeric>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

namespace detail {

// Knots of `count` control points, filled by f(knot_count, knots).
template <class F>
std::vector<double> generated_knots(std::int32_t degree, std::int64_t count, F &&f) {
    // A count that no memory holds is left to the library to refuse, before it touches the array.
    const bool sane = degree >= 0 && degree <= max_degree && count >= 0 && count < (std::int64_t{1} << 48);
    const std::int64_t size = sane ? count + degree + 1 : 0;
    return filled(size, [&](auto &knots) { attempt([&] { return f(size, knots.data()); }); });
}

// Values per parameter; 0 where the library will refuse the degree or the order.
inline std::int64_t basis_width(std::int32_t degree, std::int32_t order) {
    const bool sane = degree >= 0 && degree <= max_degree && order >= 0 && order <= max_order;
    return sane ? (std::int64_t{order} + 1) * (degree + 1) : 0;
}

inline std::int64_t control_points(std::int32_t degree, View<double> knots) {
    return length(knots) - degree - 1;
}

} // namespace detail

inline Returned<std::vector<double>> knots_uniform(std::int32_t degree, std::int64_t count, double a = 0,
                                                   double b = 1) {
    return detail::generated_knots(degree, count, [&](std::int64_t size, double *knots) {
        return nurbs_knots_uniform(degree, count, a, b, size, knots);
    });
}

inline Returned<std::vector<double>> knots_open_uniform(std::int32_t degree, std::int64_t count, double a = 0,
                                                        double b = 1) {
    return detail::generated_knots(degree, count, [&](std::int64_t size, double *knots) {
        return nurbs_knots_open_uniform(degree, count, a, b, size, knots);
    });
}

/// Breaks 0, 1/pieces, ..., 1.
inline Returned<std::vector<double>> knots_bezier(std::int32_t degree, std::int64_t pieces) {
    const bool sane = pieces >= 0 && pieces < (std::int64_t{1} << 48);
    const std::int64_t count = sane ? (degree == 0 ? pieces : pieces * degree + 1) : -1;
    return detail::generated_knots(degree, count, [&](std::int64_t size, double *knots) {
        return nurbs_knots_bezier(degree, pieces, nullptr, size, knots);
    });
}

/// The given breaks; one more than pieces.
inline Returned<std::vector<double>> knots_bezier(std::int32_t degree, View<double> breaks) {
    const std::int64_t pieces = detail::length(breaks) - 1;
    const std::int64_t count = degree == 0 ? pieces : pieces * degree + 1;
    return detail::generated_knots(degree, count, [&](std::int64_t size, double *knots) {
        return nurbs_knots_bezier(degree, pieces, breaks.data(), size, knots);
    });
}

inline Returned<std::vector<double>> knots_averaged(std::int32_t degree, View<double> params) {
    const std::int64_t count = detail::length(params);
    return detail::generated_knots(degree, count, [&](std::int64_t size, double *knots) {
        return nurbs_knots_averaged(degree, count, params.data(), size, knots);
    });
}

/// Multiplicities are one for each break, or none, which means all 1.
inline Returned<std::vector<double>> knots_periodic(std::int32_t degree, View<double> breaks,
                                                    View<std::int32_t> multiplicities = {}) {
    const std::int64_t n = detail::length(breaks);
    if (!multiplicities.empty() && multiplicities.size() != breaks.size()) {
        detail::wrong_size("multiplicities", multiplicities.size(), std::to_string(breaks.size()));
    }
    const std::int64_t distinct =
        multiplicities.empty()
            ? n - 1
            : std::accumulate(multiplicities.begin(), multiplicities.end() - 1, std::int64_t{0});
    return detail::generated_knots(degree, distinct + degree, [&](std::int64_t size, double *knots) {
        return nurbs_knots_periodic(degree, n, breaks.data(), multiplicities.data(), size, knots);
    });
}

/// The span of each parameter in a full knot vector.
inline Returned<std::vector<std::int64_t>> find_spans(std::int32_t degree, View<double> knots, Input params,
                                                      std::uint32_t flags = 0) {
    const std::int64_t n = params.count(1, "params");
    params.require(n, 1, "params");
    std::vector<std::int64_t> spans(detail::to_size(n));
    detail::call(nurbs_find_spans, degree, detail::control_points(degree, knots), knots.data(),
                 detail::length(knots), n, params.data(), params.step(), spans.data(), flags);
    return spans;
}

/// [n][order + 1][degree + 1] Bernstein polynomials and derivatives.
inline Returned<void> bernstein(std::int32_t degree, std::int32_t order, Input params, Output values) {
    const std::int64_t n = params.count(1, "params");
    params.require(n, 1, "params");
    values.require(n, detail::basis_width(degree, order), "values");
    return detail::call(nurbs_bernstein, degree, order, n, params.data(), params.step(), values.data(),
                        values.stride(), values.component_stride());
}
inline Returned<std::vector<double>> bernstein(std::int32_t degree, std::int32_t order, Input params) {
    return detail::filled(params.count(1, "params") * detail::basis_width(degree, order),
                          [&](auto &values) { return bernstein(degree, order, params, values); });
}

/// [n][order + 1][degree + 1] B-spline basis functions and derivatives, and the span of each parameter.
inline Returned<Basis> basis(std::int32_t degree, View<double> knots, std::int32_t order, Input params,
                             std::uint32_t flags = 0) {
    const std::int64_t n = params.count(1, "params");
    params.require(n, 1, "params");
    Basis result{std::vector<std::int64_t>(detail::to_size(n)),
                 std::vector<double>(detail::to_size(n * detail::basis_width(degree, order)))};
    detail::call(nurbs_basis, degree, detail::control_points(degree, knots), knots.data(),
                 detail::length(knots), order, n, params.data(), params.step(), result.spans.data(),
                 result.values.data(), 0, 0, flags);
    return result;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_KNOTS_HPP
