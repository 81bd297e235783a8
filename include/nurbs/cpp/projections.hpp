/* SPDX-License-Identifier: MIT */
/// \file projections.hpp
/// \brief Reflections and projections.
#ifndef NURBS_CPP_PROJECTIONS_HPP
#define NURBS_CPP_PROJECTIONS_HPP

#include <nurbs/cpp/spline.hpp>

#include <initializer_list>
#include <string>

namespace libnurbs {

namespace detail {

inline void check_dimension(const Spline &g, std::initializer_list<View<double>> vectors) {
    const auto dim = static_cast<std::size_t>(g.dimension());
    for (const View<double> &vector : vectors) {
        if (vector.size() != dim) {
            wrong_size("vector", vector.size(), std::to_string(dim));
        }
    }
}

} // namespace detail

/// The mirror image in the plane (line, hyperplane) through a point.
inline Spline mirror(const Spline &g, View<double> point, View<double> normal) {
    detail::check_dimension(g, {point, normal});
    nurbs *out = nullptr;
    detail::check(nurbs_mirror(g.get(), point.data(), normal.data(), &out));
    return Spline(out);
}

/// Along the normal.
inline Spline project_to_plane(const Spline &g, View<double> point, View<double> normal) {
    detail::check_dimension(g, {point, normal});
    nurbs *out = nullptr;
    detail::check(nurbs_project_to_plane(g.get(), point.data(), normal.data(), nullptr, &out));
    return Spline(out);
}

/// Along a direction.
inline Spline project_to_plane(const Spline &g, View<double> point, View<double> normal,
                               View<double> direction) {
    detail::check_dimension(g, {point, normal, direction});
    nurbs *out = nullptr;
    detail::check(nurbs_project_to_plane(g.get(), point.data(), normal.data(), direction.data(), &out));
    return Spline(out);
}

/// From an eye.
inline Spline project_from(const Spline &g, View<double> eye, View<double> point, View<double> normal) {
    detail::check_dimension(g, {eye, point, normal});
    nurbs *out = nullptr;
    detail::check(nurbs_project_from(g.get(), eye.data(), point.data(), normal.data(), &out));
    return Spline(out);
}

} // namespace libnurbs

#endif // NURBS_CPP_PROJECTIONS_HPP
