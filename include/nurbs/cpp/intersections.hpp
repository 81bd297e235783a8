/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file intersections.hpp
/// \brief Where shapes meet; every answer says whether it is complete.
#ifndef NURBS_CPP_INTERSECTIONS_HPP
#define NURBS_CPP_INTERSECTIONS_HPP

#include <nurbs/cpp/spline.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Bits of the status of a ray.
inline constexpr std::int32_t ray_hit = NURBS_RAY_HIT;
inline constexpr std::int32_t ray_certified = NURBS_RAY_CERTIFIED;
inline constexpr std::int32_t ray_touch = NURBS_RAY_TOUCH;
inline constexpr std::int32_t ray_back = NURBS_RAY_BACK;

/// Kinds of hits.
inline constexpr std::int32_t hit_crossing = NURBS_HIT_CROSSING;
inline constexpr std::int32_t hit_tangent = NURBS_HIT_TANGENT;
inline constexpr std::int32_t hit_contact = NURBS_HIT_CONTACT;
inline constexpr std::int32_t hit_overlap = NURBS_HIT_OVERLAP;
inline constexpr std::int32_t hit_jump = NURBS_HIT_JUMP;
inline constexpr std::int32_t hit_undecided = NURBS_HIT_UNDECIDED;

/// Parameters in rising order, one hit_ constant each, and ranges [n][2] of parameters outside of which there
/// is no solution.
struct Hits {
    std::vector<double> params;      ///< In rising order.
    std::vector<std::int32_t> kinds; ///< One of the hit_ constants each.
    std::vector<double> ranges;      ///< [n] of lower and upper ends, outside of which there is no solution.
    bool complete;                   ///< Whether none of them is undecided.
};

/// Where a scalar curve has a value: its roots, with proof that there are no others.
inline Returned<Hits> roots(const Spline &g, double value = 0, double tolerance = 0) {
    Hits found{};
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_roots, g.get(), value, tolerance, cap, found.params.data(), found.kinds.data(),
                     found.ranges.data(), &count, &complete);
    };
    ask(0);
    found.params = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges = detail::room(count, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<Hits> roots(const Spline &g, double value, double tolerance, const CallOptions &call) {
    Hits found{};
    const detail::Watch watch(call);
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_roots_with, g.get(), value, tolerance, cap, found.params.data(),
                     found.kinds.data(), found.ranges.data(), &count, &complete, watch.get());
    };
    ask(0);
    found.params = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges = detail::room(count, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}

/// Where a curve meets a line, a plane, a conic, a quadric or another set on which a polynomial of a degree
/// is 0; its coefficients are those of products x_i x_j ... with i <= j <= ..., in lexicographic order, where
/// x_dim stands for 1.
inline Returned<Hits> curve_level(const Spline &g, std::int32_t degree, View<double> coefficients,
                                  double tolerance = 0) {
    detail::require(coefficients, detail::monomials(detail::dimension(g.get()), degree), "coefficients");
    Hits found{};
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_curve_level, g.get(), degree, coefficients.data(), tolerance, cap,
                     found.params.data(), found.kinds.data(), found.ranges.data(), &count, &complete);
    };
    ask(0);
    found.params = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges = detail::room(count, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<Hits> curve_level(const Spline &g, std::int32_t degree, View<double> coefficients,
                                  double tolerance, const CallOptions &call) {
    detail::require(coefficients, detail::monomials(detail::dimension(g.get()), degree), "coefficients");
    Hits found{};
    const detail::Watch watch(call);
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_curve_level_with, g.get(), degree, coefficients.data(), tolerance, cap,
                     found.params.data(), found.kinds.data(), found.ranges.data(), &count, &complete,
                     watch.get());
    };
    ask(0);
    found.params = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges = detail::room(count, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}

/// Parameters on both curves, rising on the first one, one hit_ constant each, and ranges [n][2] of
/// parameters of both.
struct PairHits {
    std::vector<double> params_a;    ///< On the first curve, in rising order.
    std::vector<double> params_b;    ///< On the second curve.
    std::vector<std::int32_t> kinds; ///< One of the hit_ constants each.
    std::vector<double> ranges_a;    ///< Of parameters of the first curve, [n] of lower and upper ends.
    /// Of parameters of the second curve, [n] of ends; the first one is larger where an overlap runs against
    /// it.
    std::vector<double> ranges_b;
    bool complete; ///< Whether none of them is undecided.
};

/// Where two curves meet, with proof that there are no other places.
inline Returned<PairHits> curve_intersections(const Spline &a, const Spline &b, double tolerance = 0) {
    PairHits found{};
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_curve_intersections, a.get(), b.get(), tolerance, cap, found.params_a.data(),
                     found.params_b.data(), found.kinds.data(), found.ranges_a.data(), found.ranges_b.data(),
                     &count, &complete);
    };
    ask(0);
    found.params_a = detail::room(count);
    found.params_b = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges_a = detail::room(count, 2);
    found.ranges_b = detail::room(count, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<PairHits> curve_intersections(const Spline &a, const Spline &b, double tolerance,
                                              const CallOptions &call) {
    PairHits found{};
    const detail::Watch watch(call);
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_curve_intersections_with, a.get(), b.get(), tolerance, cap, found.params_a.data(),
                     found.params_b.data(), found.kinds.data(), found.ranges_a.data(), found.ranges_b.data(),
                     &count, &complete, watch.get());
    };
    ask(0);
    found.params_a = detail::room(count);
    found.params_b = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges_a = detail::room(count, 2);
    found.ranges_b = detail::room(count, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}

/// Where a curve meets itself, with proof that there are no other places.
inline Returned<PairHits> self_intersections(const Spline &g, double tolerance = 0) {
    PairHits found{};
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_curve_self_intersections, g.get(), tolerance, cap, found.params_a.data(),
                     found.params_b.data(), found.kinds.data(), found.ranges_a.data(), found.ranges_b.data(),
                     &count, &complete);
    };
    ask(0);
    found.params_a = detail::room(count);
    found.params_b = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges_a = detail::room(count, 2);
    found.ranges_b = detail::room(count, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<PairHits> self_intersections(const Spline &g, double tolerance, const CallOptions &call) {
    PairHits found{};
    const detail::Watch watch(call);
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_curve_self_intersections_with, g.get(), tolerance, cap, found.params_a.data(),
                     found.params_b.data(), found.kinds.data(), found.ranges_a.data(), found.ranges_b.data(),
                     &count, &complete, watch.get());
    };
    ask(0);
    found.params_a = detail::room(count);
    found.params_b = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges_a = detail::room(count, 2);
    found.ranges_b = detail::room(count, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}

/// Parameters on a curve, rising, and on a surface, [n][2], one hit_ constant each, and ranges of parameters
/// of both: [n][2], and [n][2][2] of both axes of the surface.
struct SurfaceHits {
    std::vector<double> params_curve;   ///< On the curve, in rising order.
    std::vector<double> params_surface; ///< [n][2] on the surface.
    std::vector<std::int32_t> kinds;    ///< One of the hit_ constants each.
    std::vector<double> ranges_curve;   ///< Of parameters of the curve, [n] of lower and upper ends.
    /// Of parameters of the surface, [n][2] of lower and upper ends along each axis.
    std::vector<double> ranges_surface;
    bool complete; ///< Whether none of them is undecided.
};

/// Where a curve meets a surface, with proof that there are no other places.
inline Returned<SurfaceHits> surface_intersections(const Spline &curve, const Spline &surface,
                                                   double tolerance = 0) {
    SurfaceHits found{};
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_curve_surface_intersections, curve.get(), surface.get(), tolerance, cap,
                     found.params_curve.data(), found.params_surface.data(), found.kinds.data(),
                     found.ranges_curve.data(), found.ranges_surface.data(), &count, &complete);
    };
    ask(0);
    found.params_curve = detail::room(count);
    found.params_surface = detail::room(count, 2);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges_curve = detail::room(count, 2);
    found.ranges_surface = detail::room(count, 2, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<SurfaceHits> surface_intersections(const Spline &curve, const Spline &surface,
                                                   double tolerance, const CallOptions &call) {
    SurfaceHits found{};
    const detail::Watch watch(call);
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_curve_surface_intersections_with, curve.get(), surface.get(), tolerance, cap,
                     found.params_curve.data(), found.params_surface.data(), found.kinds.data(),
                     found.ranges_curve.data(), found.ranges_surface.data(), &count, &complete, watch.get());
    };
    ask(0);
    found.params_curve = detail::room(count);
    found.params_surface = detail::room(count, 2);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges_curve = detail::room(count, 2);
    found.ranges_surface = detail::room(count, 2, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}

/// Parameters on three surfaces, [n][3][2], rising on the first one, the points, one hit_ constant each, and
/// ranges of parameters, [n][3][2][2].
struct CommonPoints {
    std::vector<double> params;      ///< [n][3][2] on the three surfaces.
    std::vector<double> points;      ///< [n][3].
    std::vector<std::int32_t> kinds; ///< hit_crossing or hit_undecided each.
    /// Of parameters, [n][6] of lower and upper ends, outside of which there are no common points.
    std::vector<double> ranges;
    bool complete; ///< Whether none of them is undecided.
};

/// The points that three surfaces have in common, with proof that there are no others.
inline Returned<CommonPoints> common_points(const Spline &a, const Spline &b, const Spline &c,
                                            double tolerance = 0) {
    CommonPoints found{};
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_surfaces_common_points, a.get(), b.get(), c.get(), tolerance, cap,
                     found.params.data(), found.points.data(), found.kinds.data(), found.ranges.data(),
                     &count, &complete);
    };
    ask(0);
    found.params = detail::room(count, 6);
    found.points = detail::room(count, 3);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges = detail::room(count, 6, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<CommonPoints> common_points(const Spline &a, const Spline &b, const Spline &c,
                                            double tolerance, const CallOptions &call) {
    CommonPoints found{};
    const detail::Watch watch(call);
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_surfaces_common_points_with, a.get(), b.get(), c.get(), tolerance, cap,
                     found.params.data(), found.points.data(), found.kinds.data(), found.ranges.data(),
                     &count, &complete, watch.get());
    };
    ask(0);
    found.params = detail::room(count, 6);
    found.points = detail::room(count, 3);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges = detail::room(count, 6, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}

/// Where rays meet a surface first, at origin + t direction.
struct Rays {
    std::vector<double> params;       ///< [n][2] on the surface, NaN without a hit or touch.
    std::vector<double> distances;    ///< t, in lengths of the direction; NaN without a hit or touch.
    std::vector<std::int32_t> status; ///< ray_ bits.
};

/// Where rays meet a surface first, with proof.
inline Returned<Rays> rays(const Spline &g, Input origins, Input directions) {
    const std::int64_t n = detail::records(origins, 3, "origins");
    directions.require(n, 3, "directions");
    Rays found{detail::room(n, 2), detail::room(n), detail::room<std::int32_t>(n)};
    detail::call(nurbs_surface_rays, g.get(), n, origins.data(), origins.stride(), origins.component_stride(),
                 directions.data(), directions.stride(), directions.component_stride(), found.params.data(),
                 found.distances.data(), found.status.data());
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<Rays> rays(const Spline &g, Input origins, Input directions, const CallOptions &call) {
    const std::int64_t n = detail::records(origins, 3, "origins");
    directions.require(n, 3, "directions");
    Rays found{detail::room(n, 2), detail::room(n), detail::room<std::int32_t>(n)};
    const detail::Watch watch(call);
    detail::call(nurbs_surface_rays_with, g.get(), n, origins.data(), origins.stride(),
                 origins.component_stride(), directions.data(), directions.stride(),
                 directions.component_stride(), found.params.data(), found.distances.data(),
                 found.status.data(), watch.get());
    return found;
}

/// All places where a ray meets a surface, by rising t.
struct RayHits {
    std::vector<double> params;      ///< [n][2] on the surface.
    std::vector<double> distances;   ///< t, in lengths of the direction.
    std::vector<std::int32_t> kinds; ///< ray_hit or ray_touch each, and ray_back.
    bool complete;                   ///< Whether there are no others, and none is a touch.
};

/// All places where a ray meets a surface, by rising t.
inline Returned<RayHits> ray_hits(const Spline &g, const std::array<double, 3> &origin,
                                  const std::array<double, 3> &direction, View<double> range = {}) {
    detail::require_given(range, 2, "range");
    RayHits found{};
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_surface_ray_hits, g.get(), origin.data(), direction.data(), detail::pointer(range),
                     cap, found.params.data(), found.distances.data(), found.kinds.data(), &count, &complete);
    };
    ask(0);
    found.params = detail::room(count, 2);
    found.distances = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    ask(count);
    found.complete = complete != 0;
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_INTERSECTIONS_HPP
