/* SPDX-License-Identifier: MIT */
// Generated from tests/capi/calls/*.toml and include/nurbs/nurbs.h by: python3 cmake/interface/generate.py . - do not edit.
// clang-format off
#include "calls/calls.h"

namespace calls {

namespace {

const Call group[] = {
    {"curve_line",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double a[] = {0.1, 0.9};
         static constexpr double b[] = {0.3, 0.7};
         return nurbs_curve_line(2, a, b, &o.out);
     }},
    {"curve_polyline",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_polyline(3, 2, arrays::params, 0, 0, nullptr, 0, &o.out);
     }},
    {"curve_polyline with params",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_polyline(2, 3, arrays::params, 0, 0, arrays::new_knots, 0, &o.out);
     }},
    {"curve_polygon",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_polygon(2, nullptr, nullptr, nullptr, 1, 5, &o.out);
     }},
    {"curve_polygon placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_polygon(3, arrays::center, arrays::axis, arrays::side, 1, 5, &o.out);
     }},
    {"curve_rounded_rectangle",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_rounded_rectangle(2, nullptr, nullptr, nullptr, 3, 2, 0.5, &o.out);
     }},
    {"curve_circle",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_circle(2, nullptr, nullptr, nullptr, 1, NURBS_ARC_SMOOTH, &o.out);
     }},
    {"curve_circle placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_circle(3, arrays::center, arrays::axis, arrays::side, 1, NURBS_ARC_SMOOTH, &o.out);
     }},
    {"curve_arc",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_arc(2, nullptr, nullptr, nullptr, 1, 0, 4, NURBS_ARC_QUARTERS, &o.out);
     }},
    {"curve_arc_through",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double a[] = {0.1, 0.9};
         static constexpr double b[] = {0.3, 0.7};
         static constexpr double c[] = {0.2, 0.6};
         return nurbs_curve_arc_through(2, a, b, c, NURBS_ARC_QUARTERS, &o.out);
     }},
    {"curve_arc_tangent",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double a[] = {0, 0};
         static constexpr double tangent[] = {0, 1};
         static constexpr double b[] = {1, 1};
         return nurbs_curve_arc_tangent(2, a, tangent, b, NURBS_ARC_QUARTERS, &o.out);
     }},
    {"curve_ellipse",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_ellipse(2, nullptr, nullptr, nullptr, 2, 1, 0, 4, NURBS_ARC_SMOOTH, &o.out);
     }},
    {"curve_parabola",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_parabola(2, nullptr, nullptr, nullptr, 1, -1, 2, &o.out);
     }},
    {"curve_parabola placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_parabola(3, arrays::center, arrays::axis, arrays::side, 1, -1, 2, &o.out);
     }},
    {"curve_hyperbola",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_hyperbola(2, nullptr, nullptr, nullptr, 1, 1, 0, 9, &o.out);
     }},
    {"curve_hyperbola placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_hyperbola(3, arrays::center, arrays::axis, arrays::side, 1, 1, 0, 9, &o.out);
     }},
    {"curve_conic_triangle",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double p0[] = {0.1, 0.9};
         static constexpr double p1[] = {0.3, 0.7};
         static constexpr double p2[] = {0.2, 0.6};
         return nurbs_curve_conic_triangle(2, p0, p1, p2, 0.4, &o.out);
     }},
    {"curve_conic_shoulder",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double a[] = {0, 0};
         static constexpr double tangent_a[] = {1, 1};
         static constexpr double b[] = {1, 0};
         static constexpr double tangent_b[] = {1, -1};
         return nurbs_curve_conic_shoulder(2, a, tangent_a, b, tangent_b, 0.4, &o.out);
     }},
    {"curve_conic_through",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double points[] = {-2, 4, -1, 1, 0, 0, 1, 1, 2, 4};
         return nurbs_curve_conic_through(2, points, 0, 0, NURBS_ARC_QUARTERS, &o.out);
     }},
    {"curve_conic_implicit",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double coefficients[] = {1, 0, 4, 0, 0, -4};
         return nurbs_curve_conic_implicit(coefficients, 0, 3, NURBS_ARC_QUARTERS, &o.out);
     }},
    {"curve_helix",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_helix(3, nullptr, nullptr, nullptr, 1, 1, 1, 0, 1, 0.1, o.values, &o.out);
     }},
    {"extrude",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double vector[] = {0, 0, 1};
         return nurbs_extrude(in.twist, vector, &o.out);
     }},
    {"revolve",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_revolve(in.twist, nullptr, nullptr, 6, NURBS_ARC_QUARTERS, &o.out);
     }},
    {"revolve about an axis",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_revolve(in.twist, arrays::center, arrays::axis, 6, NURBS_ARC_QUARTERS, &o.out);
     }},
    {"ruled",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_ruled(in.curve, in.loop, 0, &o.out);
     }},
    {"ruled Cartesian",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_ruled(in.curve, in.loop, NURBS_RULED_CARTESIAN, &o.out);
     }},
    {"tensor_sum",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_tensor_sum(in.curve, 1, in.loop, 2, &o.out);
     }},
    {"tensor_sum homogeneous",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_tensor_sum(in.homogeneous, 1, in.loop, 2, &o.out);
     }},
    {"tensor_product",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_tensor_product(in.twist, in.surface, &o.out);
     }},
    {"surface_swung",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_surface_swung(in.curve, in.loop, 1, &o.out);
     }},
    {"surface_coons",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_edges(in, make_edges);
         if (made_edges.status() != NURBS_OK) {
             return made_edges.status();
         }
         const Items<4> boundaries(made_edges);
         if (boundaries.status() != NURBS_OK) {
             return boundaries.status();
         }
         return nurbs_surface_coons(boundaries, 0, &o.out);
     }},
    {"surface_coons_hermite",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_edges(in, make_edges);
         if (made_edges.status() != NURBS_OK) {
             return made_edges.status();
         }
         const Items<4> boundaries(made_edges);
         if (boundaries.status() != NURBS_OK) {
             return boundaries.status();
         }
         return nurbs_surface_coons_hermite(boundaries, nullptr, NURBS_TWIST_ADINI, nullptr, 0, o.values,
             &o.out);
     }},
    {"volume_coons",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_faces(in, make_faces);
         if (made_faces.status() != NURBS_OK) {
             return made_faces.status();
         }
         const Items<6> faces(made_faces);
         if (faces.status() != NURBS_OK) {
             return faces.status();
         }
         return nurbs_volume_coons(faces, 0, &o.out);
     }},
    {"surface_plane",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double u[] = {0.3, 0.6};
         static constexpr double v[] = {0.1, 0.9};
         return nurbs_surface_plane(2, nullptr, u, v, &o.out);
     }},
    {"surface_plane placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_plane(3, arrays::center, arrays::axis, arrays::side, &o.out);
     }},
    {"surface_bilinear",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double corners[] = {0.1, 0.9, 0.3, 0.7};
         return nurbs_surface_bilinear(1, corners, 0, 0, &o.out);
     }},
    {"volume_trilinear",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double corners[] = {0, 0, 0, 0, 0, 0, 1, 0};
         return nurbs_volume_trilinear(1, corners, 0, 0, &o.out);
     }},
    {"surface_sphere",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double axis[] = {0.1, 0.9, 0.3};
         return nurbs_surface_sphere(nullptr, axis, nullptr, 1, NURBS_ARC_SMOOTH, &o.out);
     }},
    {"surface_sphere placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_sphere(arrays::center, arrays::axis, arrays::side, 1, NURBS_ARC_SMOOTH, &o.out);
     }},
    {"surface_spherical_patch",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_spherical_patch(nullptr, nullptr, nullptr, 1, 0, 4, 0, 1, NURBS_ARC_QUARTERS,
             &o.out);
     }},
    {"surface_sphere_patches",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_sphere_patches(nullptr, nullptr, nullptr, 1, NURBS_HEMISPHERE, &o.list);
     }},
    {"surface_sphere_patches placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_sphere_patches(arrays::center, arrays::axis, arrays::side, 1, NURBS_HEMISPHERE,
             &o.list);
     }},
    {"surface_ellipsoid",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_ellipsoid(nullptr, nullptr, nullptr, 1, 2, 3, NURBS_ARC_THIRDS, &o.out);
     }},
    {"surface_cylinder",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_cylinder(nullptr, nullptr, nullptr, 1, 2, 0, 3, NURBS_ARC_QUARTERS, &o.out);
     }},
    {"surface_cone",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_cone(nullptr, nullptr, nullptr, 1, 0, 2, 0, 3, NURBS_ARC_QUARTERS, &o.out);
     }},
    {"surface_paraboloid",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_paraboloid(nullptr, nullptr, nullptr, 3, 1, 1, 0, 3, NURBS_ARC_QUARTERS, &o.out);
     }},
    {"surface_saddle",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_saddle(nullptr, nullptr, nullptr, 3, 1, 1, &o.out);
     }},
    {"surface_saddle placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_saddle(arrays::center, arrays::axis, arrays::side, 3, 1, 1, &o.out);
     }},
    {"curve_rounded_rectangle placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_rounded_rectangle(3, arrays::center, arrays::axis, arrays::side, 3, 2, 0.5,
             &o.out);
     }},
    {"curve_arc placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_arc(3, arrays::center, arrays::axis, arrays::side, 1, 0, 4, NURBS_ARC_QUARTERS,
             &o.out);
     }},
    {"curve_ellipse placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_ellipse(3, arrays::center, arrays::axis, arrays::side, 2, 1, 0, 4,
             NURBS_ARC_QUARTERS, &o.out);
     }},
    {"curve_conic_point",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double a[] = {0, 0};
         static constexpr double tangent_a[] = {1, 1};
         static constexpr double b[] = {1, 0};
         static constexpr double tangent_b[] = {1, -1};
         static constexpr double point[] = {0.5, 0.25};
         return nurbs_curve_conic_point(2, a, tangent_a, b, tangent_b, point, NURBS_ARC_QUARTERS, &o.out);
     }},
    {"curve_conic_focus",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double focus[] = {0, 0};
         static constexpr double foot[] = {1, 0};
         return nurbs_curve_conic_focus(2, focus, nullptr, foot, 0.5, 0, 6, NURBS_ARC_QUARTERS, &o.out);
     }},
    {"curve_conic_focus in space",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double foot[] = {2, 2, 3};
         return nurbs_curve_conic_focus(3, arrays::center, arrays::axis, foot, 0.5, 0, 6, NURBS_ARC_QUARTERS,
             &o.out);
     }},
    {"curve_helix placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_curve_helix(3, arrays::center, arrays::axis, arrays::side, 1, 1, 1, 0, 1, 0.1, o.values,
             &o.out);
     }},
    {"surface_coons_hermite with twists",
     [](const Inputs &in, Output &o) -> nurbs_status {
         const nurbs *const boundaries[] = {in.twist, in.twist, in.twist, in.twist};
         const nurbs *const cross[] = {in.twist, in.twist, in.twist, in.twist};
         static constexpr double twists[] = {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0};
         return nurbs_surface_coons_hermite(boundaries, cross, NURBS_TWIST_GIVEN, twists, 99, o.values,
             &o.out);
     }},
    {"surface_spherical_patch placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_spherical_patch(arrays::center, arrays::axis, arrays::side, 1, 0, 4, 0, 1,
             NURBS_ARC_QUARTERS, &o.out);
     }},
    {"surface_ellipsoid placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_ellipsoid(arrays::center, arrays::axis, arrays::side, 1, 2, 3, NURBS_ARC_THIRDS,
             &o.out);
     }},
    {"surface_cylinder placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_cylinder(arrays::center, arrays::axis, arrays::side, 1, 2, 0, 3,
             NURBS_ARC_QUARTERS, &o.out);
     }},
    {"surface_cone placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_cone(arrays::center, arrays::axis, arrays::side, 1, 0, 2, 0, 3,
             NURBS_ARC_QUARTERS, &o.out);
     }},
    {"surface_torus",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_torus(nullptr, nullptr, nullptr, 3, 1, 0, 3, 0, 6, NURBS_ARC_SMOOTH, &o.out);
     }},
    {"surface_torus placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_torus(arrays::center, arrays::axis, arrays::side, 3, 1, 0, 3, 0, 6,
             NURBS_ARC_SMOOTH, &o.out);
     }},
    {"surface_paraboloid placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_paraboloid(arrays::center, arrays::axis, arrays::side, 3, 1, 1, 0, 3,
             NURBS_ARC_QUARTERS, &o.out);
     }},
    {"surface_hyperboloid",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_hyperboloid(nullptr, nullptr, nullptr, 3, 1, 1, -9, 9, 0, 3, NURBS_ARC_QUARTERS,
             0, &o.out);
     }},
    {"surface_hyperboloid placed",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_surface_hyperboloid(arrays::center, arrays::axis, arrays::side, 3, 1, 1, -9, 9, 0, 3,
             NURBS_ARC_QUARTERS, 0, &o.out);
     }},
};

} // namespace

std::span<const Call> shape_calls() {
    return group;
}

} // namespace calls
