/* SPDX-License-Identifier: MIT */
// Transformations, weights, constraints and deformations.
#include "calls/calls.h"

namespace calls {

namespace {

const Call group[] = {
    {"transform",
     [](const Inputs &in, Output &o) {
         static const double turn[] = {0, 1, -1, 0};
         return nurbs_transform(in.curve, 2, turn, turn, &o.out);
     }},
    {"transform_projective",
     [](const Inputs &in, Output &o) {
         static const double map[] = {1, 0, 0, 0, 1, 0, 0, 0, 2};
         return nurbs_transform_projective(in.curve, 2, map, &o.out);
     }},
    {"mirror", [](const Inputs &in, Output &o) { return nurbs_mirror(in.curve, params, params, &o.out); }},
    {"project_to_plane",
     [](const Inputs &in, Output &o) {
         return nurbs_project_to_plane(in.curve, params, params, nullptr, &o.out);
     }},
    {"project_from",
     [](const Inputs &in, Output &o) {
         return nurbs_project_from(in.curve, params + 2, params, params, &o.out);
     }},
    {"pull_weight",
     [](const Inputs &in, Output &o) {
         return nurbs_pull_weight(in.curve, 3, new_knots, 0.01, o.values, &o.out);
     }},
    {"pull_weights",
     [](const Inputs &in, Output &o) {
         static const int64_t both[] = {2, 3};
         return nurbs_pull_weights(in.curve, 2, both, new_knots, 0.01, o.values, &o.out);
     }},
    {"set_weights",
     [](const Inputs &in, Output &o) {
         static const int64_t both[] = {2, 3};
         return nurbs_set_weights(in.loop, 2, both, new_knots, &o.out);
     }},
    {"weight_through",
     [](const Inputs &in, Output &o) {
         static const double target[] = {0.75, 0.75}, at = 0.125;
         return nurbs_weight_through(in.curve, 1, &at, target, 1, o.values, &o.out);
     }},
    {"pull_point",
     [](const Inputs &in, Output &o) {
         return nurbs_pull_point(in.volume, 0, params, params, 1, o.values, &o.out);
     }},
    {"insert_on_leg", [](const Inputs &in,
                         Output &o) { return nurbs_insert_on_leg(in.segment, 0, 0, 0.5, o.values, &o.out); }},
    {"insert_at_point",
     [](const Inputs &in, Output &o) {
         static const double corner[] = {0, 1};
         return nurbs_insert_at_point(in.loop, 0, corner, 1, o.spans, o.values, o.values + 1, &o.out);
     }},
    {"constrain",
     [](const Inputs &in, Output &o) {
         static const int32_t keep[] = {0, 0};
         return nurbs_constrain(in.curve, 2, nullptr, nullptr, new_knots, params, keep, nullptr, nullptr, 0,
                                o.values, o.spans, o.values + 2, o.values + 3, &o.out);
     }},
    {"constrain directions",
     [](const Inputs &in, Output &o) {
         static const int32_t kinds[] = {NURBS_CONSTRAIN_NORMAL, NURBS_CONSTRAIN_VALUE};
         return nurbs_constrain(in.surface, 2, kinds, nullptr, params, params, nullptr, nullptr, nullptr, 0,
                                o.values, o.spans, o.values + 2, o.values + 3, &o.out);
     }},
    {"constrain curvature",
     [](const Inputs &in, Output &o) {
         static const int32_t kinds[] = {NURBS_CONSTRAIN_CURVATURE};
         static const double costs[] = {1, 1, 1, 1, 1, 1, 1, 1, 1}, target[] = {-1, 0.1};
         return nurbs_constrain(in.curve, 1, kinds, nullptr, params, target, nullptr, nullptr, costs, 1e-9,
                                o.values, o.spans, o.values + 2, o.values + 3, &o.out);
     }},
    {"warp",
     [](const Inputs &in, Output &o) { return nurbs_warp(in.curve, new_knots, params, 1, 1, &o.out); }},
    {"warp periodic",
     [](const Inputs &in, Output &o) { return nurbs_warp(in.loop, nullptr, params, 1, 1, &o.out); }},
    {"flatten",
     [](const Inputs &in, Output &o) {
         return nurbs_flatten(in.curve, new_knots, params, params, nullptr, o.values, &o.out);
     }},
    {"bend",
     [](const Inputs &in, Output &o) {
         static const double along[] = {1, 0, 0}, across[] = {0, 1, 0};
         return nurbs_bend(in.curve, params, along, across, 1, -9, 9, 0.1, o.values, o.states, &o.out);
     }},
    {"free_form_deform",
     [](const Inputs &in, Output &o) {
         static const double lower[] = {-1, -1}, upper[] = {1, 1};
         nurbs *square = nullptr;
         static const int32_t degrees[] = {1, 1};
         static const double points[] = {0, 0, 0, 1, 1, 0, 1, 2};
         nurbs_status status = nurbs_create_bezier(2, degrees, 2, points, 0, 0, nullptr, 0, &square);
         if (status == NURBS_OK) {
             status = nurbs_free_form_deform(in.curve, square, lower, upper, 0.1, o.values, o.states, &o.out);
         } else {
             o.out = nullptr;
         }
         nurbs_destroy(square);
         return status;
     }},
    {"fair", [](const Inputs &in,
                Output &o) { return nurbs_fair(in.curve, 2, nullptr, 1e3, o.values, o.values + 2, &o.out); }},
    {"fair surface",
     [](const Inputs &in, Output &o) {
         static const int32_t none[] = {-1, -1, -1, -1};
         return nurbs_fair(in.surface, 1, none, 1e3, o.values, o.values + 2, &o.out);
     }},
    {"snap_boundary",
     [](const Inputs &in, Output &o) {
         return nurbs_snap_boundary(in.curve, 0, NURBS_END, in.segment, 0, NURBS_START, 1, 0, o.values,
                                    &o.out);
     }},
    {"snap_boundary surface",
     [](const Inputs &in, Output &o) {
         return nurbs_snap_boundary(in.surface, 0, NURBS_END, in.surface, 1, NURBS_START, 1, NURBS_REVERSED,
                                    o.values, &o.out);
     }},
    {"normalize_weights",
     [](const Inputs &in, Output &o) { return nurbs_normalize_weights(in.homogeneous, &o.out); }},
    {"equalize_end_weights",
     [](const Inputs &in, Output &o) { return nurbs_equalize_end_weights(in.curve, 0, &o.out); }},
    {"make_rational", [](const Inputs &in, Output &o) { return nurbs_make_rational(in.loop, &o.out); }},
    {"to_homogeneous", [](const Inputs &in, Output &o) { return nurbs_to_homogeneous(in.curve, &o.out); }},
    {"from_homogeneous",
     [](const Inputs &in, Output &o) { return nurbs_from_homogeneous(in.volume, &o.out); }},
};

} // namespace

std::span<const Call> edit_calls() {
    return group;
}

} // namespace calls
