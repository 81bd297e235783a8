/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file shapes.hpp
/// \brief Surfaces and volumes from curves.
#ifndef NURBS_CPP_SHAPES_HPP
#define NURBS_CPP_SHAPES_HPP

#include <nurbs/cpp/list.hpp>
#include <nurbs/cpp/placement.hpp>
#include <nurbs/cpp/spline.hpp>

#include <array>
#include <cstdint>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

// From curves and surfaces

/// Moved along a vector, which becomes a new last axis.
inline Returned<Spline> extrude(const Spline &g, View<double> vector) {
    detail::require(vector, detail::dimension(g.get()), "vector");
    return detail::made<Spline>(nurbs_extrude, g.get(), vector.data());
}

/// Turned about an axis through a point, the angle being a new first axis.
inline Returned<Spline> revolve(const Spline &g, double sweep = full_turn, View<double> point = {},
                                View<double> axis = {}, std::int32_t form = arc_quarters) {
    detail::require_space({point, axis}, "point and axis");
    return detail::made<Spline>(nurbs_revolve, g.get(), detail::pointer(point), detail::pointer(axis), sweep,
                                form);
}

/// Straight lines from a to b; flags: ruled_cartesian.
inline Returned<Spline> ruled(const Spline &a, const Spline &b, std::uint32_t flags = 0) {
    return detail::made<Spline>(nurbs_ruled, a.get(), b.get(), flags);
}

/// alpha a(u) + beta b(v).
inline Returned<Spline> tensor_sum(const Spline &a, double alpha, const Spline &b, double beta) {
    return detail::made<Spline>(nurbs_tensor_sum, a.get(), alpha, b.get(), beta);
}

/// a(u) b(v), component by component.
inline Returned<Spline> tensor_product(const Spline &a, const Spline &b) {
    return detail::made<Spline>(nurbs_tensor_product, a.get(), b.get());
}

/// (scale r(v) x(u), scale r(v) y(u), z(v)) for the trajectory (x, y) and the profile (r, z).
inline Returned<Spline> swung(const Spline &trajectory, const Spline &profile, double scale = 1) {
    return detail::made<Spline>(nurbs_surface_swung, trajectory.get(), profile.get(), scale);
}

// Patches

/// The parallelogram over two sides from an origin, which is 0 if empty.
inline Returned<Spline> plane(View<double> u, View<double> v, View<double> origin = {}) {
    const std::int32_t dim = detail::dimension_of({u, v, origin}, 0);
    return detail::made<Spline>(nurbs_surface_plane, dim, detail::pointer(origin), u.data(), v.data());
}

/// Over corners [4][dim].
inline Returned<Spline> bilinear(std::int32_t dim, Input corners) {
    corners.require(4, dim, "corners");
    return detail::made<Spline>(nurbs_surface_bilinear, dim, corners.data(), corners.stride(),
                                corners.component_stride());
}

/// Over corners [8][dim].
inline Returned<Spline> trilinear(std::int32_t dim, Input corners) {
    corners.require(8, dim, "corners");
    return detail::made<Spline>(nurbs_volume_trilinear, dim, corners.data(), corners.stride(),
                                corners.component_stride());
}

// Spheres

/// By longitude and latitude, with poles.
inline Returned<Spline> sphere(const Placement &at, double radius, std::int32_t form = arc_quarters) {
    const detail::Space place(at);
    return detail::made<Spline>(nurbs_surface_sphere, place.origin, place.axis, place.x, radius, form);
}

/// Longitudes, and latitudes from south to north.
inline Returned<Spline> spherical_patch(const Placement &at, double radius, double start, double sweep,
                                        double south, double north, std::int32_t form = arc_quarters) {
    const detail::Space place(at);
    return detail::made<Spline>(nurbs_surface_spherical_patch, place.origin, place.axis, place.x, radius,
                                start, sweep, south, north, form);
}

/// Six patches of degree 4 x 4 without poles; flags: hemisphere, five patches.
inline Returned<List> sphere_patches(const Placement &at, double radius, std::uint32_t flags = 0) {
    const detail::Space place(at);
    return detail::made<List>(nurbs_surface_sphere_patches, place.origin, place.axis, place.x, radius, flags);
}

/// Semi-axes along X, Y and Z.
inline Returned<Spline> ellipsoid(const Placement &at, const std::array<double, 3> &radii,
                                  std::int32_t form = arc_quarters) {
    const detail::Space place(at);
    return detail::made<Spline>(nurbs_surface_ellipsoid, place.origin, place.axis, place.x, radii[0],
                                radii[1], radii[2], form);
}

// Surfaces of revolution

/// The side of a cylinder, or a part of it.
inline Returned<Spline> cylinder(const Placement &at, double radius, double height, double start = 0,
                                 double sweep = full_turn, std::int32_t form = arc_quarters) {
    const detail::Space place(at);
    return detail::made<Spline>(nurbs_surface_cylinder, place.origin, place.axis, place.x, radius, height,
                                start, sweep, form);
}

/// Radii of the base and of the top.
inline Returned<Spline> cone(const Placement &at, double base_radius, double top_radius, double height,
                             double start = 0, double sweep = full_turn, std::int32_t form = arc_quarters) {
    const detail::Space place(at);
    return detail::made<Spline>(nurbs_surface_cone, place.origin, place.axis, place.x, base_radius,
                                top_radius, height, start, sweep, form);
}

/// Major and minor radius; angles about the axis, and about the tube.
inline Returned<Spline> torus(const Placement &at, double major_radius, double minor_radius, double start = 0,
                              double sweep = full_turn, double tube_start = 0, double tube_sweep = full_turn,
                              std::int32_t form = arc_quarters) {
    const detail::Space place(at);
    return detail::made<Spline>(nurbs_surface_torus, place.origin, place.axis, place.x, major_radius,
                                minor_radius, start, sweep, tube_start, tube_sweep, form);
}

// Other quadrics

/// A bowl from its vertex to a rim with two semi-axes.
inline Returned<Spline> paraboloid(const Placement &at, const std::array<double, 2> &radii, double height,
                                   double start = 0, double sweep = full_turn,
                                   std::int32_t form = arc_quarters) {
    const detail::Space place(at);
    return detail::made<Spline>(nurbs_surface_paraboloid, place.origin, place.axis, place.x, radii[0],
                                radii[1], height, start, sweep, form);
}

/// The hyperbolic paraboloid over a rectangle.
inline Returned<Spline> saddle(const Placement &at, const std::array<double, 2> &radii, double height) {
    const detail::Space place(at);
    return detail::made<Spline>(nurbs_surface_saddle, place.origin, place.axis, place.x, radii[0], radii[1],
                                height);
}

/// Between the heights bottom and top; flags: two_sheets.
inline Returned<Spline> hyperboloid(const Placement &at, const std::array<double, 3> &radii, double bottom,
                                    double top, double start = 0, double sweep = full_turn,
                                    std::int32_t form = arc_quarters, std::uint32_t flags = 0) {
    const detail::Space place(at);
    return detail::made<Spline>(nurbs_surface_hyperboloid, place.origin, place.axis, place.x, radii[0],
                                radii[1], radii[2], bottom, top, start, sweep, form, flags);
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_SHAPES_HPP
