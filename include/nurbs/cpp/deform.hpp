/* SPDX-License-Identifier: MIT */
/// \file deform.hpp
/// \brief Deformations of a shape or of a region [axes][2] of it.
#ifndef NURBS_CPP_DEFORM_HPP
#define NURBS_CPP_DEFORM_HPP

#include <nurbs/cpp/edit.hpp>
#include <nurbs/cpp/placement.hpp>
#include <nurbs/cpp/reduce.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// A region raised along a direction [dim]; `order` derivatives stay at its ends.
inline Returned<Spline> warp(const Spline &g, View<double> direction, double distance, std::int32_t order,
                             View<double> range = {}) {
    const double *along = detail::point_of(g, direction, "direction"), *part = detail::range_of(g, range);
    return detail::spline_of(nurbs_warp, g.get(), part, along, distance, order);
}

/// A region flattened to the plane through a point [dim], along a direction or else its normal.
inline Returned<PointEdit> flatten(const Spline &g, View<double> point, View<double> normal,
                                   View<double> direction = {}, View<double> range = {}) {
    const double *on = detail::point_of(g, point, "point"), *up = detail::point_of(g, normal, "normal");
    const double *along = detail::if_given(std::span(direction), detail::dimension(g.get()), "direction");
    const double *part = detail::range_of(g, range);
    double moved = 0;
    Spline spline = detail::spline_of(nurbs_flatten, g.get(), part, on, up, along, &moved);
    return PointEdit{std::move(spline), moved};
}

/// A spline near the exact image: how far it is from that, a bound if proven, else of samples.
struct Deformed {
    Spline spline;
    double deviation;
    bool proven;
};

/// A bend about an axis across the plane of two vectors [dim].
struct Bend {
    std::vector<double> origin;
    std::vector<double> along;
    std::vector<double> across;
    double curvature = 0;
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
};

inline Returned<Deformed> bend(const Spline &g, const Bend &how, double tolerance) {
    const double *origin = detail::point_of(g, how.origin, "origin");
    const double *along = detail::point_of(g, how.along, "along");
    const double *across = detail::point_of(g, how.across, "across");
    double deviation = 0;
    std::int32_t proven = 0;
    Spline spline = detail::spline_of(nurbs_bend, g.get(), origin, along, across, how.curvature, how.lower,
                                      how.upper, tolerance, &deviation, &proven);
    return Deformed{std::move(spline), deviation, proven != 0};
}

/// A shape in the box from lower to upper mapped by a volume.
inline Returned<Deformed> free_form_deform(const Spline &g, const Spline &volume, View<double> lower,
                                           View<double> upper, double tolerance) {
    const double *from = detail::exactly(std::span(lower), detail::axes(volume.get()), "lower");
    const double *to = detail::exactly(std::span(upper), detail::axes(volume.get()), "upper");
    double deviation = 0;
    std::int32_t proven = 0;
    Spline spline = detail::spline_of(nurbs_free_form_deform, g.get(), volume.get(), from, to, tolerance,
                                      &deviation, &proven);
    return Deformed{std::move(spline), deviation, proven != 0};
}

/// The spline, its energies before and after, and a bound of how far it moved.
struct Faired {
    Spline spline;
    std::array<double, 2> energies;
    double bound;
};

/// Small energy within a tolerance: order 1 (membrane), 2 (thin plate) or 3; keep [axes][2] derivatives that
/// stay at the ends, empty: positions.
inline Returned<Faired> fair(const Spline &g, std::int32_t order, double tolerance,
                             View<std::int32_t> keep = {}) {
    const std::int32_t *stay =
        detail::if_given(std::span(keep), 2 * std::int64_t{detail::axes(g.get())}, "keep");
    Faired made{};
    made.spline =
        detail::spline_of(nurbs_fair, g.get(), order, stay, tolerance, made.energies.data(), &made.bound);
    return made;
}

/// start_of_axis or end_of_axis of an axis.
struct Boundary {
    std::int32_t axis;
    std::int32_t end;
};

/// A boundary moved onto one of another spline, with order 1 tangents too; flags: 0 or reversed.
inline Returned<Reduced> snap_boundary(const Spline &g, Boundary own, const Spline &other, Boundary target,
                                       std::int32_t order = 0, std::uint32_t flags = 0) {
    double bound = 0;
    Spline spline = detail::spline_of(nurbs_snap_boundary, g.get(), own.axis, own.end, other.get(),
                                      target.axis, target.end, order, flags, &bound);
    return Reduced{std::move(spline), bound};
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_DEFORM_HPP
