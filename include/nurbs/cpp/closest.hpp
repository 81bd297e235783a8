/* SPDX-License-Identifier: MIT */
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
inline constexpr std::int32_t closest_left = NURBS_CLOSEST_LEFT;

/// Kinds of critical points.
inline constexpr std::int32_t critical_minimum = NURBS_CRITICAL_MINIMUM;
inline constexpr std::int32_t critical_maximum = NURBS_CRITICAL_MAXIMUM;
inline constexpr std::int32_t critical_saddle = NURBS_CRITICAL_SADDLE;
inline constexpr std::int32_t critical_undecided = NURBS_CRITICAL_UNDECIDED;

/// How a search is done: the part [axes][2] of the domain, or empty for all of it; how much better another
/// point may be; most pieces looked at, 0 for the default; 0 or nan_points.
struct Search {
    std::vector<double> range{};
    double tolerance = 0;
    std::int64_t budget = 0;
    std::uint32_t flags = 0;
};

/// Points of a spline: parameters [n][axes], points [n][dim], distances, and sums of closest_ bits.
struct ClosestPoints {
    std::vector<double> params;
    std::vector<double> points;
    std::vector<double> distances;
    std::vector<std::int32_t> status;
};

/// Where they are written. An output without elements is not wanted.
struct ClosestOutputs {
    Output params{};
    Output points{};
    Output distances{};
    std::span<std::int32_t> status{};
};

namespace detail {

// Outputs for n queries, the pointers of which are checked.
struct ClosestPointers {
    double *params, *points, *distances;
    std::int32_t *status;
    ClosestPointers(const Spline &g, std::int64_t n, const ClosestOutputs &out)
        : params(wanted(out.params, n, detail::axes(g.get()), "params")),
          points(wanted(out.points, n, detail::dimension(g.get()), "points")),
          distances(wanted(out.distances, n, 1, "distances")), status(if_given(out.status, n, "status")) {}
};

// nurbs_closest_points or nurbs_farthest_points
inline Done search(decltype(&nurbs_closest_points) function, const Spline &g, Input points,
                   const ClosestOutputs &out, const Search &how) {
    const std::int64_t n = records(points, detail::dimension(g.get()), "points");
    const ClosestPointers to(g, n, out);
    return call(function, g.get(), n, points.data(), points.stride(), points.component_stride(),
                range_of(g, how.range), how.tolerance, how.budget, to.params, out.params.stride(),
                out.params.component_stride(), to.points, out.points.stride(), out.points.component_stride(),
                to.distances, out.distances.step(), to.status, how.flags);
}

// The results of f(outputs) for all points.
template <class F>
ClosestPoints closest_of(const Spline &g, Input points, F &&f) {
    const std::int64_t n = records(points, detail::dimension(g.get()), "points");
    ClosestPoints found{std::vector<double>(to_size(n * detail::axes(g.get()))),
                        std::vector<double>(to_size(n * detail::dimension(g.get()))),
                        std::vector<double>(to_size(n)), std::vector<std::int32_t>(to_size(n))};
    run(f, ClosestOutputs{found.params, found.points, found.distances, found.status});
    return found;
}

} // namespace detail

/// The nearest points of a spline; in a volume this is inversion.
inline Returned<void> closest_points(const Spline &g, Input points, const ClosestOutputs &out,
                                     const Search &how = {}) {
    return detail::search(nurbs_closest_points, g, points, out, how);
}
[[nodiscard]] inline Returned<ClosestPoints> closest_points(const Spline &g, Input points,
                                                            const Search &how = {}) {
    return detail::closest_of(g, points,
                              [&](const ClosestOutputs &out) { return closest_points(g, points, out, how); });
}

/// The farthest points of a spline.
inline Returned<void> farthest_points(const Spline &g, Input points, const ClosestOutputs &out,
                                      const Search &how = {}) {
    return detail::search(nurbs_farthest_points, g, points, out, how);
}
[[nodiscard]] inline Returned<ClosestPoints> farthest_points(const Spline &g, Input points,
                                                             const Search &how = {}) {
    return detail::closest_of(
        g, points, [&](const ClosestOutputs &out) { return farthest_points(g, points, out, how); });
}

/// Local minima of the distance, each the one that a descent from a guess [axes] comes to.
inline Returned<void> closest_local(const Spline &g, Input points, Input guesses, const ClosestOutputs &out,
                                    std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(points, detail::dimension(g.get()), "points");
    guesses.require(n, detail::axes(g.get()), "guesses");
    const detail::ClosestPointers to(g, n, out);
    return detail::call(nurbs_closest_local, g.get(), n, points.data(), points.stride(),
                        points.component_stride(), guesses.data(), guesses.stride(),
                        guesses.component_stride(), to.params, out.params.stride(),
                        out.params.component_stride(), to.points, out.points.stride(),
                        out.points.component_stride(), to.distances, out.distances.step(), to.status, flags);
}
[[nodiscard]] inline Returned<ClosestPoints> closest_local(const Spline &g, Input points, Input guesses,
                                                           std::uint32_t flags = 0) {
    return detail::closest_of(
        g, points, [&](const ClosestOutputs &out) { return closest_local(g, points, guesses, out, flags); });
}

/// Points as near as the nearest one to the tolerance: parameters [n][axes], and the status of the search.
struct ClosestAll {
    std::vector<double> params;
    std::vector<double> distances;
    std::int32_t status;
};

/// All of them that are local minima.
inline Returned<ClosestAll> closest_all(const Spline &g, View<double> point, const Search &how = {}) {
    const double *x = detail::point_of(g, point, "point"), *range = detail::range_of(g, how.range);
    ClosestAll found{};
    std::int64_t count = 0;
    const auto call = [&](std::int64_t cap) {
        detail::call(nurbs_closest_all, g.get(), x, range, how.tolerance, how.budget, cap,
                     found.params.data(), found.distances.data(), &count, &found.status);
    };
    call(0);
    found.params.resize(detail::to_size(count * detail::axes(g.get())));
    found.distances.resize(detail::to_size(count));
    call(count);
    return found;
}

/// Critical points of the distance: parameters [n][axes], critical_ constants, and the status of the search.
struct CriticalPoints {
    std::vector<double> params;
    std::vector<double> distances;
    std::vector<std::int32_t> kinds;
    std::int32_t status;
};

/// All of them.
inline Returned<CriticalPoints> critical_points(const Spline &g, View<double> point, const Search &how = {}) {
    const double *x = detail::point_of(g, point, "point"), *range = detail::range_of(g, how.range);
    CriticalPoints found{};
    std::int64_t count = 0;
    const auto call = [&](std::int64_t cap) {
        detail::call(nurbs_critical_points, g.get(), x, range, how.tolerance, how.budget, cap,
                     found.params.data(), found.distances.data(), found.kinds.data(), &count, &found.status);
    };
    call(0);
    found.params.resize(detail::to_size(count * detail::axes(g.get())));
    found.distances.resize(detail::to_size(count));
    found.kinds.resize(detail::to_size(count));
    call(count);
    return found;
}

/// Distances, positive to the left of a curve, parameters, and sums of closest_ bits.
struct SignedDistances {
    std::vector<double> distances;
    std::vector<double> params;
    std::vector<std::int32_t> status;
};

/// Where they are written. Parameters and status without elements are not wanted.
struct SignedOutputs {
    Output distances;
    Output params{};
    std::span<std::int32_t> status{};
};

/// Signed distances of points [n][2] from a curve in the plane; the search has no range.
inline Returned<void> signed_distances(const Spline &g, Input points, const SignedOutputs &out,
                                       const Search &how = {}) {
    const std::int64_t n = detail::records(points, detail::dimension(g.get()), "points");
    out.distances.require(n, 1, "distances");
    double *params = detail::wanted(out.params, n, 1, "params");
    return detail::call(nurbs_curve_signed_distances, g.get(), n, points.data(), points.stride(),
                        points.component_stride(), how.tolerance, how.budget, out.distances.data(),
                        out.distances.step(), params, out.params.step(),
                        detail::if_given(out.status, n, "status"), how.flags);
}
[[nodiscard]] inline Returned<SignedDistances> signed_distances(const Spline &g, Input points,
                                                                const Search &how = {}) {
    const auto n = detail::to_size(detail::records(points, detail::dimension(g.get()), "points"));
    SignedDistances found{std::vector<double>(n), std::vector<double>(n), std::vector<std::int32_t>(n)};
    detail::run([&] {
        return signed_distances(g, points, {found.distances, found.params, found.status}, how);
    });
    return found;
}

/// Bounds of a distance, the parameters of a point of each spline, and closest_certified or closest_budget.
struct Distance {
    double at_least;
    double at_most;
    std::vector<double> params_a;
    std::vector<double> params_b;
    std::int32_t status;
};

/// The smallest distance of two splines; the points are at_most apart.
inline Returned<Distance> distance(const Spline &a, const Spline &b, double tolerance = 0,
                                   std::int64_t budget = 0) {
    Distance found{0, 0, std::vector<double>(detail::to_size(detail::axes(a.get()))),
                   std::vector<double>(detail::to_size(detail::axes(b.get()))), 0};
    detail::call(nurbs_distance, a.get(), b.get(), tolerance, budget, &found.at_least, &found.at_most,
                 found.params_a.data(), found.params_b.data(), &found.status);
    return found;
}

/// Bounds of the distances from a to b and from b to a, and the parameters of points that are at_least so
/// far away.
struct HausdorffDistance {
    std::array<double, 2> at_least;
    std::array<double, 2> at_most;
    std::vector<double> params_a;
    std::vector<double> params_b;
    std::int32_t status;
};

/// Of two splines as sets of points.
inline Returned<HausdorffDistance> hausdorff_distance(const Spline &a, const Spline &b, double tolerance,
                                                      std::int64_t budget = 0) {
    HausdorffDistance found{{},
                            {},
                            std::vector<double>(detail::to_size(detail::axes(a.get()))),
                            std::vector<double>(detail::to_size(detail::axes(b.get()))),
                            0};
    detail::call(nurbs_hausdorff_distance, a.get(), b.get(), tolerance, budget, found.at_least.data(),
                 found.at_most.data(), found.params_a.data(), found.params_b.data(), &found.status);
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_CLOSEST_HPP
