/* SPDX-License-Identifier: MIT */
// Calls that want every output and leave no input out, of the functions whose other calls do not.
#include "guarded/complete_calls.h"

#include "iges_text.h"

namespace calls {

namespace {

const double center[] = {1, 2, 3}, axis[] = {0, 1, 0}, side[] = {1, 0, 0};
const double unit[] = {0, 1}, square[] = {0, 1, 0, 3};

// The file of the other calls, in millimetres.
nurbs_read_options in_millimetres() {
    nurbs_read_options options;
    CHECK_OK(nurbs_read_options_init(&options, sizeof options));
    options.unit = 1e-3;
    return options;
}

nurbs_status coons_hermite(const Inputs &in, Output &o) {
    const nurbs *const curves[] = {in.twist, in.twist, in.twist, in.twist};
    return nurbs_surface_coons_hermite(curves, curves, NURBS_TWIST_GIVEN, cube().points, 99, o.values,
                                       &o.out);
}

nurbs_status collocation(const Inputs &, Output &o) {
    const SplineArgs a = trough();
    const int32_t orders[] = {0, 0};
    return nurbs_collocation(2, a.degrees, a.counts, a.knots, 12, orders, 3, params, 0, 0, 18, o.values,
                             o.spans, o.spans + 20, o.spans + 40, 0);
}

const Call made[] = {
    {"create_bezier",
     [](const Inputs &, Output &o) {
         return nurbs_create_bezier(1, arch().degrees, 2, arch().points, 0, 0, circle().weights, 0, &o.out);
     }},
    {"with_points",
     [](const Inputs &in, Output &o) {
         return nurbs_with_points(in.curve, circle().points, 0, 0, circle().weights, 0, &o.out);
     }},
    {"knots_bezier",
     [](const Inputs &, Output &o) { return nurbs_knots_bezier(2, 1, new_knots, 6, o.values); }},
    {"knots_periodic",
     [](const Inputs &, Output &o) {
         static const int32_t twice[] = {2, 2};
         return nurbs_knots_periodic(2, 2, new_knots, twice, 7, o.values);
     }},
    {"polyline", [](const Inputs &,
                    Output &o) { return nurbs_curve_polyline(2, 3, params, 0, 0, new_knots, 0, &o.out); }},
    {"polygon",
     [](const Inputs &, Output &o) { return nurbs_curve_polygon(3, center, axis, side, 1, 5, &o.out); }},
    {"rounded_rectangle",
     [](const Inputs &, Output &o) {
         return nurbs_curve_rounded_rectangle(3, center, axis, side, 3, 2, 0.5, &o.out);
     }},
    {"circle",
     [](const Inputs &, Output &o) {
         return nurbs_curve_circle(3, center, axis, side, 1, NURBS_ARC_SMOOTH, &o.out);
     }},
    {"arc",
     [](const Inputs &, Output &o) { return nurbs_curve_arc(3, center, axis, side, 1, 0, 4, 0, &o.out); }},
    {"ellipse", [](const Inputs &,
                   Output &o) { return nurbs_curve_ellipse(3, center, axis, side, 2, 1, 0, 4, 0, &o.out); }},
    {"parabola",
     [](const Inputs &, Output &o) { return nurbs_curve_parabola(3, center, axis, side, 1, -1, 2, &o.out); }},
    {"hyperbola", [](const Inputs &,
                     Output &o) { return nurbs_curve_hyperbola(3, center, axis, side, 1, 1, 0, 9, &o.out); }},
    {"conic_focus",
     [](const Inputs &, Output &o) {
         static const double foot[] = {2, 2, 3};
         return nurbs_curve_conic_focus(3, center, axis, foot, 0.5, 0, 6, 0, &o.out);
     }},
    {"helix",
     [](const Inputs &, Output &o) {
         return nurbs_curve_helix(3, center, axis, side, 1, 1, 1, 0, 1, 0.1, o.values, &o.out);
     }},
    {"revolve",
     [](const Inputs &in, Output &o) { return nurbs_revolve(in.twist, center, axis, 6, 0, &o.out); }},
    {"plane", [](const Inputs &, Output &o) { return nurbs_surface_plane(3, center, axis, side, &o.out); }},
    {"sphere",
     [](const Inputs &, Output &o) { return nurbs_surface_sphere(center, axis, side, 1, 2, &o.out); }},
    {"spherical_patch",
     [](const Inputs &, Output &o) {
         return nurbs_surface_spherical_patch(center, axis, side, 1, 0, 4, 0, 1, 0, &o.out);
     }},
    {"sphere_patches",
     [](const Inputs &, Output &o) {
         return nurbs_surface_sphere_patches(center, axis, side, 1, NURBS_HEMISPHERE, &o.list);
     }},
    {"ellipsoid", [](const Inputs &,
                     Output &o) { return nurbs_surface_ellipsoid(center, axis, side, 1, 2, 3, 1, &o.out); }},
    {"cylinder", [](const Inputs &,
                    Output &o) { return nurbs_surface_cylinder(center, axis, side, 1, 2, 0, 3, 0, &o.out); }},
    {"cone", [](const Inputs &,
                Output &o) { return nurbs_surface_cone(center, axis, side, 1, 0, 2, 0, 3, 0, &o.out); }},
    {"torus", [](const Inputs &,
                 Output &o) { return nurbs_surface_torus(center, axis, side, 3, 1, 0, 3, 0, 6, 2, &o.out); }},
    {"paraboloid",
     [](const Inputs &, Output &o) {
         return nurbs_surface_paraboloid(center, axis, side, 3, 1, 1, 0, 3, 0, &o.out);
     }},
    {"saddle",
     [](const Inputs &, Output &o) { return nurbs_surface_saddle(center, axis, side, 3, 1, 1, &o.out); }},
    {"hyperboloid",
     [](const Inputs &, Output &o) {
         return nurbs_surface_hyperboloid(center, axis, side, 3, 1, 1, -9, 9, 0, 3, 0, 0, &o.out);
     }},
    {"coons_hermite", coons_hermite},
    {"read",
     [](const Inputs &, Output &o) {
         const IgesText file = small_file();
         const nurbs_read_options options = in_millimetres();
         return nurbs_read(file.bytes, file.size, &options, &o.list);
     }},
    {"read_file",
     [](const Inputs &, Output &o) {
         const nurbs_read_options options = in_millimetres();
         return nurbs_read_file(file_path, &options, &o.list);
     }},
    {"project_to_plane",
     [](const Inputs &in, Output &o) {
         return nurbs_project_to_plane(in.curve, params, params, params, &o.out);
     }},
};

const Call changed[] = {
    {"join",
     [](const Inputs &in, Output &o) {
         const nurbs *parts[] = {in.curve, in.curve};
         return nurbs_join(2, parts, 0, 9, 0, o.values, &o.out);
     }},
    {"snap_knots",
     [](const Inputs &in, Output &o) { return nurbs_snap_knots(in.loop, 0, 0.26, o.values, &o.out); }},
    {"make_compatible",
     [](const Inputs &in, Output &o) {
         const nurbs *splines[] = {in.curve, in.loop};
         return nurbs_make_compatible(2, splines, 0.01, NURBS_MAP_DOMAINS, o.values, &o.list);
     }},
    {"make_periodic",
     [](const Inputs &in, Output &o) {
         return nurbs_make_periodic(in.curve, 0, 1, o.values, o.states, &o.out);
     }},
    {"remove_knot",
     [](const Inputs &in, Output &o) {
         return nurbs_remove_knot(in.curve, 0, 0.5, 1, 9, o.states, o.values, &o.out);
     }},
    {"reduce_knots",
     [](const Inputs &in, Output &o) { return nurbs_reduce_knots(in.curve, -1, 9, o.values, &o.out); }},
    {"reduce_degree",
     [](const Inputs &in, Output &o) { return nurbs_reduce_degree(in.loop, 0, 1, o.values, &o.out); }},
    {"simplify", [](const Inputs &in, Output &o) { return nurbs_simplify(in.curve, 9, o.values, &o.out); }},
    {"constrain",
     [](const Inputs &in, Output &o) {
         static const int32_t kinds[] = {NURBS_CONSTRAIN_VALUE, NURBS_CONSTRAIN_VALUE}, orders[] = {0, 1},
                              keep[] = {0, 0};
         static const double costs[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
         return nurbs_constrain(in.curve, 2, kinds, orders, new_knots, params, keep, costs, costs, 1e-6,
                                o.values, o.spans, o.values + 2, o.values + 3, &o.out);
     }},
    {"flatten",
     [](const Inputs &in, Output &o) {
         return nurbs_flatten(in.curve, new_knots, params, params, params, o.values, &o.out);
     }},
};

const Call asked[] = {
    {"distinct_knots",
     [](const Inputs &in, Output &o) {
         return nurbs_distinct_knots(in.curve, 0, 5, o.values, o.states, o.spans);
     }},
    {"to_hermite",
     [](const Inputs &in, Output &o) {
         return nurbs_to_hermite(in.twist, 2, o.values, o.values + 2, o.values + 8, o.spans);
     }},
    {"to_power",
     [](const Inputs &in, Output &o) {
         return nurbs_to_power(in.surface, 54, o.values, o.values + 64, o.spans, o.spans + 2);
     }},
    {"bezier_extraction",
     [](const Inputs &in, Output &o) {
         return nurbs_bezier_extraction(in.curve, 0, 4, o.values, o.spans + 1, o.values + 36, o.spans);
     }},
    {"refinement_matrix",
     [](const Inputs &in, Output &o) {
         return nurbs_refinement_matrix(in.curve, 0, 2, new_knots, 33, o.values, o.spans, o.spans + 33,
                                        o.spans + 46);
     }},
    {"collocation", collocation},
    {"rational_collocation",
     [](const Inputs &in, Output &o) {
         const int32_t order = 0;
         return nurbs_rational_collocation(in.curve, &order, 6, params, 0, 0, 18, o.values, o.spans,
                                           o.spans + 20, o.spans + 30, 0);
     }},
    {"continuity",
     [](const Inputs &in, Output &o) {
         return nurbs_continuity(in.curve, 0, 0, 0, 0, 5, o.values, o.states, o.states + 5, o.states + 10,
                                 o.values + 5, o.values + 10, o.values + 15, o.spans);
     }},
    {"continuity_between",
     [](const Inputs &in, Output &o) {
         return nurbs_continuity_between(in.curve, NURBS_END, in.curve, NURBS_START, 0, 0, 0, o.states,
                                         o.states + 1, o.values, o.values + 1, o.values + 2);
     }},
    {"surface_eval_grid_frames",
     [](const Inputs &in, Output &o) {
         static const int64_t counts[] = {2, 2};
         return nurbs_surface_eval_grid_frames(in.surface, counts, params, o.values, 0, 0, o.values + 12, 0,
                                               0, o.values + 24, 0, 0, o.values + 36, 0, 0, o.states, 0);
     }},
    {"curve_eval_frames",
     [](const Inputs &in, Output &o) {
         return nurbs_curve_eval_frames(in.twist, 6, params, 0, o.values, 0, 0, o.values + 18, 0, 0,
                                        o.values + 36, 0, 0, o.values + 54, 0, 0, o.values + 72, 0,
                                        o.values + 78, 0, o.states, 0);
     }},
    {"closest_points",
     [](const Inputs &in, Output &o) {
         return nurbs_closest_points(in.surface, 2, params, 0, 0, square, 0, 0, o.values, 0, 0, o.values + 4,
                                     0, 0, o.values + 10, 0, o.states, 0);
     }},
    {"farthest_points",
     [](const Inputs &in, Output &o) {
         return nurbs_farthest_points(in.curve, 3, params, 0, 0, new_knots, 0, 0, o.values, 0, 0,
                                      o.values + 3, 0, 0, o.values + 9, 0, o.states, 0);
     }},
    {"closest_local",
     [](const Inputs &in, Output &o) {
         return nurbs_closest_local(in.curve, 3, params, 0, 0, params, 0, 0, o.values, 0, 0, o.values + 3, 0,
                                    0, o.values + 9, 0, o.states, 0);
     }},
    {"closest_all",
     [](const Inputs &in, Output &o) {
         return nurbs_closest_all(in.curve, params, unit, 0, 0, 8, o.values, o.values + 8, o.spans, o.states);
     }},
    {"critical_points",
     [](const Inputs &in, Output &o) {
         return nurbs_critical_points(in.curve, params, unit, 0, 0, 8, o.values, o.values + 8, o.states,
                                      o.spans, o.states + 8);
     }},
    {"curve_signed_distances",
     [](const Inputs &in, Output &o) {
         return nurbs_curve_signed_distances(in.curve, 3, params, 0, 0, 0, 0, o.values, 0, o.values + 3, 0,
                                             o.states, 0);
     }},
    {"curve_length",
     [](const Inputs &in, Output &o) {
         return nurbs_curve_length(in.curve, new_knots, 1e-9, o.values, o.values + 1);
     }},
    {"curve_divide",
     [](const Inputs &in, Output &o) {
         return nurbs_curve_divide(in.curve, new_knots, 5, 1e-9, 0, o.values, o.values + 6);
     }},
    {"surface_area",
     [](const Inputs &in, Output &o) {
         return nurbs_surface_area(in.surface, square, 1e-9, o.values, o.values + 1);
     }},
    {"enclosed_area",
     [](const Inputs &in, Output &o) {
         const nurbs *curves[] = {in.loop};
         return nurbs_enclosed_area(1, curves, 1e-9, 1e-9, o.values, o.values + 1, o.values + 3,
                                    o.values + 7);
     }},
    {"enclosed_volume",
     [](const Inputs &, Output &o) {
         nurbs *sphere = nullptr;
         CHECK_OK(nurbs_surface_sphere(nullptr, nullptr, nullptr, 1, 0, &sphere));
         const nurbs *surfaces[] = {sphere};
         const nurbs_status status = nurbs_enclosed_volume(1, surfaces, 1e-6, o.values, o.values + 1,
                                                           o.values + 4, o.values + 13, o.values + 14);
         nurbs_destroy(sphere);
         return status;
     }},
    {"box",
     [](const Inputs &in, Output &o) {
         return nurbs_box(in.surface, square, 1e-3, o.values, o.values + 3, o.values + 6);
     }},
    {"tangent_cone",
     [](const Inputs &in, Output &o) {
         return nurbs_tangent_cone(in.curve, 0, new_knots, 0.1, o.values, o.values + 2);
     }},
    {"normal_cone",
     [](const Inputs &in, Output &o) {
         return nurbs_normal_cone(in.surface, square, 0.1, o.values, o.values + 3);
     }},
    {"extreme_point",
     [](const Inputs &in, Output &o) {
         return nurbs_extreme_point(in.curve, params, new_knots, 1e-6, o.values, o.values + 1, o.values + 2);
     }},
    {"curve_monotone_pieces",
     [](const Inputs &in, Output &o) {
         return nurbs_curve_monotone_pieces(in.curve, params, 16, o.values, o.states, o.spans, o.states + 16);
     }},
    {"singular_points",
     [](const Inputs &in, Output &o) {
         return nurbs_singular_points(in.surface, 0.1, 8, o.values, o.values + 16, o.spans, o.states);
     }},
    {"fold_test",
     [](const Inputs &in, Output &o) {
         return nurbs_fold_test(in.surface, center, o.states, o.values, o.values + 2);
     }},
};

} // namespace

std::vector<std::span<const Call>> complete_calls() {
    return {made, changed, asked};
}

} // namespace calls
