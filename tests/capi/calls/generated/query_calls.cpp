/* SPDX-License-Identifier: MIT */
// Generated from tests/capi/calls/*.toml and include/nurbs/nurbs.h by: python3 cmake/interface/generate.py . - do not edit.
// clang-format off
#include "calls/calls.h"

namespace calls {

namespace {

const Call group[] = {
    {"deviation",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_deviation(in.surface, in.surface, o.values, o.values + 1);
     }},
    {"curve_shape_factor",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_curve_shape_factor(in.segment, o.values, o.states);
     }},
    {"conic_axes",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double coefficients[] = {1, 0, 4, 0, 0, -4};
         return nurbs_conic_axes(coefficients, o.states, o.values, o.values + 2, o.values + 4);
     }},
    {"box",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_box(in.volume, nullptr, 0.001, o.values, o.values + 4, o.values + 8);
     }},
    {"box of a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double range[] = {0, 1, 0, 3};
         return nurbs_box(in.surface, range, 0.001, o.values, o.values + 3, o.values + 6);
     }},
    {"oriented_box",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_oriented_box(in.surface, 0.001, o.values, o.values + 3, o.values + 12);
     }},
    {"tangent_cone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_tangent_cone(in.segment, 0, nullptr, 0.1, o.values, o.values + 2);
     }},
    {"tangent_cone of a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_tangent_cone(in.curve, 0, arrays::new_knots, 0.1, o.values, o.values + 2);
     }},
    {"normal_cone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_normal_cone(in.surface, nullptr, 0.1, o.values, o.values + 3);
     }},
    {"normal_cone of a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double range[] = {0, 1, 0, 3};
         return nurbs_normal_cone(in.surface, range, 0.1, o.values, o.values + 3);
     }},
    {"extreme_point",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double direction[] = {0.1, 0.9};
         return nurbs_extreme_point(in.curve, direction, nullptr, 1e-06, o.values, o.values + 1, o.values + 2);
     }},
    {"extreme_point of a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double direction[] = {0.1, 0.9};
         return nurbs_extreme_point(in.curve, direction, arrays::new_knots, 1e-06, o.values, o.values + 1,
             o.values + 2);
     }},
    {"closest_points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.1, 0.9};
         return nurbs_closest_points(in.curve, 1, points, 0, 0, nullptr, 0, 0, o.values, 0, 0, o.values + 1, 0,
             0, o.values + 3, 0, o.states, 0);
     }},
    {"closest_adjoint",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.1, 0.9};
         static constexpr double params[] = {0.3};
         static constexpr double param_cotangents[] = {1};
         static constexpr double foot_cotangents[] = {1, 2};
         static constexpr double distance_cotangents[] = {1};
         return nurbs_closest_adjoint(in.curve, 1, points, params, param_cotangents, foot_cotangents,
             distance_cotangents, o.values, o.values + 18, o.values + 27, o.states, 0);
     }},
    {"closest_points of a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double range[] = {0, 1, 0, 3};
         return nurbs_closest_points(in.surface, 2, arrays::params, 0, 0, range, 0, 0, o.values, 0, 0, o.values
             + 4, 0, 0, o.values + 10, 0, o.states, 0);
     }},
    {"farthest_points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.1, 0.9};
         return nurbs_farthest_points(in.curve, 1, points, 0, 0, nullptr, 0, 0, o.values, 0, 0, o.values + 1,
             0, 0, o.values + 3, 0, o.states, 0);
     }},
    {"farthest_points of a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_farthest_points(in.curve, 3, arrays::params, 0, 0, arrays::new_knots, 0, 0, o.values, 0,
             0, o.values + 3, 0, 0, o.values + 9, 0, o.states, 0);
     }},
    {"closest_local",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double guesses[] = {0.1, 0.9, 0.3};
         return nurbs_closest_local(in.curve, 3, arrays::params, 0, 0, guesses, 0, 0, o.values, 0, 0, o.values
             + 3, 0, 0, o.values + 9, 0, o.states, 0);
     }},
    {"closest_local params",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.1, 0.9};
         static constexpr double guesses[] = {0.1};
         return nurbs_closest_local(in.curve, 1, points, 0, 0, guesses, 0, 0, o.values, 0, 0, nullptr, 0, 0,
             nullptr, 0, nullptr, 0);
     }},
    {"curve_signed_distances",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_curve_signed_distances(in.curve, 3, arrays::params, 0, 0, 0, 0, o.values, 0, o.values +
             3, 0, o.states, 0);
     }},
    {"curve_signed_distances alone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.1, 0.9};
         return nurbs_curve_signed_distances(in.curve, 1, points, 0, 0, 0, 0, o.values, 0, nullptr, 0, nullptr,
             0);
     }},
    {"closest_all",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double point[] = {0.1, 0.9};
         return nurbs_closest_all(in.curve, point, nullptr, 0, 0, 8, o.values, o.values + 8, o.spans,
             o.states);
     }, true},
    {"closest_all inside",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double point[] = {0.1, 0.9};
         static constexpr double range[] = {0, 1};
         return nurbs_closest_all(in.curve, point, range, 0, 0, 8, o.values, o.values + 8, o.spans, o.states);
     }, true},
    {"critical_points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double point[] = {0.1, 0.9};
         return nurbs_critical_points(in.curve, point, nullptr, 0, 0, 8, o.values, o.values + 8, o.states,
             o.spans, o.states + 8);
     }, true},
    {"critical_points inside",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double point[] = {0.1, 0.9};
         static constexpr double range[] = {0, 1};
         return nurbs_critical_points(in.curve, point, range, 0, 0, 8, o.values, o.values + 8, o.states,
             o.spans, o.states + 8);
     }, true},
    {"distance",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_distance(in.curve, in.loop, 1e-06, 0, o.values, o.values + 1, o.values + 2, o.values + 3,
             o.states);
     }},
    {"hausdorff_distance",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_hausdorff_distance(in.curve, in.loop, 0.1, 0, o.values, o.values + 2, o.values + 4,
             o.values + 5, o.states);
     }},
    {"curve_features count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_curve_features(in.twist, 127, 0, nullptr, nullptr, nullptr, o.spans, o.states);
     }},
    {"curve_features periodic",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_curve_features(in.loop, 63, 16, o.values, o.states, o.values + 16, o.spans, o.states +
             16);
     }, true},
    {"extrema",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_heights(in, make_heights);
         if (made_heights.status() != NURBS_OK) {
             return made_heights.status();
         }
         return nurbs_extrema(made_heights, 31, 4, o.values, o.values + 8, o.states, o.values + 12, o.spans,
             o.states + 4);
     }, true},
    {"extrema count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_ramp(in, make_ramp);
         if (made_ramp.status() != NURBS_OK) {
             return made_ramp.status();
         }
         return nurbs_extrema(made_ramp, 3, 0, nullptr, nullptr, nullptr, nullptr, o.spans, o.states);
     }, true},
    {"mesh_curve",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_curve(in.curve, 1, 2, 3, 16, o.values, o.values + 16, o.values + 48, o.states,
             o.spans);
     }, true},
    {"mesh_curve count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_curve(in.loop, 0.5, 0, 0, 0, nullptr, nullptr, o.values, o.states, o.spans);
     }, true},
    {"curve_monotone_pieces",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double direction[] = {0.1, 0.9};
         return nurbs_curve_monotone_pieces(in.curve, direction, 16, o.values, o.states, o.spans, o.states +
             16);
     }},
    {"curve_convexity",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_curve_convexity(in.curve, o.states);
     }},
    {"straightness",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_straightness(in.segment, o.values, o.values + 2, o.values + 4);
     }},
    {"planarity",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_planarity(in.surface, o.values, o.values + 3, o.values + 6);
     }},
    {"boundary_contacts",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_boundary_contacts(in.surface, 0.1, o.states, o.values, o.states + 2, o.values + 2);
     }},
    {"singular_points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_singular_points(in.surface, 0.1, 8, o.values, o.values + 16, o.spans, o.states);
     }},
    {"fold_test",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_fold_test(in.surface, nullptr, o.states, o.values, o.values + 2);
     }},
    {"fold_pieces",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_fold_pieces(in.surface, nullptr, 4, o.states, o.states + 4, o.spans);
     }},
    {"roots",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_ramp(in, make_ramp);
         if (made_ramp.status() != NURBS_OK) {
             return made_ramp.status();
         }
         return nurbs_roots(made_ramp, 0.5, 0, 4, o.values, o.states, o.values + 4, o.spans, o.states + 4);
     }},
    {"roots count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_round(in, make_round);
         if (made_round.status() != NURBS_OK) {
             return made_round.status();
         }
         return nurbs_roots(made_round, 3, 1e-09, 0, nullptr, nullptr, nullptr, o.spans, o.states);
     }},
    {"curve_level",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double coefficients[] = {0.1, 0.9, -0.3};
         return nurbs_curve_level(in.curve, 1, coefficients, 1e-09, 16, o.values, o.states, o.values + 16,
             o.spans, o.states + 16);
     }, true},
    {"surface_rays",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origins[] = {0.1, 0.2, 5, 0.3, 0.4, 6};
         static constexpr double directions[] = {0, 0, -1, 0.1, 0.1, -1};
         return nurbs_surface_rays(in.surface, 2, origins, 0, 0, directions, 0, 0, o.values, o.values + 4,
             o.states);
     }},
    {"surface_rays distances",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origins[] = {0.1, 0.2, 5};
         static constexpr double directions[] = {0, 0, -1};
         return nurbs_surface_rays(in.surface, 1, origins, 0, 0, directions, 0, 0, nullptr, o.values, nullptr);
     }},
    {"surface_ray_hits within",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origin[] = {0.1, 0.2, 5};
         static constexpr double direction[] = {0, 0, -1};
         static constexpr double range[] = {-1, 20};
         return nurbs_surface_ray_hits(in.surface, origin, direction, range, 8, o.values, o.values + 16,
             o.states, o.spans, o.states + 8);
     }, true},
    {"surface_ray_hits",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origin[] = {0.1, 0.2, 5};
         static constexpr double direction[] = {0, 0, -1};
         return nurbs_surface_ray_hits(in.surface, origin, direction, nullptr, 8, o.values, o.values + 16,
             o.states, o.spans, o.states + 8);
     }, true},
    {"surfaces_common_points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_wall(in, make_wall);
         if (made_wall.status() != NURBS_OK) {
             return made_wall.status();
         }
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         return nurbs_surfaces_common_points(made_wall, in.surface, made_sphere, 0.001, 8, o.values, o.values +
             48, o.states, o.values + 72, o.spans, o.states + 8);
     }, true},
    {"curve_surface_intersections",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         return nurbs_curve_surface_intersections(in.twist, made_sphere, 1e-09, 16, o.values, o.values + 16,
             o.states, o.values + 48, o.values + 80, o.spans, o.states + 16);
     }, true},
    {"face_rays",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origins[] = {0.5, 1.2, 9, 0.3, 0.4, 6};
         static constexpr double directions[] = {0, 0, -1, 0.1, 0.1, -1};
         return nurbs_face_rays(in.face, 2, origins, 0, 0, directions, 0, 0, o.values, o.values + 4, o.states);
     }},
    {"face_rays distances",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origins[] = {0.5, 1.2, 9};
         static constexpr double directions[] = {0, 0, -1};
         return nurbs_face_rays(in.face, 1, origins, 0, 0, directions, 0, 0, nullptr, o.values, nullptr);
     }},
    {"face_closest_points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.5, 1.2, 9, 0.3, 0.4, 6};
         return nurbs_face_closest_points(in.face, 2, points, 0, 0, 1e-06, o.values, o.values + 4, o.values +
             10, o.states);
     }},
    {"face_closest_points alone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.1, 0.2, 0.3};
         return nurbs_face_closest_points(in.face, 1, points, 0, 0, 0, nullptr, nullptr, o.values, nullptr);
     }},
    {"face_distance",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         return nurbs_face_distance(in.face, made_ball_face, 4, o.values, o.values + 1, o.values + 2, o.values
             + 4, o.states);
     }},
    {"face_hausdorff_distance",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         return nurbs_face_hausdorff_distance(in.face, made_ball_face, 4, o.values, o.values + 2, o.values + 4,
             o.values + 6, o.states);
     }},
    {"model_instances",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_instances(in.model, 2, o.spans, o.spans + 2, o.spans + 4, o.values, o.spans + 6);
     }, true},
    {"model_rays",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origins[] = {0.5, 1.2, 9, 0.3, 0.4, 6};
         static constexpr double directions[] = {0, 0, -1, 0.1, 0.1, -1};
         return nurbs_model_rays(in.model, 2, origins, directions, o.values, o.values + 4, o.states, o.spans);
     }},
    {"model_rays places",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         static constexpr double origins[] = {0.1, 0.2, 5};
         static constexpr double directions[] = {0, 0, -1};
         return nurbs_model_rays(made_ball, 1, origins, directions, nullptr, o.values, nullptr, o.spans);
     }},
    {"model_ray_hits within",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origin[] = {0.5, 1.2, 9};
         static constexpr double direction[] = {0, 0, -1};
         static constexpr double range[] = {-1, 20};
         return nurbs_model_ray_hits(in.model, origin, direction, range, 8, o.values, o.values + 16, o.states,
             o.spans, o.spans + 16, o.states + 8);
     }, true},
    {"model_ray_hits",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         static constexpr double origin[] = {0.1, 0.2, 5};
         static constexpr double direction[] = {0, 0, -1};
         return nurbs_model_ray_hits(made_ball, origin, direction, nullptr, 8, o.values, o.values + 16,
             o.states, o.spans, o.spans + 16, o.states + 8);
     }, true},
    {"model_closest_points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.5, 1.2, 9, 0.3, 0.4, 6};
         return nurbs_model_closest_points(in.model, 2, points, 0, 0, 1e-06, o.values, o.values + 4, o.values +
             10, o.states, o.spans);
     }},
    {"model_closest_points alone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         static constexpr double points[] = {0.1, 0.2, 3};
         return nurbs_model_closest_points(made_ball, 1, points, 0, 0, 0, nullptr, nullptr, o.values, nullptr,
             o.spans);
     }},
    {"model_classify",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         static constexpr double points[] = {0.1, 0.2, 0.3, 1, 1, 1};
         return nurbs_model_classify(made_ball, 2, points, 0, 0, 0, o.states);
     }},
    {"model_classify near",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         static constexpr double points[] = {0.1, 0.2, 0.3, 0, 0.6, 0.8};
         return nurbs_model_classify(made_ball, 2, points, 0, 0, 0.001, o.states);
     }},
    {"model_area",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         return nurbs_model_area(made_ball, 1e-06, o.values, o.values + 1);
     }},
    {"model_volume",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         return nurbs_model_volume(made_ball, 1e-06, o.values, o.values + 1, o.values + 4, o.values + 13,
             o.values + 14);
     }},
    {"model_volume alone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         return nurbs_model_volume(made_ball, 1e-06, o.values, nullptr, nullptr, nullptr, o.values + 1);
     }},
    {"curve_self_intersections",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_curve_self_intersections(in.curve, 1e-09, 16, o.values, o.values + 16, o.states, o.values
             + 32, o.values + 64, o.spans, o.states + 16);
     }, true},
    {"curve_intersections",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_curve_intersections(in.curve, in.segment, 1e-09, 16, o.values, o.values + 16, o.states,
             o.values + 32, o.values + 64, o.spans, o.states + 16);
     }, true},
    {"curve_level conic",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double coefficients[] = {1, 0, 0, 1, 0, -0.5};
         return nurbs_curve_level(in.loop, 2, coefficients, 0, 16, o.values, o.states, o.values + 16, o.spans,
             o.states + 16);
     }, true},
    {"fold_test seen from above",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_fold_test(in.surface, arrays::center, o.states, o.values, o.values + 2);
     }},
    {"fold_pieces seen from above",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_fold_pieces(in.surface, arrays::center, 4, o.states, o.states + 4, o.spans);
     }},
    {"recognize curve",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_recognize(in.curve, 1e-09, o.states, o.values, o.values + 9, o.values + 12);
     }},
    {"recognize surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_recognize(in.surface, 0.2, o.states, o.values, o.values + 9, o.values + 12);
     }},
    {"length_adjoint",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_length_adjoint(in.curve, nullptr, 1e-06, 1, o.values, 0, 0, o.values + 18, 0, o.values +
             27, 0);
     }},
    {"length_adjoint of a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_length_adjoint(in.curve, arrays::new_knots, 1e-06, 1, o.values, 0, 0, o.values + 18, 0,
             o.values + 27, 0);
     }},
    {"curve_length",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_curve_length(in.curve, nullptr, 1e-09, o.values, o.values + 1);
     }},
    {"curve_length of a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_curve_length(in.curve, arrays::new_knots, 1e-09, o.values, o.values + 1);
     }},
    {"curve_lengths",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double params[] = {4};
         return nurbs_curve_lengths(in.loop, 1, params, 0, 1e-09, o.values, 0);
     }},
    {"curve_params_at_lengths",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double lengths[] = {4};
         return nurbs_curve_params_at_lengths(in.curve, 1, lengths, 0, 1e-09, o.values, 0, 0);
     }},
    {"curve_divide",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_curve_divide(in.curve, nullptr, 5, 1e-09, 0, o.values, o.values + 6);
     }},
    {"curve_divide a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_curve_divide(in.curve, arrays::new_knots, 5, 1e-09, 0, o.values, o.values + 6);
     }},
    {"curve_divide chords",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_curve_divide(in.curve, nullptr, 5, 1e-09, NURBS_EQUAL_CHORDS, o.values, o.values + 6);
     }},
    {"surface_area",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_surface_area(in.surface, nullptr, 1e-09, o.values, o.values + 1);
     }},
    {"surface_area of a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double range[] = {0, 1, 0, 3};
         return nurbs_surface_area(in.surface, range, 1e-09, o.values, o.values + 1);
     }},
    {"moments",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_moments(in.surface, 1e-09, o.values, o.values + 1, o.values + 4, o.values + 13);
     }},
    {"enclosed_area",
     [](const Inputs &in, Output &o) -> nurbs_status {
         const nurbs *const curves[] = {in.loop};
         return nurbs_enclosed_area(1, curves, 1e-09, 1e-09, o.values, o.values + 1, o.values + 3, o.values +
             7);
     }},
    {"enclosed_volume",
     [](const Inputs &in, Output &o) -> nurbs_status {
         const nurbs *const surfaces[] = {in.surface};
         return nurbs_enclosed_volume(1, surfaces, 1e-09, o.values, nullptr, nullptr, o.values + 1, o.values +
             2);
     }},
    {"enclosed_volume sphere",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         const nurbs *const surfaces[] = {made_sphere};
         return nurbs_enclosed_volume(1, surfaces, 1e-06, o.values, o.values + 1, o.values + 4, o.values + 13,
             o.values + 14);
     }},
    {"quadrature",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_quadrature(in.curve, 2, 64, o.values, o.values + 64, o.values + 128, o.spans);
     }},
    {"quadrature surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_quadrature(in.surface, 1, 24, o.values, o.values + 48, o.values + 72, o.spans);
     }},
    {"coons_gaps",
     [](const Inputs &in, Output &o) -> nurbs_status {
         const nurbs *const boundaries[] = {in.curve, in.curve, in.loop, in.loop};
         const nurbs *const cross[] = {in.curve, in.curve, in.loop, in.loop};
         return nurbs_coons_gaps(boundaries, cross, o.values, o.values + 4, o.values + 12);
     }},
    {"continuity",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_continuity(in.curve, 0, 0, 0, 0, 5, o.values, o.states, o.states + 5, o.states + 10,
             o.values + 5, o.values + 10, o.values + 15, o.spans);
     }},
    {"continuity count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_continuity(in.surface, 1, 0, 0, 0, 0, nullptr, nullptr, nullptr, nullptr, nullptr,
             nullptr, nullptr, o.spans);
     }},
    {"continuity_between",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_continuity_between(in.curve, NURBS_END, in.curve, NURBS_START, 0, 0, 0, o.states,
             o.states + 1, o.values, o.values + 1, o.values + 2);
     }},
    {"closest_points_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.1, 0.9};
         nurbs_closest_query query = {};
         query.struct_size = sizeof(nurbs_closest_query);
         query.n = 1;
         query.points = points;
         nurbs_closest_answer answer = {};
         answer.struct_size = sizeof(nurbs_closest_answer);
         answer.params = o.values;
         answer.feet = o.values + 1;
         answer.distances = o.values + 3;
         answer.status = o.states;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_closest_points_with(in.curve, &query, &answer, &call);
     }},
    {"closest_points_with of a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double range[] = {0, 1, 0, 3};
         nurbs_closest_query query = {};
         query.struct_size = sizeof(nurbs_closest_query);
         query.n = 2;
         query.points = arrays::params;
         query.range = range;
         nurbs_closest_answer answer = {};
         answer.struct_size = sizeof(nurbs_closest_answer);
         answer.params = o.values;
         answer.feet = o.values + 4;
         answer.distances = o.values + 10;
         answer.status = o.states;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_closest_points_with(in.surface, &query, &answer, &call);
     }},
    {"farthest_points_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.1, 0.9};
         nurbs_closest_query query = {};
         query.struct_size = sizeof(nurbs_closest_query);
         query.n = 1;
         query.points = points;
         nurbs_closest_answer answer = {};
         answer.struct_size = sizeof(nurbs_closest_answer);
         answer.params = o.values;
         answer.feet = o.values + 1;
         answer.distances = o.values + 3;
         answer.status = o.states;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_farthest_points_with(in.curve, &query, &answer, &call);
     }},
    {"farthest_points_with of a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_closest_query query = {};
         query.struct_size = sizeof(nurbs_closest_query);
         query.n = 3;
         query.points = arrays::params;
         query.range = arrays::new_knots;
         nurbs_closest_answer answer = {};
         answer.struct_size = sizeof(nurbs_closest_answer);
         answer.params = o.values;
         answer.feet = o.values + 3;
         answer.distances = o.values + 9;
         answer.status = o.states;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_farthest_points_with(in.curve, &query, &answer, &call);
     }},
    {"closest_local_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double guesses[] = {0.1, 0.9, 0.3};
         nurbs_closest_query query = {};
         query.struct_size = sizeof(nurbs_closest_query);
         query.n = 3;
         query.points = arrays::params;
         query.guesses = guesses;
         nurbs_closest_answer answer = {};
         answer.struct_size = sizeof(nurbs_closest_answer);
         answer.params = o.values;
         answer.feet = o.values + 3;
         answer.distances = o.values + 9;
         answer.status = o.states;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_closest_local_with(in.curve, &query, &answer, &call);
     }},
    {"closest_local_with params",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.1, 0.9};
         static constexpr double guesses[] = {0.1};
         nurbs_closest_query query = {};
         query.struct_size = sizeof(nurbs_closest_query);
         query.n = 1;
         query.points = points;
         query.guesses = guesses;
         nurbs_closest_answer answer = {};
         answer.struct_size = sizeof(nurbs_closest_answer);
         answer.params = o.values;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_closest_local_with(in.curve, &query, &answer, &call);
     }},
    {"curve_signed_distances_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_closest_query query = {};
         query.struct_size = sizeof(nurbs_closest_query);
         query.n = 3;
         query.points = arrays::params;
         nurbs_closest_answer answer = {};
         answer.struct_size = sizeof(nurbs_closest_answer);
         answer.params = o.values + 3;
         answer.distances = o.values;
         answer.status = o.states;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_signed_distances_with(in.curve, &query, &answer, &call);
     }},
    {"curve_signed_distances_with alone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.1, 0.9};
         nurbs_closest_query query = {};
         query.struct_size = sizeof(nurbs_closest_query);
         query.n = 1;
         query.points = points;
         nurbs_closest_answer answer = {};
         answer.struct_size = sizeof(nurbs_closest_answer);
         answer.distances = o.values;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_signed_distances_with(in.curve, &query, &answer, &call);
     }},
    {"closest_all_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double point[] = {0.1, 0.9};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_closest_all_with(in.curve, point, nullptr, 0, 0, 8, o.values, o.values + 8, o.spans,
             o.states, &call);
     }, true},
    {"closest_all_with inside",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double point[] = {0.1, 0.9};
         static constexpr double range[] = {0, 1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_closest_all_with(in.curve, point, range, 0, 0, 8, o.values, o.values + 8, o.spans,
             o.states, &call);
     }, true},
    {"critical_points_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double point[] = {0.1, 0.9};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_critical_points_with(in.curve, point, nullptr, 0, 0, 8, o.values, o.values + 8, o.states,
             o.spans, o.states + 8, &call);
     }, true},
    {"critical_points_with inside",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double point[] = {0.1, 0.9};
         static constexpr double range[] = {0, 1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_critical_points_with(in.curve, point, range, 0, 0, 8, o.values, o.values + 8, o.states,
             o.spans, o.states + 8, &call);
     }, true},
    {"distance_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_distance_with(in.curve, in.loop, 1e-06, 0, o.values, o.values + 1, o.values + 2, o.values
             + 3, o.states, &call);
     }},
    {"hausdorff_distance_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_hausdorff_distance_with(in.curve, in.loop, 0.1, 0, o.values, o.values + 2, o.values + 4,
             o.values + 5, o.states, &call);
     }},
    {"curve_features_with count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_features_with(in.twist, 127, 0, nullptr, nullptr, nullptr, o.spans, o.states,
             &call);
     }},
    {"curve_features_with periodic",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_features_with(in.loop, 63, 16, o.values, o.states, o.values + 16, o.spans, o.states
             + 16, &call);
     }, true},
    {"extrema_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_heights(in, make_heights);
         if (made_heights.status() != NURBS_OK) {
             return made_heights.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_extrema_with(made_heights, 31, 4, o.values, o.values + 8, o.states, o.values + 12,
             o.spans, o.states + 4, &call);
     }, true},
    {"extrema_with count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_ramp(in, make_ramp);
         if (made_ramp.status() != NURBS_OK) {
             return made_ramp.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_extrema_with(made_ramp, 3, 0, nullptr, nullptr, nullptr, nullptr, o.spans, o.states,
             &call);
     }, true},
    {"mesh_curve_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_curve_with(in.curve, 1, 2, 3, 16, o.values, o.values + 16, o.values + 48, o.states,
             o.spans, &call);
     }, true},
    {"mesh_curve_with count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_curve_with(in.loop, 0.5, 0, 0, 0, nullptr, nullptr, o.values, o.states, o.spans,
             &call);
     }, true},
    {"fold_test_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_fold_test_with(in.surface, nullptr, o.states, o.values, o.values + 2, &call);
     }},
    {"fold_pieces_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_fold_pieces_with(in.surface, nullptr, 4, o.states, o.states + 4, o.spans, &call);
     }},
    {"roots_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_ramp(in, make_ramp);
         if (made_ramp.status() != NURBS_OK) {
             return made_ramp.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_roots_with(made_ramp, 0.5, 0, 4, o.values, o.states, o.values + 4, o.spans, o.states + 4,
             &call);
     }},
    {"roots_with count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_round(in, make_round);
         if (made_round.status() != NURBS_OK) {
             return made_round.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_roots_with(made_round, 3, 1e-09, 0, nullptr, nullptr, nullptr, o.spans, o.states, &call);
     }},
    {"curve_level_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double coefficients[] = {0.1, 0.9, -0.3};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_level_with(in.curve, 1, coefficients, 1e-09, 16, o.values, o.states, o.values + 16,
             o.spans, o.states + 16, &call);
     }, true},
    {"surface_rays_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origins[] = {0.1, 0.2, 5, 0.3, 0.4, 6};
         static constexpr double directions[] = {0, 0, -1, 0.1, 0.1, -1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_rays_with(in.surface, 2, origins, 0, 0, directions, 0, 0, o.values, o.values + 4,
             o.states, &call);
     }},
    {"surface_rays_with distances",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origins[] = {0.1, 0.2, 5};
         static constexpr double directions[] = {0, 0, -1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_rays_with(in.surface, 1, origins, 0, 0, directions, 0, 0, nullptr, o.values,
             nullptr, &call);
     }},
    {"surfaces_common_points_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_wall(in, make_wall);
         if (made_wall.status() != NURBS_OK) {
             return made_wall.status();
         }
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surfaces_common_points_with(made_wall, in.surface, made_sphere, 0.001, 8, o.values,
             o.values + 48, o.states, o.values + 72, o.spans, o.states + 8, &call);
     }, true},
    {"curve_surface_intersections_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_surface_intersections_with(in.twist, made_sphere, 1e-09, 16, o.values, o.values +
             16, o.states, o.values + 48, o.values + 80, o.spans, o.states + 16, &call);
     }, true},
    {"face_rays_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origins[] = {0.5, 1.2, 9, 0.3, 0.4, 6};
         static constexpr double directions[] = {0, 0, -1, 0.1, 0.1, -1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_rays_with(in.face, 2, origins, 0, 0, directions, 0, 0, o.values, o.values + 4,
             o.states, &call);
     }},
    {"face_rays_with distances",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origins[] = {0.5, 1.2, 9};
         static constexpr double directions[] = {0, 0, -1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_rays_with(in.face, 1, origins, 0, 0, directions, 0, 0, nullptr, o.values, nullptr,
             &call);
     }},
    {"face_closest_points_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.5, 1.2, 9, 0.3, 0.4, 6};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_closest_points_with(in.face, 2, points, 0, 0, 1e-06, o.values, o.values + 4,
             o.values + 10, o.states, &call);
     }},
    {"face_closest_points_with alone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.1, 0.2, 0.3};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_closest_points_with(in.face, 1, points, 0, 0, 0, nullptr, nullptr, o.values,
             nullptr, &call);
     }},
    {"face_distance_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_distance_with(in.face, made_ball_face, 4, o.values, o.values + 1, o.values + 2,
             o.values + 4, o.states, &call);
     }},
    {"face_hausdorff_distance_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_hausdorff_distance_with(in.face, made_ball_face, 4, o.values, o.values + 2, o.values
             + 4, o.values + 6, o.states, &call);
     }},
    {"model_rays_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origins[] = {0.5, 1.2, 9, 0.3, 0.4, 6};
         static constexpr double directions[] = {0, 0, -1, 0.1, 0.1, -1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_rays_with(in.model, 2, origins, directions, o.values, o.values + 4, o.states,
             o.spans, &call);
     }},
    {"model_rays_with places",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         static constexpr double origins[] = {0.1, 0.2, 5};
         static constexpr double directions[] = {0, 0, -1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_rays_with(made_ball, 1, origins, directions, nullptr, o.values, nullptr, o.spans,
             &call);
     }},
    {"model_ray_hits_with within",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origin[] = {0.5, 1.2, 9};
         static constexpr double direction[] = {0, 0, -1};
         static constexpr double range[] = {-1, 20};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_ray_hits_with(in.model, origin, direction, range, 8, o.values, o.values + 16,
             o.states, o.spans, o.spans + 16, o.states + 8, &call);
     }, true},
    {"model_ray_hits_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         static constexpr double origin[] = {0.1, 0.2, 5};
         static constexpr double direction[] = {0, 0, -1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_ray_hits_with(made_ball, origin, direction, nullptr, 8, o.values, o.values + 16,
             o.states, o.spans, o.spans + 16, o.states + 8, &call);
     }, true},
    {"model_closest_points_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.5, 1.2, 9, 0.3, 0.4, 6};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_closest_points_with(in.model, 2, points, 0, 0, 1e-06, o.values, o.values + 4,
             o.values + 10, o.states, o.spans, &call);
     }},
    {"model_closest_points_with alone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         static constexpr double points[] = {0.1, 0.2, 3};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_closest_points_with(made_ball, 1, points, 0, 0, 0, nullptr, nullptr, o.values,
             nullptr, o.spans, &call);
     }},
    {"model_classify_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         static constexpr double points[] = {0.1, 0.2, 0.3, 1, 1, 1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_classify_with(made_ball, 2, points, 0, 0, 0, o.states, &call);
     }},
    {"model_classify_with near",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         static constexpr double points[] = {0.1, 0.2, 0.3, 0, 0.6, 0.8};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_classify_with(made_ball, 2, points, 0, 0, 0.001, o.states, &call);
     }},
    {"model_area_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_area_with(made_ball, 1e-06, o.values, o.values + 1, &call);
     }},
    {"model_volume_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_volume_with(made_ball, 1e-06, o.values, o.values + 1, o.values + 4, o.values + 13,
             o.values + 14, &call);
     }},
    {"model_volume_with alone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         Made made_ball(in, make_ball);
         if (made_ball.status() != NURBS_OK) {
             return made_ball.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_volume_with(made_ball, 1e-06, o.values, nullptr, nullptr, nullptr, o.values + 1,
             &call);
     }},
    {"curve_self_intersections_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_self_intersections_with(in.curve, 1e-09, 16, o.values, o.values + 16, o.states,
             o.values + 32, o.values + 64, o.spans, o.states + 16, &call);
     }, true},
    {"curve_intersections_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_intersections_with(in.curve, in.segment, 1e-09, 16, o.values, o.values + 16,
             o.states, o.values + 32, o.values + 64, o.spans, o.states + 16, &call);
     }, true},
    {"curve_level_with conic",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double coefficients[] = {1, 0, 0, 1, 0, -0.5};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_level_with(in.loop, 2, coefficients, 0, 16, o.values, o.states, o.values + 16,
             o.spans, o.states + 16, &call);
     }, true},
    {"fold_test_with seen from above",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_fold_test_with(in.surface, arrays::center, o.states, o.values, o.values + 2, &call);
     }},
    {"fold_pieces_with seen from above",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_fold_pieces_with(in.surface, arrays::center, 4, o.states, o.states + 4, o.spans, &call);
     }},
    {"recognize_with curve",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_recognize_with(in.curve, 1e-09, o.states, o.values, o.values + 9, o.values + 12, &call);
     }},
    {"recognize_with surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_recognize_with(in.surface, 0.2, o.states, o.values, o.values + 9, o.values + 12, &call);
     }},
    {"curve_length_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_length_with(in.curve, nullptr, 1e-09, o.values, o.values + 1, &call);
     }},
    {"curve_length_with of a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_length_with(in.curve, arrays::new_knots, 1e-09, o.values, o.values + 1, &call);
     }},
    {"curve_lengths_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double params[] = {4};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_lengths_with(in.loop, 1, params, 0, 1e-09, o.values, 0, &call);
     }},
    {"curve_params_at_lengths_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double lengths[] = {4};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_params_at_lengths_with(in.curve, 1, lengths, 0, 1e-09, o.values, 0, 0, &call);
     }},
    {"curve_divide_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_divide_with(in.curve, nullptr, 5, 1e-09, 0, o.values, o.values + 6, &call);
     }},
    {"curve_divide_with a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_divide_with(in.curve, arrays::new_knots, 5, 1e-09, 0, o.values, o.values + 6,
             &call);
     }},
    {"curve_divide_with chords",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_curve_divide_with(in.curve, nullptr, 5, 1e-09, NURBS_EQUAL_CHORDS, o.values, o.values +
             6, &call);
     }},
    {"surface_area_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_area_with(in.surface, nullptr, 1e-09, o.values, o.values + 1, &call);
     }},
    {"surface_area_with of a part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double range[] = {0, 1, 0, 3};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_area_with(in.surface, range, 1e-09, o.values, o.values + 1, &call);
     }},
    {"moments_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_moments_with(in.surface, 1e-09, o.values, o.values + 1, o.values + 4, o.values + 13,
             &call);
     }},
    {"enclosed_area_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         const nurbs *const curves[] = {in.loop};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_enclosed_area_with(1, curves, 1e-09, 1e-09, o.values, o.values + 1, o.values + 3,
             o.values + 7, &call);
     }},
    {"enclosed_volume_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         const nurbs *const surfaces[] = {in.surface};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_enclosed_volume_with(1, surfaces, 1e-09, o.values, nullptr, nullptr, o.values + 1,
             o.values + 2, &call);
     }},
    {"enclosed_volume_with sphere",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         const nurbs *const surfaces[] = {made_sphere};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_enclosed_volume_with(1, surfaces, 1e-06, o.values, o.values + 1, o.values + 4, o.values +
             13, o.values + 14, &call);
     }},
};

} // namespace

std::span<const Call> query_calls() {
    return group;
}

} // namespace calls
