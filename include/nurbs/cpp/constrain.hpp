/* SPDX-License-Identifier: MIT */
/// \file constrain.hpp
/// \brief The smallest change that makes a shape meet constraints.
#ifndef NURBS_CPP_CONSTRAIN_HPP
#define NURBS_CPP_CONSTRAIN_HPP

#include <nurbs/cpp/placement.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Kinds of constraints.
inline constexpr std::int32_t constrain_value = NURBS_CONSTRAIN_VALUE;
inline constexpr std::int32_t constrain_direction = NURBS_CONSTRAIN_DIRECTION;
inline constexpr std::int32_t constrain_normal = NURBS_CONSTRAIN_NORMAL;
inline constexpr std::int32_t constrain_curvature = NURBS_CONSTRAIN_CURVATURE;

/// Constraints at params [n][axes] with targets [n][dim], packed. Kinds [n] left empty are values, orders
/// [n][axes] left empty are 0, and 1 for directions of a curve.
struct Constraints {
    std::vector<double> params;
    std::vector<double> targets;
    std::vector<std::int32_t> kinds{};
    std::vector<std::int32_t> orders{};
};

/// What else holds; what is empty is the default of nurbs.h: derivatives that stay [axes][2], costs [N] of
/// moving control points and of changing weights; and the largest residual.
struct ConstrainOptions {
    std::vector<std::int32_t> keep{};
    std::vector<double> costs{};
    std::vector<double> weight_costs{};
    double tolerance = 0;
};

/// The spline, how far each constraint is missed, the number of independent equations, the largest distance
/// by which a control point moved, and the gradient of the Lagrangian.
struct Constrained {
    Spline spline;
    std::vector<double> residuals;
    std::int64_t rank;
    double moved;
    double optimality;
};

inline Returned<Constrained> constrain(const Spline &g, const Constraints &given,
                                       const ConstrainOptions &options = {}) {
    const std::int64_t axes = detail::axes(g.get()), points = detail::point_count(g.get());
    const std::int64_t count = detail::records(given.params, axes, "params");
    const double *targets =
        detail::exactly(std::span(given.targets), count * detail::dimension(g.get()), "targets");
    const std::int32_t *kinds = detail::if_given(std::span(given.kinds), count, "kinds");
    const std::int32_t *orders = detail::if_given(std::span(given.orders), count * axes, "orders");
    const std::int32_t *keep = detail::if_given(std::span(options.keep), 2 * axes, "keep");
    const double *costs = detail::if_given(std::span(options.costs), points, "costs");
    const double *weight_costs = detail::if_given(std::span(options.weight_costs), points, "weight_costs");
    Constrained made{{}, std::vector<double>(detail::to_size(count)), 0, 0, 0};
    made.spline = detail::spline_of(nurbs_constrain, g.get(), count, kinds, orders, given.params.data(),
                                    targets, keep, costs, weight_costs, options.tolerance,
                                    made.residuals.data(), &made.rank, &made.moved, &made.optimality);
    return made;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_CONSTRAIN_HPP
