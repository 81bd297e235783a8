/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file constrain.hpp
/// \brief The smallest change that makes a shape meet constraints.
#ifndef NURBS_CPP_CONSTRAIN_HPP
#define NURBS_CPP_CONSTRAIN_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Kinds of constraints.
inline constexpr std::int32_t constrain_value = NURBS_CONSTRAIN_VALUE;
inline constexpr std::int32_t constrain_direction = NURBS_CONSTRAIN_DIRECTION;
inline constexpr std::int32_t constrain_normal = NURBS_CONSTRAIN_NORMAL;
inline constexpr std::int32_t constrain_curvature = NURBS_CONSTRAIN_CURVATURE;

/// Constraints at params [n][axes] with targets [n][dim], packed.
struct Constraints {
    std::vector<double> params;        ///< [n][axes]
    std::vector<double> targets;       ///< [n][dim]
    std::vector<std::int32_t> kinds{}; ///< constrain_ constants [n]; empty: all values.
    /// Of derivatives, [n][axes]; empty: 0, and 1 for directions of a curve.
    std::vector<std::int32_t> orders{};
};

/// What else holds; what is empty is the default of nurbs.h.
struct ConstrainOptions {
    /// [axes][2] highest order of derivatives that stay at the ends, -1 for none; empty: none.
    std::vector<std::int32_t> keep{};
    std::vector<double> costs{};        ///< [N] of moving each control point; empty: all 1.
    std::vector<double> weight_costs{}; ///< [N] of changing each weight; empty: all stay.
    double tolerance = 0;               ///< Largest residual.
};

/// The spline, how far each constraint is missed, the number of independent equations, the largest distance
/// by which a control point moved, and the gradient of the Lagrangian.
struct Constrained {
    Spline spline;                 ///< The changed spline.
    std::vector<double> residuals; ///< How far each constraint is missed.
    std::int64_t rank;             ///< The number of independent equations.
    double moved;                  ///< The largest distance by which a control point moved.
    double optimality;             ///< The size of the gradient of the Lagrangian.
};

/// The smallest change that meets constraints.
inline Returned<Constrained> constrain(const Spline &g, const Constraints &given,
                                       const ConstrainOptions &options = {}) {
    const std::int64_t axes = detail::axes(g.get());
    const std::int64_t count = detail::records(given.params, axes, "params");
    detail::require(given.targets, count * detail::dimension(g.get()), "targets");
    detail::require_given(given.kinds, count, "kinds");
    detail::require_given(given.orders, count * axes, "orders");
    detail::require_given(options.keep, 2 * axes, "keep");
    const std::int64_t net_size = detail::point_count(g.get());
    detail::require_given(options.costs, net_size, "costs");
    detail::require_given(options.weight_costs, net_size, "weight_costs");
    Constrained made{{}, detail::room(count), 0, 0, 0};
    made.spline = detail::made<Spline>(
        nurbs_constrain, g.get(), count, detail::pointer(given.kinds), detail::pointer(given.orders),
        given.params.data(), given.targets.data(), detail::pointer(options.keep),
        detail::pointer(options.costs), detail::pointer(options.weight_costs), options.tolerance,
        made.residuals.data(), &made.rank, &made.moved, &made.optimality);
    return made;
}
/// The same; `call` can watch and end it.
inline Returned<Constrained> constrain(const Spline &g, const Constraints &given,
                                       const ConstrainOptions &options, const CallOptions &call) {
    const std::int64_t axes = detail::axes(g.get());
    const std::int64_t count = detail::records(given.params, axes, "params");
    detail::require(given.targets, count * detail::dimension(g.get()), "targets");
    detail::require_given(given.kinds, count, "kinds");
    detail::require_given(given.orders, count * axes, "orders");
    detail::require_given(options.keep, 2 * axes, "keep");
    const std::int64_t net_size = detail::point_count(g.get());
    detail::require_given(options.costs, net_size, "costs");
    detail::require_given(options.weight_costs, net_size, "weight_costs");
    Constrained made{{}, detail::room(count), 0, 0, 0};
    const detail::Watch watch(call);
    made.spline = detail::made<Spline>(
        detail::nurbs_constrain_with, g.get(), count, detail::pointer(given.kinds),
        detail::pointer(given.orders), given.params.data(), given.targets.data(),
        detail::pointer(options.keep), detail::pointer(options.costs), detail::pointer(options.weight_costs),
        options.tolerance, made.residuals.data(), &made.rank, &made.moved, &made.optimality, watch.get());
    return made;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_CONSTRAIN_HPP
