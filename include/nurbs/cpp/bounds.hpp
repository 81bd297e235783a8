/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file bounds.hpp
/// \brief Boxes and cones that contain a spline, proven.
#ifndef NURBS_CPP_BOUNDS_HPP
#define NURBS_CPP_BOUNDS_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Lower and upper ends [dim], and how far a face is from the spline at most.
struct Box {
    std::vector<double> lower; ///< [dim]
    std::vector<double> upper; ///< [dim]
    double gap;                ///< How far a face is from the spline at most.
};

/// An axis-aligned box, tight to the tolerance; infinite: that of the Bezier points.
inline Returned<Box> box(const Spline &g, double tolerance, View<double> range = {}) {
    detail::require_given(range, 2 * detail::axes(g.get()), "range");
    const std::int64_t dim = detail::dimension(g.get());
    Box found{detail::room(dim), detail::room(dim), 0};
    detail::call(nurbs_box, g.get(), detail::pointer(range), tolerance, found.lower.data(),
                 found.upper.data(), &found.gap);
    return found;
}

/// The box of center + sum of x_k axes[k], |x_k| <= half[k].
struct OrientedBox {
    std::vector<double> center; ///< [dim]
    std::vector<double> axes;   ///< Unit vectors [dim][dim].
    std::vector<double> half;   ///< Half the extent along each of them.
};

/// A box with axes of its own.
inline Returned<OrientedBox> oriented_box(const Spline &g, double tolerance) {
    const std::int64_t dim = detail::dimension(g.get());
    OrientedBox found{detail::room(dim), detail::room(dim, dim), detail::room(dim)};
    detail::call(nurbs_oriented_box, g.get(), tolerance, found.center.data(), found.axes.data(),
                 found.half.data());
    return found;
}

/// A unit vector [dim], and half the opening in radians; pi for all of space.
struct DirectionCone {
    std::vector<double> direction; ///< A unit vector.
    double angle;                  ///< Half the opening in radians; pi for all of space.
};

/// The directions of the derivatives along an axis.
inline Returned<DirectionCone> tangent_cone(const Spline &g, std::int32_t axis, double tolerance,
                                            View<double> range = {}) {
    detail::require_given(range, 2 * detail::axes(g.get()), "range");
    DirectionCone found{detail::room(detail::dimension(g.get())), 0};
    detail::call(nurbs_tangent_cone, g.get(), axis, detail::pointer(range), tolerance, found.direction.data(),
                 &found.angle);
    return found;
}

/// The directions of the normals of a surface in space.
inline Returned<DirectionCone> normal_cone(const Spline &g, double tolerance, View<double> range = {}) {
    detail::require_given(range, 2 * detail::axes(g.get()), "range");
    DirectionCone found{detail::room(3), 0};
    detail::call(nurbs_normal_cone, g.get(), detail::pointer(range), tolerance, found.direction.data(),
                 &found.angle);
    return found;
}

/// Parameters [axes] of a point, its component along a direction, and a bound of that of all others.
struct ExtremePoint {
    std::vector<double> params; ///< [axes]
    double value;               ///< Its component along the direction.
    double bound;               ///< A bound of that of all other points.
};

/// The point that is farthest in a direction [dim].
inline Returned<ExtremePoint> extreme_point(const Spline &g, View<double> direction, double tolerance,
                                            View<double> range = {}) {
    detail::require(direction, detail::dimension(g.get()), "direction");
    const std::int64_t axes = detail::axes(g.get());
    detail::require_given(range, 2 * axes, "range");
    ExtremePoint found{detail::room(axes), 0, 0};
    detail::call(nurbs_extreme_point, g.get(), direction.data(), detail::pointer(range), tolerance,
                 found.params.data(), &found.value, &found.bound);
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_BOUNDS_HPP
