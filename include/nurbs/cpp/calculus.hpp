/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file calculus.hpp
/// \brief Derivatives, integrals, sums and products of splines, and changes of their weights.
#ifndef NURBS_CPP_CALCULUS_HPP
#define NURBS_CPP_CALCULUS_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// The polar form of the piece at params [axes] at args [sum of the degrees]: [dim], or [dim + 1] if
/// rational.
inline Returned<std::vector<double>> blossom(const Spline &g, View<double> params, View<double> args,
                                             std::uint32_t flags = 0) {
    detail::require(params, detail::axes(g.get()), "params");
    std::vector<double> values = detail::room(detail::dimension(g.get()) + detail::is_rational(g.get()));
    detail::call(nurbs_blossom, g.get(), params.data(), detail::length(args), args.data(), values.data(),
                 flags);
    return values;
}

/// The partial derivative along an axis.
inline Returned<Spline> derivative(const Spline &g, std::int32_t axis, std::int32_t order = 1) {
    return detail::made<Spline>(nurbs_derivative, g.get(), axis, order);
}

/// The derivative with respect to a knot of the full vector of an axis, as a spline.
inline Returned<Spline> knot_derivative(const Spline &g, std::int32_t axis, std::int64_t knot) {
    return detail::made<Spline>(nurbs_eval_knot_derivative, g.get(), axis, knot);
}

/// The integral along an axis from the start of its domain.
inline Returned<Spline> antiderivative(const Spline &g, std::int32_t axis) {
    return detail::made<Spline>(nurbs_antiderivative, g.get(), axis);
}

/// a(t) b(t); flags: 0, product_dot or product_cross.
inline Returned<Spline> product(const Spline &a, const Spline &b, std::uint32_t flags = 0) {
    return detail::made<Spline>(nurbs_product, a.get(), b.get(), flags);
}
/// The same; `call` can watch and end it.
inline Returned<Spline> product(const Spline &a, const Spline &b, std::uint32_t flags,
                                const CallOptions &call) {
    const detail::Watch watch(call);
    return detail::made<Spline>(nurbs_product_with, a.get(), b.get(), flags, watch.get());
}

/// g(f(t)) for a curve f in the parameter space of g.
inline Returned<Spline> compose(const Spline &g, const Spline &f) {
    return detail::made<Spline>(nurbs_compose, g.get(), f.get());
}
/// The same; `call` can watch and end it.
inline Returned<Spline> compose(const Spline &g, const Spline &f, const CallOptions &call) {
    const detail::Watch watch(call);
    return detail::made<Spline>(nurbs_compose_with, g.get(), f.get(), watch.get());
}

/// alpha a(t) + beta b(t).
inline Returned<Spline> sum(const Spline &a, double alpha, const Spline &b, double beta) {
    return detail::made<Spline>(nurbs_sum, a.get(), alpha, b.get(), beta);
}

/// The same shape with the largest weight 1; equal weights are dropped.
inline Returned<Spline> normalize_weights(const Spline &g) {
    return detail::made<Spline>(nurbs_normalize_weights, g.get());
}

/// The same shape with the ratio of the end weights, last over first, multiplied.
inline Returned<Spline> reparametrize_moebius(const Spline &g, std::int32_t axis, double ratio) {
    return detail::made<Spline>(nurbs_reparametrize_moebius, g.get(), axis, ratio);
}

/// The same shape with equal weights at the ends of an axis.
inline Returned<Spline> equalize_end_weights(const Spline &g, std::int32_t axis) {
    return detail::made<Spline>(nurbs_equalize_end_weights, g.get(), axis);
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_CALCULUS_HPP
