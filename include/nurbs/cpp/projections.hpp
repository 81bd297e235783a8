/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file projections.hpp
/// \brief Reflections and projections.
#ifndef NURBS_CPP_PROJECTIONS_HPP
#define NURBS_CPP_PROJECTIONS_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// The mirror image in the plane (line, hyperplane) through a point.
inline Returned<Spline> mirror(const Spline &g, View<double> point, View<double> normal) {
    const std::int64_t dim = detail::dimension(g.get());
    detail::require(point, dim, "vector");
    detail::require(normal, dim, "vector");
    return detail::made<Spline>(nurbs_mirror, g.get(), point.data(), normal.data());
}

/// Projected along the normal.
inline Returned<Spline> project_to_plane(const Spline &g, View<double> point, View<double> normal) {
    const std::int64_t dim = detail::dimension(g.get());
    detail::require(point, dim, "vector");
    detail::require(normal, dim, "vector");
    return detail::made<Spline>(nurbs_project_to_plane, g.get(), point.data(), normal.data(), nullptr);
}

/// Projected along a direction.
inline Returned<Spline> project_to_plane(const Spline &g, View<double> point, View<double> normal,
                                         View<double> direction) {
    const std::int64_t dim = detail::dimension(g.get());
    detail::require(point, dim, "vector");
    detail::require(normal, dim, "vector");
    detail::require(direction, dim, "vector");
    return detail::made<Spline>(nurbs_project_to_plane, g.get(), point.data(), normal.data(),
                                direction.data());
}

/// Projected from an eye.
inline Returned<Spline> project_from(const Spline &g, View<double> eye, View<double> point,
                                     View<double> normal) {
    const std::int64_t dim = detail::dimension(g.get());
    detail::require(eye, dim, "vector");
    detail::require(point, dim, "vector");
    detail::require(normal, dim, "vector");
    return detail::made<Spline>(nurbs_project_from, g.get(), eye.data(), point.data(), normal.data());
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_PROJECTIONS_HPP
