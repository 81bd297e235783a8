/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file knots.hpp
/// \brief Knot generators, span search and basis functions: what needs knots but no spline.
#ifndef NURBS_CPP_KNOTS_HPP
#define NURBS_CPP_KNOTS_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Uniform unclamped knots with the domain [a, b].
inline Returned<std::vector<double>> knots_uniform(std::int32_t degree, std::int64_t count, double a = 0,
                                                   double b = 1) {
    const std::int64_t knot_count = detail::knot_count(degree, count);
    std::vector<double> values = detail::room(knot_count);
    detail::call(nurbs_knots_uniform, degree, count, a, b, knot_count, values.data());
    return values;
}

/// Clamped knots, evenly spaced between a and b.
inline Returned<std::vector<double>> knots_open_uniform(std::int32_t degree, std::int64_t count, double a = 0,
                                                        double b = 1) {
    const std::int64_t knot_count = detail::knot_count(degree, count);
    std::vector<double> values = detail::room(knot_count);
    detail::call(nurbs_knots_open_uniform, degree, count, a, b, knot_count, values.data());
    return values;
}

/// Piecewise Bezier knots with the breaks 0, 1/pieces, ..., 1.
inline Returned<std::vector<double>> knots_bezier(std::int32_t degree, std::int64_t pieces) {
    const std::int64_t knot_count = detail::knot_count(degree, detail::bezier_count(degree, pieces));
    std::vector<double> values = detail::room(knot_count);
    detail::call(nurbs_knots_bezier, degree, pieces, nullptr, knot_count, values.data());
    return values;
}

/// Piecewise Bezier knots with given breaks.
inline Returned<std::vector<double>> knots_bezier(std::int32_t degree, View<double> breaks) {
    const std::int64_t pieces = detail::length(breaks) - 1;
    const std::int64_t knot_count = detail::knot_count(degree, detail::bezier_count(degree, pieces));
    std::vector<double> values = detail::room(knot_count);
    detail::call(nurbs_knots_bezier, degree, pieces, breaks.data(), knot_count, values.data());
    return values;
}

/// Clamped knots averaged from parameters, for interpolation.
inline Returned<std::vector<double>> knots_averaged(std::int32_t degree, View<double> params) {
    const std::int64_t count = detail::length(params);
    const std::int64_t knot_count = detail::knot_count(degree, count);
    std::vector<double> values = detail::room(knot_count);
    detail::call(nurbs_knots_averaged, degree, count, params.data(), knot_count, values.data());
    return values;
}

/// Periodic knots from the breaks of one period; without multiplicities each break is simple.
inline Returned<std::vector<double>> knots_periodic(std::int32_t degree, View<double> breaks,
                                                    View<std::int32_t> multiplicities = {}) {
    const std::int64_t n = detail::length(breaks);
    detail::require_given(multiplicities, n, "multiplicities");
    const std::int64_t knot_count =
        detail::knot_count(degree, detail::periodic_count(degree, breaks, multiplicities));
    std::vector<double> values = detail::room(knot_count);
    detail::call(nurbs_knots_periodic, degree, n, breaks.data(), detail::pointer(multiplicities), knot_count,
                 values.data());
    return values;
}

/// The span of each parameter in a full knot vector.
inline Returned<std::vector<std::int64_t>> find_spans(std::int32_t degree, View<double> knots, Input params,
                                                      std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(params, 1, "params");
    std::vector<std::int64_t> values = detail::room<std::int64_t>(n);
    detail::call(nurbs_find_spans, degree, detail::length(knots) - std::int64_t{degree} - 1, knots.data(),
                 detail::length(knots), n, params.data(), params.step(), values.data(), flags);
    return values;
}

/// [n][order + 1][degree + 1] Bernstein polynomials and derivatives.
inline Returned<void> bernstein(std::int32_t degree, std::int32_t order, Input params, Output values) {
    const std::int64_t n = detail::records(params, 1, "params");
    values.require(n, detail::basis_width(degree, order), "values");
    return detail::call(nurbs_bernstein, degree, order, n, params.data(), params.step(), values.data(),
                        values.stride(), values.component_stride());
}
/// The same, as a vector.
[[nodiscard]] inline Returned<std::vector<double>> bernstein(std::int32_t degree, std::int32_t order,
                                                             Input params) {
    const std::int64_t n = detail::records(params, 1, "params");
    std::vector<double> values = detail::room(n, detail::basis_width(degree, order));
    detail::run([&] { return bernstein(degree, order, params, values); });
    return values;
}

/// [n][order + 1][degree + 1] B-spline basis functions and derivatives, and the span of each parameter.
inline Returned<Basis> basis(std::int32_t degree, View<double> knots, std::int32_t order, Input params,
                             std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(params, 1, "params");
    Basis found{detail::room<std::int64_t>(n), detail::room(n, detail::basis_width(degree, order))};
    detail::call(nurbs_basis, degree, detail::length(knots) - std::int64_t{degree} - 1, knots.data(),
                 detail::length(knots), order, n, params.data(), params.step(), found.spans.data(),
                 found.values.data(), 0, 0, flags);
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_KNOTS_HPP
