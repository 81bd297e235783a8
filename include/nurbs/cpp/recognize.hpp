/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file recognize.hpp
/// \brief Recognition of shapes.
#ifndef NURBS_CPP_RECOGNIZE_HPP
#define NURBS_CPP_RECOGNIZE_HPP

#include <nurbs/cpp/spline.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// What recognize() finds.
inline constexpr std::int32_t shape_none = NURBS_SHAPE_NONE;
inline constexpr std::int32_t shape_point = NURBS_SHAPE_POINT;
inline constexpr std::int32_t shape_line = NURBS_SHAPE_LINE;
inline constexpr std::int32_t shape_circle = NURBS_SHAPE_CIRCLE;
inline constexpr std::int32_t shape_ellipse = NURBS_SHAPE_ELLIPSE;
inline constexpr std::int32_t shape_parabola = NURBS_SHAPE_PARABOLA;
inline constexpr std::int32_t shape_hyperbola = NURBS_SHAPE_HYPERBOLA;
inline constexpr std::int32_t shape_plane = NURBS_SHAPE_PLANE;
inline constexpr std::int32_t shape_sphere = NURBS_SHAPE_SPHERE;
inline constexpr std::int32_t shape_cylinder = NURBS_SHAPE_CYLINDER;
inline constexpr std::int32_t shape_cone = NURBS_SHAPE_CONE;
inline constexpr std::int32_t shape_torus = NURBS_SHAPE_TORUS;
inline constexpr std::int32_t shape_revolution = NURBS_SHAPE_REVOLUTION;
inline constexpr std::int32_t shape_extrusion = NURBS_SHAPE_EXTRUSION;
inline constexpr std::int32_t shape_offset = NURBS_SHAPE_OFFSET;

/// A shape, its placement and sizes as nurbs_recognize() describes them, and a proven bound of the distance
/// from it.
struct Recognized {
    std::int32_t shape;           ///< One of the shape_ constants.
    std::array<double, 3> origin; ///< Centre, vertex, apex or another point.
    std::array<double, 3> axis;   ///< Normal or axis.
    std::array<double, 3> x;      ///< The direction where angles start.
    std::array<double, 3> sizes;  ///< Radii, semi-axes, a focal length or half an opening angle.
    double deviation;             ///< A proven bound of the distance from it.
};

/// The first shape of the list from which no point is farther than the tolerance.
inline Returned<Recognized> recognize(const Spline &g, double tolerance) {
    Recognized found{};
    std::array<double, 9> placement{};
    detail::call(nurbs_recognize, g.get(), tolerance, &found.shape, placement.data(), found.sizes.data(),
                 &found.deviation);
    std::copy_n(placement.begin(), 3, found.origin.begin());
    std::copy_n(placement.begin() + 3, 3, found.axis.begin());
    std::copy_n(placement.begin() + 6, 3, found.x.begin());
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<Recognized> recognize(const Spline &g, double tolerance, const CallOptions &call) {
    Recognized found{};
    const detail::Watch watch(call);
    std::array<double, 9> placement{};
    detail::call(nurbs_recognize_with, g.get(), tolerance, &found.shape, placement.data(), found.sizes.data(),
                 &found.deviation, watch.get());
    std::copy_n(placement.begin(), 3, found.origin.begin());
    std::copy_n(placement.begin() + 3, 3, found.axis.begin());
    std::copy_n(placement.begin() + 6, 3, found.x.begin());
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_RECOGNIZE_HPP
