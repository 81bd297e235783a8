/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file deform.hpp
/// \brief Deformations of a shape or of a region [axes][2] of it.
#ifndef NURBS_CPP_DEFORM_HPP
#define NURBS_CPP_DEFORM_HPP

#include <nurbs/cpp/edit.hpp>
#include <nurbs/cpp/reduce.hpp>
#include <nurbs/cpp/spline.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// A region raised along a direction [dim]; `order` derivatives stay at its ends.
inline Returned<Spline> warp(const Spline &g, View<double> direction, double distance, std::int32_t order,
                             View<double> range = {}) {
    detail::require(direction, detail::dimension(g.get()), "direction");
    detail::require_given(range, 2 * detail::axes(g.get()), "range");
    return detail::made<Spline>(nurbs_warp, g.get(), detail::pointer(range), direction.data(), distance,
                                order);
}

/// A region flattened to the plane through a point [dim], along a direction or else its normal.
inline Returned<PointEdit> flatten(const Spline &g, View<double> point, View<double> normal,
                                   View<double> direction = {}, View<double> range = {}) {
    const std::int64_t dim = detail::dimension(g.get());
    detail::require(point, dim, "point");
    detail::require(normal, dim, "normal");
    detail::require_given(direction, dim, "direction");
    detail::require_given(range, 2 * detail::axes(g.get()), "range");
    PointEdit made{};
    made.spline = detail::made<Spline>(nurbs_flatten, g.get(), detail::pointer(range), point.data(),
                                       normal.data(), detail::pointer(direction), &made.moved);
    return made;
}

/// A spline near the exact image: how far it is from that, a bound if proven, else of samples.
struct Deformed {
    Spline spline;    ///< The spline.
    double deviation; ///< How far it is from the exact image.
    bool proven;      ///< Whether that is a bound, or else of samples.
};

/// A bend about an axis across the plane of two vectors [dim].
struct Bend {
    std::vector<double> origin; ///< A point that stays, [dim].
    std::vector<double> along;  ///< The direction that is bent, [dim].
    std::vector<double> across; ///< The direction away from the axis, [dim].
    double curvature = 0;       ///< Of the line along.
    /// The start of the bent part; infinite ends are allowed.
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity(); ///< The end of what is bent along it.
};

/// A bend about an axis across the plane of two vectors.
inline Returned<Deformed> bend(const Spline &g, const Bend &how, double tolerance) {
    const std::int64_t dim = detail::dimension(g.get());
    detail::require(how.origin, dim, "origin");
    detail::require(how.along, dim, "along");
    detail::require(how.across, dim, "across");
    Deformed made{};
    std::int32_t proven = 0;
    made.spline =
        detail::made<Spline>(nurbs_bend, g.get(), how.origin.data(), how.along.data(), how.across.data(),
                             how.curvature, how.lower, how.upper, tolerance, &made.deviation, &proven);
    made.proven = proven != 0;
    return made;
}
/// The same; `call` can watch and end it.
inline Returned<Deformed> bend(const Spline &g, const Bend &how, double tolerance, const CallOptions &call) {
    const std::int64_t dim = detail::dimension(g.get());
    detail::require(how.origin, dim, "origin");
    detail::require(how.along, dim, "along");
    detail::require(how.across, dim, "across");
    Deformed made{};
    const detail::Watch watch(call);
    std::int32_t proven = 0;
    made.spline = detail::made<Spline>(nurbs_bend_with, g.get(), how.origin.data(), how.along.data(),
                                       how.across.data(), how.curvature, how.lower, how.upper, tolerance,
                                       &made.deviation, &proven, watch.get());
    made.proven = proven != 0;
    return made;
}

/// A shape in the box from `lower` to `upper` mapped by a volume.
inline Returned<Deformed> free_form_deform(const Spline &g, const Spline &volume, View<double> lower,
                                           View<double> upper, double tolerance) {
    const std::int64_t axes_of_volume = detail::axes(volume.get());
    detail::require(lower, axes_of_volume, "lower");
    detail::require(upper, axes_of_volume, "upper");
    Deformed made{};
    std::int32_t proven = 0;
    made.spline = detail::made<Spline>(nurbs_free_form_deform, g.get(), volume.get(), lower.data(),
                                       upper.data(), tolerance, &made.deviation, &proven);
    made.proven = proven != 0;
    return made;
}
/// The same; `call` can watch and end it.
inline Returned<Deformed> free_form_deform(const Spline &g, const Spline &volume, View<double> lower,
                                           View<double> upper, double tolerance, const CallOptions &call) {
    const std::int64_t axes_of_volume = detail::axes(volume.get());
    detail::require(lower, axes_of_volume, "lower");
    detail::require(upper, axes_of_volume, "upper");
    Deformed made{};
    const detail::Watch watch(call);
    std::int32_t proven = 0;
    made.spline = detail::made<Spline>(nurbs_free_form_deform_with, g.get(), volume.get(), lower.data(),
                                       upper.data(), tolerance, &made.deviation, &proven, watch.get());
    made.proven = proven != 0;
    return made;
}

/// The spline, its energies before and after, and a bound of how far it moved.
struct Faired {
    Spline spline;                  ///< The spline.
    std::array<double, 2> energies; ///< Before and after.
    double bound;                   ///< Of how far it moved.
};

/// Small energy within a tolerance: order 1 (membrane), 2 (thin plate) or 3; keep [axes][2] derivatives that
/// stay at the ends, empty: positions.
inline Returned<Faired> fair(const Spline &g, std::int32_t order, double tolerance,
                             View<std::int32_t> keep = {}) {
    detail::require_given(keep, 2 * detail::axes(g.get()), "keep");
    Faired made{};
    made.spline = detail::made<Spline>(nurbs_fair, g.get(), order, detail::pointer(keep), tolerance,
                                       made.energies.data(), &made.bound);
    return made;
}
/// The same; `call` can watch and end it.
inline Returned<Faired> fair(const Spline &g, std::int32_t order, double tolerance, View<std::int32_t> keep,
                             const CallOptions &call) {
    detail::require_given(keep, 2 * detail::axes(g.get()), "keep");
    Faired made{};
    const detail::Watch watch(call);
    made.spline = detail::made<Spline>(nurbs_fair_with, g.get(), order, detail::pointer(keep), tolerance,
                                       made.energies.data(), &made.bound, watch.get());
    return made;
}

/// start_of_axis or end_of_axis of an axis.
struct Boundary {
    std::int32_t axis; ///< The axis.
    std::int32_t end;  ///< start_of_axis or end_of_axis.
};

/// A boundary moved onto one of another spline, with order 1 tangents too; flags: 0 or reversed.
inline Returned<Reduced> snap_boundary(const Spline &g, Boundary own, const Spline &other, Boundary target,
                                       std::int32_t order = 0, std::uint32_t flags = 0) {
    Reduced made{};
    made.spline = detail::made<Spline>(nurbs_snap_boundary, g.get(), own.axis, own.end, other.get(),
                                       target.axis, target.end, order, flags, &made.bound);
    return made;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_DEFORM_HPP
