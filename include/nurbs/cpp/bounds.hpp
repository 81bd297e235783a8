/* SPDX-License-Identifier: MIT */
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
    std::vector<double> lower;
    std::vector<double> upper;
    double gap;
};

/// An axis-aligned box, tight to the tolerance; infinite: that of the Bezier points.
inline Returned<Box> box(const Spline &g, double tolerance, View<double> range = {}) {
    const auto dim = detail::to_size(detail::dimension(g.get()));
    Box found{std::vector<double>(dim), std::vector<double>(dim), 0};
    detail::call(nurbs_box, g.get(), detail::range_of(g, range), tolerance, found.lower.data(),
                 found.upper.data(), &found.gap);
    return found;
}

/// The box of center + sum of x_k axes[k], |x_k| <= half[k], with axes [dim][dim].
struct OrientedBox {
    std::vector<double> center;
    std::vector<double> axes;
    std::vector<double> half;
};

/// A box with axes of its own.
inline Returned<OrientedBox> oriented_box(const Spline &g, double tolerance) {
    const auto dim = detail::to_size(detail::dimension(g.get()));
    OrientedBox found{std::vector<double>(dim), std::vector<double>(dim * dim), std::vector<double>(dim)};
    detail::call(nurbs_oriented_box, g.get(), tolerance, found.center.data(), found.axes.data(),
                 found.half.data());
    return found;
}

/// A unit vector [dim], and half the opening in radians; pi for all of space.
struct DirectionCone {
    std::vector<double> direction;
    double angle;
};

/// The directions of the derivatives along an axis.
inline Returned<DirectionCone> tangent_cone(const Spline &g, std::int32_t axis, double tolerance,
                                            View<double> range = {}) {
    DirectionCone found{std::vector<double>(detail::to_size(detail::dimension(g.get()))), 0};
    detail::call(nurbs_tangent_cone, g.get(), axis, detail::range_of(g, range), tolerance,
                 found.direction.data(), &found.angle);
    return found;
}

/// The directions of the normals of a surface in space.
inline Returned<DirectionCone> normal_cone(const Spline &g, double tolerance, View<double> range = {}) {
    DirectionCone found{std::vector<double>(3), 0};
    detail::call(nurbs_normal_cone, g.get(), detail::range_of(g, range), tolerance, found.direction.data(),
                 &found.angle);
    return found;
}

/// Parameters [axes] of a point, its component along a direction, and a bound of that of all others.
struct ExtremePoint {
    std::vector<double> params;
    double value;
    double bound;
};

/// The point that is farthest in a direction [dim].
inline Returned<ExtremePoint> extreme_point(const Spline &g, View<double> direction, double tolerance,
                                            View<double> range = {}) {
    ExtremePoint found{std::vector<double>(detail::to_size(detail::axes(g.get()))), 0, 0};
    detail::call(nurbs_extreme_point, g.get(), detail::point_of(g, direction, "direction"),
                 detail::range_of(g, range), tolerance, found.params.data(), &found.value, &found.bound);
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_BOUNDS_HPP
