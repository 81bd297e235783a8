/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file closest.hpp
/// \brief Distances and closest points.
#ifndef NURBS_CPP_CLOSEST_HPP
#define NURBS_CPP_CLOSEST_HPP

#include <nurbs/cpp/spline.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Bits of the status of a closest point.
inline constexpr std::int32_t closest_certified = NURBS_CLOSEST_CERTIFIED;
inline constexpr std::int32_t closest_boundary = NURBS_CLOSEST_BOUNDARY;
inline constexpr std::int32_t closest_not_unique = NURBS_CLOSEST_NOT_UNIQUE;
inline constexpr std::int32_t closest_budget = NURBS_CLOSEST_BUDGET;
inline constexpr std::int32_t closest_invalid = NURBS_CLOSEST_INVALID;
inline constexpr std::int32_t closest_coarse = NURBS_CLOSEST_COARSE;
inline constexpr std::int32_t closest_singular = NURBS_CLOSEST_SINGULAR;
inline constexpr std::int32_t closest_left = NURBS_CLOSEST_LEFT;

/// Kinds of critical points.
inline constexpr std::int32_t critical_minimum = NURBS_CRITICAL_MINIMUM;
inline constexpr std::int32_t critical_maximum = NURBS_CRITICAL_MAXIMUM;
inline constexpr std::int32_t critical_saddle = NURBS_CRITICAL_SADDLE;
inline constexpr std::int32_t critical_undecided = NURBS_CRITICAL_UNDECIDED;

/// How a search is done.
struct Search {
    std::vector<double> range{}; ///< The part [axes][2] of the domain that is searched; empty: all of it.
    double tolerance = 0;        ///< How much nearer or farther another point may be.
    std::int64_t budget = 0;     ///< Most pieces looked at, 0 for the default.
    std::uint32_t flags = 0;     ///< nan_points or 0.
};

/// Points of a spline: parameters [n][axes], points [n][dim], distances, and sums of closest_ bits.
struct ClosestPoints {
    std::vector<double> params;       ///< [n][axes]
    std::vector<double> points;       ///< [n][dim]
    std::vector<double> distances;    ///< [n]
    std::vector<std::int32_t> status; ///< Sums of closest_ bits, [n].
};

/// Where they are written. An output without elements is not wanted.
struct ClosestOutputs {
    Output params{};
    Output points{};
    Output distances{};
    std::span<std::int32_t> status{};
};

/// The nearest points of a spline; in a volume this is inversion.
inline Returned<void> closest_points(const Spline &g, Input points, const ClosestOutputs &out,
                                     const Search &how = {}) {
    const std::int64_t dim = detail::dimension(g.get());
    const std::int64_t n = detail::records(points, dim, "points");
    const std::int64_t axes = detail::axes(g.get());
    detail::require_given(how.range, 2 * axes, "range");
    detail::require_wanted(out.params, n, axes, "params");
    detail::require_wanted(out.points, n, dim, "points");
    detail::require_wanted(out.distances, n, 1, "distances");
    detail::require_given(out.status, n, "status");
    return detail::call(nurbs_closest_points, g.get(), n, points.data(), points.stride(),
                        points.component_stride(), detail::pointer(how.range), how.tolerance, how.budget,
                        detail::pointer(out.params), out.params.stride(), out.params.component_stride(),
                        detail::pointer(out.points), out.points.stride(), out.points.component_stride(),
                        detail::pointer(out.distances), out.distances.step(), detail::pointer(out.status),
                        how.flags);
}
/// The same, as vectors.
[[nodiscard]] inline Returned<ClosestPoints> closest_points(const Spline &g, Input points,
                                                            const Search &how = {}) {
    const std::int64_t dim = detail::dimension(g.get());
    const std::int64_t n = detail::records(points, dim, "points");
    const std::int64_t axes = detail::axes(g.get());
    detail::require_given(how.range, 2 * axes, "range");
    ClosestPoints found{detail::room(n, axes), detail::room(n, dim), detail::room(n),
                        detail::room<std::int32_t>(n)};
    detail::run([&] {
        return closest_points(g, points, {found.params, found.points, found.distances, found.status}, how);
    });
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<void> closest_points(const Spline &g, Input points, const ClosestOutputs &out,
                                     const Search &how, const CallOptions &call) {
    const std::int64_t dim = detail::dimension(g.get());
    const std::int64_t n = detail::records(points, dim, "points");
    const std::int64_t axes = detail::axes(g.get());
    detail::require_given(how.range, 2 * axes, "range");
    const detail::Watch watch(call);
    detail::require_wanted(out.params, n, axes, "params");
    detail::require_wanted(out.points, n, dim, "points");
    detail::require_wanted(out.distances, n, 1, "distances");
    detail::require_given(out.status, n, "status");
    return detail::call(detail::nurbs_closest_points_with, g.get(), n, points.data(), points.stride(),
                        points.component_stride(), detail::pointer(how.range), how.tolerance, how.budget,
                        detail::pointer(out.params), out.params.stride(), out.params.component_stride(),
                        detail::pointer(out.points), out.points.stride(), out.points.component_stride(),
                        detail::pointer(out.distances), out.distances.step(), detail::pointer(out.status),
                        how.flags, watch.get());
}
/// The same; `call` can watch and end it.
[[nodiscard]] inline Returned<ClosestPoints> closest_points(const Spline &g, Input points, const Search &how,
                                                            const CallOptions &call) {
    const std::int64_t dim = detail::dimension(g.get());
    const std::int64_t n = detail::records(points, dim, "points");
    const std::int64_t axes = detail::axes(g.get());
    detail::require_given(how.range, 2 * axes, "range");
    ClosestPoints found{detail::room(n, axes), detail::room(n, dim), detail::room(n),
                        detail::room<std::int32_t>(n)};
    detail::run([&] {
        return closest_points(g, points, {found.params, found.points, found.distances, found.status}, how,
                              call);
    });
    return found;
}

/// The farthest points of a spline.
inline Returned<void> farthest_points(const Spline &g, Input points, const ClosestOutputs &out,
                                      const Search &how = {}) {
    const std::int64_t dim = detail::dimension(g.get());
    const std::int64_t n = detail::records(points, dim, "points");
    const std::int64_t axes = detail::axes(g.get());
    detail::require_given(how.range, 2 * axes, "range");
    detail::require_wanted(out.params, n, axes, "params");
    detail::require_wanted(out.points, n, dim, "points");
    detail::require_wanted(out.distances, n, 1, "distances");
    detail::require_given(out.status, n, "status");
    return detail::call(nurbs_farthest_points, g.get(), n, points.data(), points.stride(),
                        points.component_stride(), detail::pointer(how.range), how.tolerance, how.budget,
                        detail::pointer(out.params), out.params.stride(), out.params.component_stride(),
                        detail::pointer(out.points), out.points.stride(), out.points.component_stride(),
                        detail::pointer(out.distances), out.distances.step(), detail::pointer(out.status),
                        how.flags);
}
/// The same, as vectors.
[[nodiscard]] inline Returned<ClosestPoints> farthest_points(const Spline &g, Input points,
                                                             const Search &how = {}) {
    const std::int64_t dim = detail::dimension(g.get());
    const std::int64_t n = detail::records(points, dim, "points");
    const std::int64_t axes = detail::axes(g.get());
    detail::require_given(how.range, 2 * axes, "range");
    ClosestPoints found{detail::room(n, axes), detail::room(n, dim), detail::room(n),
                        detail::room<std::int32_t>(n)};
    detail::run([&] {
        return farthest_points(g, points, {found.params, found.points, found.distances, found.status}, how);
    });
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<void> farthest_points(const Spline &g, Input points, const ClosestOutputs &out,
                                      const Search &how, const CallOptions &call) {
    const std::int64_t dim = detail::dimension(g.get());
    const std::int64_t n = detail::records(points, dim, "points");
    const std::int64_t axes = detail::axes(g.get());
    detail::require_given(how.range, 2 * axes, "range");
    const detail::Watch watch(call);
    detail::require_wanted(out.params, n, axes, "params");
    detail::require_wanted(out.points, n, dim, "points");
    detail::require_wanted(out.distances, n, 1, "distances");
    detail::require_given(out.status, n, "status");
    return detail::call(detail::nurbs_farthest_points_with, g.get(), n, points.data(), points.stride(),
                        points.component_stride(), detail::pointer(how.range), how.tolerance, how.budget,
                        detail::pointer(out.params), out.params.stride(), out.params.component_stride(),
                        detail::pointer(out.points), out.points.stride(), out.points.component_stride(),
                        detail::pointer(out.distances), out.distances.step(), detail::pointer(out.status),
                        how.flags, watch.get());
}
/// The same; `call` can watch and end it.
[[nodiscard]] inline Returned<ClosestPoints> farthest_points(const Spline &g, Input points, const Search &how,
                                                             const CallOptions &call) {
    const std::int64_t dim = detail::dimension(g.get());
    const std::int64_t n = detail::records(points, dim, "points");
    const std::int64_t axes = detail::axes(g.get());
    detail::require_given(how.range, 2 * axes, "range");
    ClosestPoints found{detail::room(n, axes), detail::room(n, dim), detail::room(n),
                        detail::room<std::int32_t>(n)};
    detail::run([&] {
        return farthest_points(g, points, {found.params, found.points, found.distances, found.status}, how,
                               call);
    });
    return found;
}

/// Local minima of the distance, each the one that a descent from a guess [axes] comes to.
inline Returned<void> closest_local(const Spline &g, Input points, Input guesses, const ClosestOutputs &out,
                                    std::uint32_t flags = 0) {
    const std::int64_t dim = detail::dimension(g.get());
    const std::int64_t n = detail::records(points, dim, "points");
    const std::int64_t axes = detail::axes(g.get());
    guesses.require(n, axes, "guesses");
    detail::require_wanted(out.params, n, axes, "params");
    detail::require_wanted(out.points, n, dim, "points");
    detail::require_wanted(out.distances, n, 1, "distances");
    detail::require_given(out.status, n, "status");
    return detail::call(nurbs_closest_local, g.get(), n, points.data(), points.stride(),
                        points.component_stride(), guesses.data(), guesses.stride(),
                        guesses.component_stride(), detail::pointer(out.params), out.params.stride(),
                        out.params.component_stride(), detail::pointer(out.points), out.points.stride(),
                        out.points.component_stride(), detail::pointer(out.distances), out.distances.step(),
                        detail::pointer(out.status), flags);
}
/// The same, as vectors.
[[nodiscard]] inline Returned<ClosestPoints> closest_local(const Spline &g, Input points, Input guesses,
                                                           std::uint32_t flags = 0) {
    const std::int64_t dim = detail::dimension(g.get());
    const std::int64_t n = detail::records(points, dim, "points");
    const std::int64_t axes = detail::axes(g.get());
    guesses.require(n, axes, "guesses");
    ClosestPoints found{detail::room(n, axes), detail::room(n, dim), detail::room(n),
                        detail::room<std::int32_t>(n)};
    detail::run([&] {
        return closest_local(g, points, guesses, {found.params, found.points, found.distances, found.status},
                             flags);
    });
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<void> closest_local(const Spline &g, Input points, Input guesses, const ClosestOutputs &out,
                                    std::uint32_t flags, const CallOptions &call) {
    const std::int64_t dim = detail::dimension(g.get());
    const std::int64_t n = detail::records(points, dim, "points");
    const std::int64_t axes = detail::axes(g.get());
    guesses.require(n, axes, "guesses");
    const detail::Watch watch(call);
    detail::require_wanted(out.params, n, axes, "params");
    detail::require_wanted(out.points, n, dim, "points");
    detail::require_wanted(out.distances, n, 1, "distances");
    detail::require_given(out.status, n, "status");
    return detail::call(detail::nurbs_closest_local_with, g.get(), n, points.data(), points.stride(),
                        points.component_stride(), guesses.data(), guesses.stride(),
                        guesses.component_stride(), detail::pointer(out.params), out.params.stride(),
                        out.params.component_stride(), detail::pointer(out.points), out.points.stride(),
                        out.points.component_stride(), detail::pointer(out.distances), out.distances.step(),
                        detail::pointer(out.status), flags, watch.get());
}
/// The same; `call` can watch and end it.
[[nodiscard]] inline Returned<ClosestPoints> closest_local(const Spline &g, Input points, Input guesses,
                                                           std::uint32_t flags, const CallOptions &call) {
    const std::int64_t dim = detail::dimension(g.get());
    const std::int64_t n = detail::records(points, dim, "points");
    const std::int64_t axes = detail::axes(g.get());
    guesses.require(n, axes, "guesses");
    ClosestPoints found{detail::room(n, axes), detail::room(n, dim), detail::room(n),
                        detail::room<std::int32_t>(n)};
    detail::run([&] {
        return closest_local(g, points, guesses, {found.params, found.points, found.distances, found.status},
                             flags, call);
    });
    return found;
}

/// Points as near as the nearest one to the tolerance: parameters [n][axes], and the status of the search.
struct ClosestAll {
    std::vector<double> params;    ///< [n][axes]
    std::vector<double> distances; ///< [n]
    std::int32_t status;           ///< Of the search: a sum of closest_ bits.
};

/// All points that are local minima of the distance and as near as the nearest one to the tolerance.
inline Returned<ClosestAll> closest_all(const Spline &g, View<double> point, const Search &how = {}) {
    detail::require(point, detail::dimension(g.get()), "point");
    const std::int64_t axes = detail::axes(g.get());
    detail::require_given(how.range, 2 * axes, "range");
    ClosestAll found{};
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_closest_all, g.get(), point.data(), detail::pointer(how.range), how.tolerance,
                     how.budget, cap, found.params.data(), found.distances.data(), &count, &found.status);
    };
    ask(0);
    found.params = detail::room(count, axes);
    found.distances = detail::room(count);
    ask(count);
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<ClosestAll> closest_all(const Spline &g, View<double> point, const Search &how,
                                        const CallOptions &call) {
    detail::require(point, detail::dimension(g.get()), "point");
    const std::int64_t axes = detail::axes(g.get());
    detail::require_given(how.range, 2 * axes, "range");
    ClosestAll found{};
    const detail::Watch watch(call);
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_closest_all_with, g.get(), point.data(), detail::pointer(how.range), how.tolerance,
                     how.budget, cap, found.params.data(), found.distances.data(), &count, &found.status,
                     watch.get());
    };
    ask(0);
    found.params = detail::room(count, axes);
    found.distances = detail::room(count);
    ask(count);
    return found;
}

/// Critical points of the distance: parameters [n][axes], critical_ constants, and the status of the search.
struct CriticalPoints {
    std::vector<double> params;      ///< [n][axes]
    std::vector<double> distances;   ///< [n]
    std::vector<std::int32_t> kinds; ///< critical_ constants, [n].
    std::int32_t status;             ///< Of the search: a sum of closest_ bits.
};

/// All critical points of the distance from a point.
inline Returned<CriticalPoints> critical_points(const Spline &g, View<double> point, const Search &how = {}) {
    detail::require(point, detail::dimension(g.get()), "point");
    const std::int64_t axes = detail::axes(g.get());
    detail::require_given(how.range, 2 * axes, "range");
    CriticalPoints found{};
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_critical_points, g.get(), point.data(), detail::pointer(how.range), how.tolerance,
                     how.budget, cap, found.params.data(), found.distances.data(), found.kinds.data(), &count,
                     &found.status);
    };
    ask(0);
    found.params = detail::room(count, axes);
    found.distances = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    ask(count);
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<CriticalPoints> critical_points(const Spline &g, View<double> point, const Search &how,
                                                const CallOptions &call) {
    detail::require(point, detail::dimension(g.get()), "point");
    const std::int64_t axes = detail::axes(g.get());
    detail::require_given(how.range, 2 * axes, "range");
    CriticalPoints found{};
    const detail::Watch watch(call);
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_critical_points_with, g.get(), point.data(), detail::pointer(how.range),
                     how.tolerance, how.budget, cap, found.params.data(), found.distances.data(),
                     found.kinds.data(), &count, &found.status, watch.get());
    };
    ask(0);
    found.params = detail::room(count, axes);
    found.distances = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    ask(count);
    return found;
}

/// Distances, positive to the left of a curve, parameters, and sums of closest_ bits.
struct SignedDistances {
    std::vector<double> distances;    ///< Positive to the left of the curve.
    std::vector<double> params;       ///< Of the nearest points.
    std::vector<std::int32_t> status; ///< Sums of closest_ bits.
};

/// Where they are written. An output without elements is not wanted, distances excepted.
struct SignedOutputs {
    Output distances;
    Output params{};
    std::span<std::int32_t> status{};
};

/// Signed distances of points [n][2] from a curve in the plane, positive to its left; the search has no
/// range.
inline Returned<void> signed_distances(const Spline &g, Input points, const SignedOutputs &out,
                                       const Search &how = {}) {
    const std::int64_t n = detail::records(points, detail::dimension(g.get()), "points");
    out.distances.require(n, 1, "distances");
    detail::require_wanted(out.params, n, 1, "params");
    detail::require_given(out.status, n, "status");
    return detail::call(nurbs_curve_signed_distances, g.get(), n, points.data(), points.stride(),
                        points.component_stride(), how.tolerance, how.budget, out.distances.data(),
                        out.distances.step(), detail::pointer(out.params), out.params.step(),
                        detail::pointer(out.status), how.flags);
}
/// The same, as vectors.
[[nodiscard]] inline Returned<SignedDistances> signed_distances(const Spline &g, Input points,
                                                                const Search &how = {}) {
    const std::int64_t n = detail::records(points, detail::dimension(g.get()), "points");
    SignedDistances found{detail::room(n), detail::room(n), detail::room<std::int32_t>(n)};
    detail::run([&] {
        return signed_distances(g, points, {found.distances, found.params, found.status}, how);
    });
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<void> signed_distances(const Spline &g, Input points, const SignedOutputs &out,
                                       const Search &how, const CallOptions &call) {
    const std::int64_t n = detail::records(points, detail::dimension(g.get()), "points");
    const detail::Watch watch(call);
    out.distances.require(n, 1, "distances");
    detail::require_wanted(out.params, n, 1, "params");
    detail::require_given(out.status, n, "status");
    return detail::call(detail::nurbs_curve_signed_distances_with, g.get(), n, points.data(), points.stride(),
                        points.component_stride(), how.tolerance, how.budget, out.distances.data(),
                        out.distances.step(), detail::pointer(out.params), out.params.step(),
                        detail::pointer(out.status), how.flags, watch.get());
}
/// The same; `call` can watch and end it.
[[nodiscard]] inline Returned<SignedDistances> signed_distances(const Spline &g, Input points,
                                                                const Search &how, const CallOptions &call) {
    const std::int64_t n = detail::records(points, detail::dimension(g.get()), "points");
    SignedDistances found{detail::room(n), detail::room(n), detail::room<std::int32_t>(n)};
    detail::run([&] {
        return signed_distances(g, points, {found.distances, found.params, found.status}, how, call);
    });
    return found;
}

/// Bounds of a distance, and the parameters of a point of each spline.
struct Distance {
    double at_least;              ///< A proven lower bound.
    double at_most;               ///< The distance of the points at the parameters.
    std::vector<double> params_a; ///< Of a point of the first spline.
    std::vector<double> params_b; ///< Of a point of the second spline.
    std::int32_t status;          ///< closest_certified or closest_budget.
};

/// The smallest distance of two splines; the points are at_most apart.
inline Returned<Distance> distance(const Spline &a, const Spline &b, double tolerance = 0,
                                   std::int64_t budget = 0) {
    Distance found{0, 0, detail::room(detail::axes(a.get())), detail::room(detail::axes(b.get())), 0};
    detail::call(nurbs_distance, a.get(), b.get(), tolerance, budget, &found.at_least, &found.at_most,
                 found.params_a.data(), found.params_b.data(), &found.status);
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<Distance> distance(const Spline &a, const Spline &b, double tolerance, std::int64_t budget,
                                   const CallOptions &call) {
    Distance found{0, 0, detail::room(detail::axes(a.get())), detail::room(detail::axes(b.get())), 0};
    const detail::Watch watch(call);
    detail::call(nurbs_distance_with, a.get(), b.get(), tolerance, budget, &found.at_least, &found.at_most,
                 found.params_a.data(), found.params_b.data(), &found.status, watch.get());
    return found;
}

/// Bounds of the distances from a to b and from b to a, and the parameters of points that are at_least so far
/// away.
struct HausdorffDistance {
    std::array<double, 2> at_least; ///< Lower bounds of the distances from one to the other and back.
    std::array<double, 2> at_most;  ///< Upper bounds of them.
    std::vector<double> params_a;   ///< Of a point of the first spline.
    std::vector<double> params_b;   ///< Of a point of the second spline.
    std::int32_t status;            ///< closest_certified or closest_budget.
};

/// How far the points that are farthest from the other spline are from it, and the other way round.
inline Returned<HausdorffDistance> hausdorff_distance(const Spline &a, const Spline &b, double tolerance,
                                                      std::int64_t budget = 0) {
    HausdorffDistance found{
        {}, {}, detail::room(detail::axes(a.get())), detail::room(detail::axes(b.get())), 0};
    detail::call(nurbs_hausdorff_distance, a.get(), b.get(), tolerance, budget, found.at_least.data(),
                 found.at_most.data(), found.params_a.data(), found.params_b.data(), &found.status);
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<HausdorffDistance> hausdorff_distance(const Spline &a, const Spline &b, double tolerance,
                                                      std::int64_t budget, const CallOptions &call) {
    HausdorffDistance found{
        {}, {}, detail::room(detail::axes(a.get())), detail::room(detail::axes(b.get())), 0};
    const detail::Watch watch(call);
    detail::call(nurbs_hausdorff_distance_with, a.get(), b.get(), tolerance, budget, found.at_least.data(),
                 found.at_most.data(), found.params_a.data(), found.params_b.data(), &found.status,
                 watch.get());
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_CLOSEST_HPP
