/* SPDX-License-Identifier: MIT */
/// \file projections.hpp
/// \brief Reflections and projections.
#ifndef NURBS_CPP_PROJECTIONS_HPP
#define NURBS_CPP_PROJECTIONS_HPP

#include <nurbs/cpp/spline.hpp>

#include <initializer_list>
#include <string>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

namespace detail {

inline void check_dimension(const Spline &g, std::initializer_list<View<double>> vectors) {
    const auto dim = static_cast<std::size_t>(detail::dimension(g.get()));
    for (const View<double> &vector : vectors) {
        if (vector.size() != dim) {
            wrong_size("vector", vector.size(), std::to_string(dim));
        }
    }
}

} // namespace detail

/// The mirror image in the plane (line, hyperplane) through a point.
inline Returned<Spline> mirror(const Spline &g, View<double> point, View<double> normal) {
    detail::check_dimension(g, {point, normal});
    return detail::spline_of(nurbs_mirror, g.get(), point.data(), normal.data());
}

/// Along the normal.
inline Returned<Spline> project_to_plane(const Spline &g, View<double> point, View<double> normal) {
    detail::check_dimension(g, {point, normal});
    return detail::spline_of(nurbs_project_to_plane, g.get(), point.data(), normal.data(), nullptr);
}

/// Along a direction.
inline Returned<Spline> project_to_plane(const Spline &g, View<double> point, View<double> normal,
                                         View<double> direction) {
    detail::check_dimension(g, {point, normal, direction});
    return detail::spline_of(nurbs_project_to_plane, g.get(), point.data(), normal.data(), direction.data());
}

/// From an eye.
inline Returned<Spline> project_from(const Spline &g, View<double> eye, View<double> point,
                                     View<double> normal) {
    detail::check_dimension(g, {eye, point, normal});
    return detail::spline_of(nurbs_project_from, g.get(), eye.data(), point.data(), normal.data());
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_PROJECTIONS_HPP
