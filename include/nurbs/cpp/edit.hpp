/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file edit.hpp
/// \brief Changes of weights and control points, and knots that make points of the polygon control points.
#ifndef NURBS_CPP_EDIT_HPP
#define NURBS_CPP_EDIT_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// The spline, and the weight that it got.
struct WeightEdit {
    Spline spline; ///< With the new weight.
    double weight; ///< The weight that it got.
};

/// A weight changed so that the point at params [axes] moves by a distance towards the control point.
inline Returned<WeightEdit> pull_weight(const Spline &g, std::int64_t index, View<double> params,
                                        double distance) {
    detail::require(params, detail::axes(g.get()), "params");
    WeightEdit made{};
    made.spline =
        detail::made<Spline>(nurbs_pull_weight, g.get(), index, params.data(), distance, &made.weight);
    return made;
}

/// The spline, and the factor of the weights.
struct WeightsEdit {
    Spline spline; ///< With the new weights.
    double factor; ///< Of the weights.
};

/// Several weights multiplied by one factor, so that the point moves towards their common centre.
inline Returned<WeightsEdit> pull_weights(const Spline &g, View<std::int64_t> indices, View<double> params,
                                          double distance) {
    detail::require(params, detail::axes(g.get()), "params");
    WeightsEdit made{};
    made.spline = detail::made<Spline>(nurbs_pull_weights, g.get(), detail::length(indices), indices.data(),
                                       params.data(), distance, &made.factor);
    return made;
}

/// The weights of some control points set.
inline Returned<Spline> set_weights(const Spline &g, View<std::int64_t> indices, View<double> weights) {
    const std::int64_t count = detail::length(indices);
    detail::require(weights, count, "weights");
    return detail::made<Spline>(nurbs_set_weights, g.get(), count, indices.data(), weights.data());
}

/// The points [dim] at a parameter for the weights 0, 1 and the present one.
struct WeightPoints {
    std::vector<double> at_zero;   ///< For the weight 0.
    std::vector<double> at_one;    ///< For the weight 1.
    std::vector<double> at_weight; ///< For the present weight.
};

/// The points at a parameter for the weights 0, 1 and the present one of a control point.
inline Returned<WeightPoints> weight_points(const Spline &g, std::int64_t index, View<double> params) {
    detail::require(params, detail::axes(g.get()), "params");
    const std::int64_t dim = detail::dimension(g.get());
    WeightPoints found{detail::room(dim), detail::room(dim), detail::room(dim)};
    detail::call(nurbs_weight_points, g.get(), index, params.data(), found.at_zero.data(),
                 found.at_one.data(), found.at_weight.data());
    return found;
}

/// The weight from a control point and these three points, all of one dimension.
inline Returned<double> weight_cross_ratio(View<double> control_point, View<double> at_zero,
                                           View<double> at_one, View<double> at_weight) {
    const auto dim = static_cast<std::int32_t>(control_point.size());
    detail::require_length(dim, {at_zero, at_one, at_weight});
    return detail::result_of<double>([&](auto *v) {
        return nurbs_weight_cross_ratio(dim, control_point.data(), at_zero.data(), at_one.data(),
                                        at_weight.data(), v);
    });
}

/// A weight set so that the point at params [axes] becomes the target [dim].
inline Returned<WeightEdit> weight_through(const Spline &g, std::int64_t index, View<double> params,
                                           View<double> target, double tolerance) {
    detail::require(params, detail::axes(g.get()), "params");
    detail::require(target, detail::dimension(g.get()), "target");
    WeightEdit made{};
    made.spline = detail::made<Spline>(nurbs_weight_through, g.get(), index, params.data(), target.data(),
                                       tolerance, &made.weight);
    return made;
}

/// The spline, and how far a control point moved.
struct PointEdit {
    Spline spline; ///< With the moved control points.
    double moved;  ///< How far a control point moved.
};

/// A control point moved so that the point at params [axes] moves by a distance along a direction [dim].
inline Returned<PointEdit> pull_point(const Spline &g, std::int64_t index, View<double> params,
                                      View<double> direction, double distance) {
    detail::require(params, detail::axes(g.get()), "params");
    detail::require(direction, detail::dimension(g.get()), "direction");
    PointEdit made{};
    made.spline = detail::made<Spline>(nurbs_pull_point, g.get(), index, params.data(), direction.data(),
                                       distance, &made.moved);
    return made;
}

/// Control points, and their R_i.
struct Influences {
    std::vector<std::int64_t> indices; ///< Of the control points.
    std::vector<double> influences;    ///< How far the points move with them.
};

/// The control point with the largest |R_i| at each of params [n][axes].
inline Returned<Influences> most_influential(const Spline &g, Input params) {
    const std::int64_t n = detail::records(params, detail::axes(g.get()), "params");
    Influences found{detail::room<std::int64_t>(n), detail::room(n)};
    detail::call(nurbs_most_influential, g.get(), n, params.data(), params.stride(),
                 params.component_stride(), found.indices.data(), found.influences.data());
    return found;
}

/// The spline, the leg by the control point where it starts, the place on it, and the knot.
struct LegEdit {
    Spline spline;      ///< With one knot more.
    std::int64_t index; ///< Of the control point where the leg starts.
    double ratio;       ///< The place on the leg, from 0 to 1.
    double knot;        ///< The knot inserted.
};

/// The knot inserted that makes a point of a leg of the control polygon a control point.
inline Returned<LegEdit> insert_on_leg(const Spline &g, std::int32_t axis, std::int64_t index, double ratio) {
    LegEdit made{{}, index, ratio, 0};
    made.spline = detail::made<Spline>(nurbs_insert_on_leg, g.get(), axis, index, ratio, &made.knot);
    return made;
}

/// The same for the point [dim] on the leg that is nearest to it.
inline Returned<LegEdit> insert_at_point(const Spline &g, std::int32_t axis, View<double> point,
                                         double tolerance) {
    detail::require(point, detail::dimension(g.get()), "point");
    LegEdit made{};
    made.spline = detail::made<Spline>(nurbs_insert_at_point, g.get(), axis, point.data(), tolerance,
                                       &made.index, &made.ratio, &made.knot);
    return made;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_EDIT_HPP
