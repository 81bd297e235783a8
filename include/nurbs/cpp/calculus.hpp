/* SPDX-License-Identifier: MIT */
/// \file calculus.hpp
/// \brief Derivatives, integrals, sums and products of splines, and changes of their weights.
#ifndef NURBS_CPP_CALCULUS_HPP
#define NURBS_CPP_CALCULUS_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace libnurbs {

/// The polar form of the piece at params [axes] at args [sum of the degrees]: [dim], or [dim + 1] if rational.
inline std::vector<double> blossom(const Spline &g, View<double> params, View<double> args,
                                   std::uint32_t flags = 0) {
    if (detail::length(params) != g.axes()) {
        detail::wrong_size("params", params.size(), std::to_string(g.axes()));
    }
    std::vector<double> values(static_cast<std::size_t>(g.dimension()) + (g.is_rational() ? 1 : 0));
    detail::check(
        nurbs_blossom(g.get(), params.data(), detail::length(args), args.data(), values.data(), flags));
    return values;
}

/// The partial derivative along an axis.
inline Spline derivative(const Spline &g, std::int32_t axis, std::int32_t order = 1) {
    nurbs *out = nullptr;
    detail::check(nurbs_derivative(g.get(), axis, order, &out));
    return Spline(out);
}

/// The integral along an axis from the start of its domain.
inline Spline antiderivative(const Spline &g, std::int32_t axis) {
    nurbs *out = nullptr;
    detail::check(nurbs_antiderivative(g.get(), axis, &out));
    return Spline(out);
}

/// a(t) b(t); flags 0, product_dot or product_cross.
inline Spline product(const Spline &a, const Spline &b, std::uint32_t flags = 0) {
    nurbs *out = nullptr;
    detail::check(nurbs_product(a.get(), b.get(), flags, &out));
    return Spline(out);
}

/// g(f(t)) for a curve f in the parameter space of g
inline Spline compose(const Spline &g, const Spline &f) {
    nurbs *out = nullptr;
    detail::check(nurbs_compose(g.get(), f.get(), &out));
    return Spline(out);
}

/// alpha a(t) + beta b(t)
inline Spline sum(const Spline &a, double alpha, const Spline &b, double beta) {
    nurbs *out = nullptr;
    detail::check(nurbs_sum(a.get(), alpha, b.get(), beta, &out));
    return Spline(out);
}

/// The same shape with the largest weight 1; equal weights are dropped.
inline Spline normalize_weights(const Spline &g) {
    nurbs *out = nullptr;
    detail::check(nurbs_normalize_weights(g.get(), &out));
    return Spline(out);
}

/// The same shape with the ratio of the end weights, last over first, multiplied.
inline Spline reparametrize_moebius(const Spline &g, std::int32_t axis, double ratio) {
    nurbs *out = nullptr;
    detail::check(nurbs_reparametrize_moebius(g.get(), axis, ratio, &out));
    return Spline(out);
}

/// The same shape with equal weights at the ends of an axis.
inline Spline equalize_end_weights(const Spline &g, std::int32_t axis) {
    nurbs *out = nullptr;
    detail::check(nurbs_equalize_end_weights(g.get(), axis, &out));
    return Spline(out);
}

} // namespace libnurbs

#endif // NURBS_CPP_CALCULUS_HPP
