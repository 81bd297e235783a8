/* SPDX-License-Identifier: MIT */
// Curves, surfaces and volumes of known shapes.
#include "calls/calls.h"

namespace calls {

namespace {

// The boundaries of a surface or volume, blended; 0: bilinearly, else bicubically.
nurbs_status blend_boundaries(const nurbs *g, int order, Output &o) {
    nurbs_list *list = nullptr;
    nurbs *parts[6] = {};
    int64_t count = 0;
    nurbs_status status = nurbs_boundaries(g, &list);
    if (status == NURBS_OK) {
        status = nurbs_list_count(list, &count);
    }
    for (int64_t i = 0; i < count && status == NURBS_OK; ++i) {
        status = nurbs_list_get(list, i, &parts[i]);
    }
    if (status == NURBS_OK) {
        status = count == 6   ? nurbs_volume_coons(parts, 0, &o.out)
                 : order == 0 ? nurbs_surface_coons(parts, 0, &o.out)
                              : nurbs_surface_coons_hermite(parts, nullptr, NURBS_TWIST_ADINI, nullptr, 0,
                                                            nullptr, &o.out);
    }
    for (nurbs *part : parts) {
        nurbs_destroy(part);
    }
    nurbs_list_destroy(list);
    return status;
}

nurbs_status arc(const Inputs &, Output &o) {
    return nurbs_curve_arc(2, nullptr, nullptr, nullptr, 1, 0, 4, 0, &o.out);
}

nurbs_status arc_tangent(const Inputs &, Output &o) {
    static const double a[] = {0, 0}, up[] = {0, 1}, b[] = {1, 1};
    return nurbs_curve_arc_tangent(2, a, up, b, 0, &o.out);
}

nurbs_status ellipse(const Inputs &, Output &o) {
    return nurbs_curve_ellipse(2, nullptr, nullptr, nullptr, 2, 1, 0, 4, NURBS_ARC_SMOOTH, &o.out);
}

nurbs_status parabola(const Inputs &, Output &o) {
    return nurbs_curve_parabola(2, nullptr, nullptr, nullptr, 1, -1, 2, &o.out);
}

nurbs_status conic_triangle(const Inputs &, Output &o) {
    return nurbs_curve_conic_triangle(2, params, params + 2, params + 4, 0.4, &o.out);
}

nurbs_status conic_point(const Inputs &, Output &o) {
    static const double ends[] = {0, 0, 1, 0}, tangents[] = {1, 1, 1, -1}, point[] = {0.5, 0.25};
    return nurbs_curve_conic_point(2, ends, tangents, ends + 2, tangents + 2, point, 0, &o.out);
}

const Call group[] = {
    {"polyline",
     [](const Inputs &, Output &o) { return nurbs_curve_polyline(3, 2, params, 0, 0, nullptr, 0, &o.out); }},
    {"polygon", [](const Inputs &,
                   Output &o) { return nurbs_curve_polygon(2, nullptr, nullptr, nullptr, 1, 5, &o.out); }},
    {"rounded_rectangle",
     [](const Inputs &, Output &o) {
         return nurbs_curve_rounded_rectangle(2, nullptr, nullptr, nullptr, 3, 2, 0.5, &o.out);
     }},
    {"circle",
     [](const Inputs &, Output &o) {
         return nurbs_curve_circle(3, nullptr, nullptr, nullptr, 1, NURBS_ARC_SMOOTH, &o.out);
     }},
    {"hyperbola",
     [](const Inputs &, Output &o) {
         return nurbs_curve_hyperbola(2, nullptr, nullptr, nullptr, 1, 1, 0, 9, &o.out);
     }},
    {"arc_through",
     [](const Inputs &, Output &o) {
         return nurbs_curve_arc_through(2, params, params + 2, params + 4, 0, &o.out);
     }},
    {"conic_shoulder",
     [](const Inputs &, Output &o) {
         static const double ends[] = {0, 0, 1, 0}, tangents[] = {1, 1, 1, -1};
         return nurbs_curve_conic_shoulder(2, ends, tangents, ends + 2, tangents + 2, 0.4, &o.out);
     }},
    {"conic_through",
     [](const Inputs &, Output &o) {
         static const double five[] = {-2, 4, -1, 1, 0, 0, 1, 1, 2, 4};
         return nurbs_curve_conic_through(2, five, 0, 0, 0, &o.out);
     }},
    {"conic_implicit",
     [](const Inputs &, Output &o) {
         static const double ellipse[] = {1, 0, 4, 0, 0, -4};
         return nurbs_curve_conic_implicit(ellipse, 0, 3, 0, &o.out);
     }},
    {"conic_focus",
     [](const Inputs &, Output &o) {
         static const double foot[] = {1, 0}, focus[] = {0, 0};
         return nurbs_curve_conic_focus(2, focus, nullptr, foot, 0.5, 0, 6, 0, &o.out);
     }},
    {"helix",
     [](const Inputs &, Output &o) {
         return nurbs_curve_helix(3, nullptr, nullptr, nullptr, 1, 1, 1, 0, 1, 0.1, nullptr, &o.out);
     }},
    {"surface_coons", [](const Inputs &in, Output &o) { return blend_boundaries(in.surface, 0, o); }},
    {"surface_coons_hermite", [](const Inputs &in, Output &o) { return blend_boundaries(in.surface, 3, o); }},
    {"volume_coons", [](const Inputs &in, Output &o) { return blend_boundaries(in.volume, 0, o); }},
    {"extrude",
     [](const Inputs &in, Output &o) {
         static const double up[] = {0, 0, 1};
         return nurbs_extrude(in.twist, up, &o.out);
     }},
    {"revolve",
     [](const Inputs &in, Output &o) { return nurbs_revolve(in.twist, nullptr, nullptr, 6, 0, &o.out); }},
    {"ruled", [](const Inputs &in, Output &o) { return nurbs_ruled(in.curve, in.loop, 0, &o.out); }},
    {"ruled Cartesian",
     [](const Inputs &in, Output &o) {
         return nurbs_ruled(in.curve, in.loop, NURBS_RULED_CARTESIAN, &o.out);
     }},
    {"tensor_sum",
     [](const Inputs &in, Output &o) { return nurbs_tensor_sum(in.curve, 1, in.loop, 2, &o.out); }},
    {"tensor_sum homogeneous",
     [](const Inputs &in, Output &o) { return nurbs_tensor_sum(in.homogeneous, 1, in.loop, 2, &o.out); }},
    {"tensor_product",
     [](const Inputs &in, Output &o) { return nurbs_tensor_product(in.twist, in.surface, &o.out); }},
    {"surface_swung",
     [](const Inputs &in, Output &o) { return nurbs_surface_swung(in.curve, in.loop, 1, &o.out); }},
    {"surface_plane",
     [](const Inputs &, Output &o) { return nurbs_surface_plane(2, nullptr, new_knots, params, &o.out); }},
    {"surface_bilinear",
     [](const Inputs &, Output &o) { return nurbs_surface_bilinear(1, params, 0, 0, &o.out); }},
    {"volume_trilinear",
     [](const Inputs &, Output &o) { return nurbs_volume_trilinear(1, cube().points, 0, 0, &o.out); }},
    {"surface_sphere",
     [](const Inputs &, Output &o) { return nurbs_surface_sphere(nullptr, params, nullptr, 1, 2, &o.out); }},
    {"surface_spherical_patch",
     [](const Inputs &, Output &o) {
         return nurbs_surface_spherical_patch(nullptr, nullptr, nullptr, 1, 0, 4, 0, 1, 0, &o.out);
     }},
    {"surface_sphere_patches",
     [](const Inputs &, Output &o) {
         return nurbs_surface_sphere_patches(nullptr, nullptr, nullptr, 1, NURBS_HEMISPHERE, &o.list);
     }},
    {"surface_ellipsoid",
     [](const Inputs &, Output &o) {
         return nurbs_surface_ellipsoid(nullptr, nullptr, nullptr, 1, 2, 3, 1, &o.out);
     }},
    {"surface_cylinder",
     [](const Inputs &, Output &o) {
         return nurbs_surface_cylinder(nullptr, nullptr, nullptr, 1, 2, 0, 3, 0, &o.out);
     }},
    {"surface_cone",
     [](const Inputs &, Output &o) {
         return nurbs_surface_cone(nullptr, nullptr, nullptr, 1, 0, 2, 0, 3, 0, &o.out);
     }},
    {"surface_torus",
     [](const Inputs &, Output &o) {
         return nurbs_surface_torus(nullptr, nullptr, nullptr, 3, 1, 0, 3, 0, 6, 2, &o.out);
     }},
    {"surface_paraboloid",
     [](const Inputs &, Output &o) {
         return nurbs_surface_paraboloid(nullptr, nullptr, nullptr, 3, 1, 1, 0, 3, 0, &o.out);
     }},
    {"surface_saddle",
     [](const Inputs &, Output &o) {
         return nurbs_surface_saddle(nullptr, nullptr, nullptr, 3, 1, 1, &o.out);
     }},
    {"surface_hyperboloid",
     [](const Inputs &, Output &o) {
         return nurbs_surface_hyperboloid(nullptr, nullptr, nullptr, 3, 1, 1, -9, 9, 0, 3, 0, 0, &o.out);
     }},
    {"line", [](const Inputs &, Output &o) { return nurbs_curve_line(2, params, params + 2, &o.out); }},
    {"arc", arc},
    {"arc_tangent", arc_tangent},
    {"ellipse", ellipse},
    {"parabola", parabola},
    {"conic_triangle", conic_triangle},
    {"conic_point", conic_point},
};

} // namespace

std::span<const Call> shape_calls() {
    return group;
}

} // namespace calls
