/* SPDX-License-Identifier: MIT */
/// \file edit.hpp
/// \brief Changes of weights and control points, and knots that make points of the polygon control points.
#ifndef NURBS_CPP_EDIT_HPP
#define NURBS_CPP_EDIT_HPP

#include <nurbs/cpp/placement.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// The spline, and the weight that it got.
struct WeightEdit {
    Spline spline;
    double weight;
};

/// A weight changed so that the point at params [axes] moves by a distance towards the control point.
inline Returned<WeightEdit> pull_weight(const Spline &g, std::int64_t index, View<double> params,
                                        double distance) {
    const double *at = detail::param_of(g, params);
    double weight = 0;
    Spline spline = detail::spline_of(nurbs_pull_weight, g.get(), index, at, distance, &weight);
    return WeightEdit{std::move(spline), weight};
}

/// The spline, and the factor of the weights.
struct WeightsEdit {
    Spline spline;
    double factor;
};

/// Several weights multiplied by one factor, so that the point moves towards their common centre.
inline Returned<WeightsEdit> pull_weights(const Spline &g, View<std::int64_t> indices, View<double> params,
                                          double distance) {
    const double *at = detail::param_of(g, params);
    double factor = 0;
    Spline spline = detail::spline_of(nurbs_pull_weights, g.get(), detail::length(indices), indices.data(),
                                      at, distance, &factor);
    return WeightsEdit{std::move(spline), factor};
}

/// The weights of some control points set.
inline Returned<Spline> set_weights(const Spline &g, View<std::int64_t> indices, View<double> weights) {
    const std::int64_t count = detail::length(indices);
    const double *values = detail::exactly(std::span(weights), count, "weights");
    return detail::spline_of(nurbs_set_weights, g.get(), count, indices.data(), values);
}

/// The points [dim] at a parameter for the weights 0, 1 and the present one.
struct WeightPoints {
    std::vector<double> at_zero;
    std::vector<double> at_one;
    std::vector<double> at_weight;
};

inline Returned<WeightPoints> weight_points(const Spline &g, std::int64_t index, View<double> params) {
    const auto dim = detail::to_size(detail::dimension(g.get()));
    WeightPoints found{std::vector<double>(dim), std::vector<double>(dim), std::vector<double>(dim)};
    detail::call(nurbs_weight_points, g.get(), index, detail::param_of(g, params), found.at_zero.data(),
                 found.at_one.data(), found.at_weight.data());
    return found;
}

/// The weight from a control point and these three points, all of one dimension.
inline Returned<double> weight_cross_ratio(View<double> control_point, View<double> at_zero,
                                           View<double> at_one, View<double> at_weight) {
    const auto dim = static_cast<std::int32_t>(control_point.size());
    detail::require_length(dim, {at_zero, at_one, at_weight});
    return detail::result_of<double>([&](auto *weight) {
        return nurbs_weight_cross_ratio(dim, control_point.data(), at_zero.data(), at_one.data(),
                                        at_weight.data(), weight);
    });
}

/// A weight set so that the point at params [axes] becomes the target [dim].
inline Returned<WeightEdit> weight_through(const Spline &g, std::int64_t index, View<double> params,
                                           View<double> target, double tolerance) {
    const double *at = detail::param_of(g, params), *to = detail::point_of(g, target, "target");
    double weight = 0;
    Spline spline = detail::spline_of(nurbs_weight_through, g.get(), index, at, to, tolerance, &weight);
    return WeightEdit{std::move(spline), weight};
}

/// The spline, and how far a control point moved.
struct PointEdit {
    Spline spline;
    double moved;
};

/// A control point moved so that the point at params [axes] moves by a distance along a direction [dim].
inline Returned<PointEdit> pull_point(const Spline &g, std::int64_t index, View<double> params,
                                      View<double> direction, double distance) {
    const double *at = detail::param_of(g, params), *along = detail::point_of(g, direction, "direction");
    double moved = 0;
    Spline spline = detail::spline_of(nurbs_pull_point, g.get(), index, at, along, distance, &moved);
    return PointEdit{std::move(spline), moved};
}

/// Control points, and their R_i.
struct Influences {
    std::vector<std::int64_t> indices;
    std::vector<double> influences;
};

/// The control point with the largest |R_i| at each of params [n][axes].
inline Returned<Influences> most_influential(const Spline &g, Input params) {
    const std::int64_t n = detail::records(params, detail::axes(g.get()), "params");
    Influences found{std::vector<std::int64_t>(detail::to_size(n)), std::vector<double>(detail::to_size(n))};
    detail::call(nurbs_most_influential, g.get(), n, params.data(), params.stride(),
                 params.component_stride(), found.indices.data(), found.influences.data());
    return found;
}

/// The spline, the leg by the control point where it starts, the place on it, and the knot.
struct LegEdit {
    Spline spline;
    std::int64_t index;
    double ratio;
    double knot;
};

/// The knot inserted that makes a point of a leg a control point.
inline Returned<LegEdit> insert_on_leg(const Spline &g, std::int32_t axis, std::int64_t index, double ratio) {
    double knot = 0;
    Spline spline = detail::spline_of(nurbs_insert_on_leg, g.get(), axis, index, ratio, &knot);
    return LegEdit{std::move(spline), index, ratio, knot};
}

/// The same for the point [dim] on the leg that is nearest to it.
inline Returned<LegEdit> insert_at_point(const Spline &g, std::int32_t axis, View<double> point,
                                         double tolerance) {
    const double *at = detail::point_of(g, point, "point");
    LegEdit made{};
    made.spline = detail::spline_of(nurbs_insert_at_point, g.get(), axis, at, tolerance, &made.index,
                                    &made.ratio, &made.knot);
    return made;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_EDIT_HPP
