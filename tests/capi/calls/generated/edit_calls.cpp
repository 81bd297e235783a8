/* SPDX-License-Identifier: MIT */
// Generated from tests/capi/calls/*.toml and include/nurbs/nurbs.h by: python3 cmake/interface/generate.py . - do not edit.
// clang-format off
#include "calls/calls.h"

namespace calls {

namespace {

const Call group[] = {
    {"transform",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double matrix[] = {0, 1, -1, 0};
         static constexpr double translation[] = {0, 1};
         return nurbs_transform(in.curve, 2, matrix, translation, &o.out);
     }},
    {"transform_projective",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double matrix[] = {1, 0, 0, 0, 1, 0, 0, 0, 2};
         return nurbs_transform_projective(in.curve, 2, matrix, &o.out);
     }},
    {"mirror",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double point[] = {0.1, 0.9};
         static constexpr double normal[] = {0.1, 0.9};
         return nurbs_mirror(in.curve, point, normal, &o.out);
     }},
    {"project_to_plane",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double point[] = {0.1, 0.9};
         static constexpr double normal[] = {0.1, 0.9};
         return nurbs_project_to_plane(in.curve, point, normal, nullptr, &o.out);
     }},
    {"project_to_plane along",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double point[] = {0.1, 0.9};
         static constexpr double normal[] = {0.1, 0.9};
         static constexpr double direction[] = {0.1, 0.9};
         return nurbs_project_to_plane(in.curve, point, normal, direction, &o.out);
     }},
    {"project_from",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double eye[] = {0.3, 0.7};
         static constexpr double point[] = {0.1, 0.9};
         static constexpr double normal[] = {0.1, 0.9};
         return nurbs_project_from(in.curve, eye, point, normal, &o.out);
     }},
    {"make_rational",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_make_rational(in.loop, &o.out);
     }},
    {"to_homogeneous",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_to_homogeneous(in.curve, &o.out);
     }},
    {"from_homogeneous",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_from_homogeneous(in.volume, &o.out);
     }},
    {"normalize_weights",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_normalize_weights(in.homogeneous, &o.out);
     }},
    {"equalize_end_weights",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_equalize_end_weights(in.curve, 0, &o.out);
     }},
    {"pull_weight",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double params[] = {0.3};
         return nurbs_pull_weight(in.curve, 3, params, 0.01, o.values, &o.out);
     }},
    {"pull_weights",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int64_t indices[] = {2, 3};
         static constexpr double params[] = {0.3};
         return nurbs_pull_weights(in.curve, 2, indices, params, 0.01, o.values, &o.out);
     }},
    {"set_weights",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int64_t indices[] = {2, 3};
         return nurbs_set_weights(in.loop, 2, indices, arrays::new_knots, &o.out);
     }},
    {"weight_through",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double params[] = {0.125};
         static constexpr double target[] = {0.75, 0.75};
         return nurbs_weight_through(in.curve, 1, params, target, 1, o.values, &o.out);
     }},
    {"pull_point",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double params[] = {0.1, 0.9, 0.3};
         static constexpr double direction[] = {0.1, 0.9, 0.3, 0.7};
         return nurbs_pull_point(in.volume, 0, params, direction, 1, o.values, &o.out);
     }},
    {"insert_on_leg",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_insert_on_leg(in.segment, 0, 0, 0.5, o.values, &o.out);
     }},
    {"insert_at_point",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double point[] = {0, 1};
         return nurbs_insert_at_point(in.loop, 0, point, 1, o.spans, o.values, o.values + 1, &o.out);
     }},
    {"constrain",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double targets[] = {0.1, 0.9, 0.3, 0.7};
         static constexpr int32_t keep[] = {0, 0};
         return nurbs_constrain(in.curve, 2, nullptr, nullptr, arrays::new_knots, targets, keep, nullptr,
             nullptr, 0, o.values, o.spans, o.values + 2, o.values + 3, &o.out);
     }},
    {"warp",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double direction[] = {0.1, 0.9};
         return nurbs_warp(in.curve, arrays::new_knots, direction, 1, 1, &o.out);
     }},
    {"warp periodic",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double direction[] = {0.1, 0.9};
         return nurbs_warp(in.loop, nullptr, direction, 1, 1, &o.out);
     }},
    {"flatten",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double point[] = {0.1, 0.9};
         static constexpr double normal[] = {0.1, 0.9};
         return nurbs_flatten(in.curve, arrays::new_knots, point, normal, nullptr, o.values, &o.out);
     }},
    {"flatten along",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double point[] = {0.1, 0.9};
         static constexpr double normal[] = {0.1, 0.9};
         static constexpr double direction[] = {0.1, 0.9};
         return nurbs_flatten(in.curve, arrays::new_knots, point, normal, direction, o.values, &o.out);
     }},
    {"free_form_deform",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_square(in, make_square);
         if (made_square.status() != NURBS_OK) {
             return made_square.status();
         }
         static constexpr double lower[] = {-1, -1};
         static constexpr double upper[] = {1, 1};
         return nurbs_free_form_deform(in.curve, made_square, lower, upper, 0.1, o.values, o.states, &o.out);
     }},
    {"fair",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_fair(in.curve, 2, nullptr, 1000.0, o.values, o.values + 2, &o.out);
     }},
    {"fair surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int32_t keep[] = {-1, -1, -1, -1};
         return nurbs_fair(in.surface, 1, keep, 1000.0, o.values, o.values + 2, &o.out);
     }},
    {"constrain directions",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int32_t kinds[] = {NURBS_CONSTRAIN_NORMAL, NURBS_CONSTRAIN_VALUE};
         static constexpr double params[] = {0.1, 0.9, 0.3, 0.7};
         return nurbs_constrain(in.surface, 2, kinds, nullptr, params, arrays::params, nullptr, nullptr,
             nullptr, 0, o.values, o.spans, o.values + 2, o.values + 3, &o.out);
     }},
    {"constrain curvature",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int32_t kinds[] = {NURBS_CONSTRAIN_CURVATURE};
         static constexpr double params[] = {0.1};
         static constexpr double targets[] = {-1, 0.1};
         static constexpr double weight_costs[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
         return nurbs_constrain(in.curve, 1, kinds, nullptr, params, targets, nullptr, nullptr, weight_costs,
             1e-09, o.values, o.spans, o.values + 1, o.values + 2, &o.out);
     }},
    {"constrain with costs",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int32_t kinds[] = {NURBS_CONSTRAIN_VALUE, NURBS_CONSTRAIN_VALUE};
         static constexpr int32_t orders[] = {0, 1};
         static constexpr double targets[] = {0.1, 0.9, 0.3, 0.7};
         static constexpr int32_t keep[] = {0, 0};
         static constexpr double costs[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
         static constexpr double weight_costs[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
         return nurbs_constrain(in.curve, 2, kinds, orders, arrays::new_knots, targets, keep, costs,
             weight_costs, 1e-06, o.values, o.spans, o.values + 2, o.values + 3, &o.out);
     }},
    {"bend",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origin[] = {0.1, 0.9};
         static constexpr double along[] = {1, 0};
         static constexpr double across[] = {0, 1};
         return nurbs_bend(in.curve, origin, along, across, 1, -9, 9, 0.1, o.values, o.states, &o.out);
     }},
    {"snap_boundary",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_snap_boundary(in.curve, 0, NURBS_END, in.segment, 0, NURBS_START, 1, 0, o.values,
             &o.out);
     }},
    {"snap_boundary surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_snap_boundary(in.surface, 0, NURBS_END, in.surface, 1, NURBS_START, 1, NURBS_REVERSED,
             o.values, &o.out);
     }},
    {"constrain_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double targets[] = {0.1, 0.9, 0.3, 0.7};
         static constexpr int32_t keep[] = {0, 0};
         nurbs_constraints constraints = {};
         constraints.struct_size = sizeof(nurbs_constraints);
         constraints.count = 2;
         constraints.params = arrays::new_knots;
         constraints.targets = targets;
         constraints.keep = keep;
         nurbs_constraint_report report = {};
         report.struct_size = sizeof(nurbs_constraint_report);
         report.residuals = o.values;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_constrain_with(in.curve, &constraints, &report, &call, &o.out);
     }},
    {"free_form_deform_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_square(in, make_square);
         if (made_square.status() != NURBS_OK) {
             return made_square.status();
         }
         static constexpr double lower[] = {-1, -1};
         static constexpr double upper[] = {1, 1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_free_form_deform_with(in.curve, made_square, lower, upper, 0.1, o.values, o.states,
             &call, &o.out);
     }},
    {"fair_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_fair_with(in.curve, 2, nullptr, 1000.0, o.values, o.values + 2, &call, &o.out);
     }},
    {"fair_with surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int32_t keep[] = {-1, -1, -1, -1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_fair_with(in.surface, 1, keep, 1000.0, o.values, o.values + 2, &call, &o.out);
     }},
    {"constrain_with directions",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int32_t kinds[] = {NURBS_CONSTRAIN_NORMAL, NURBS_CONSTRAIN_VALUE};
         static constexpr double params[] = {0.1, 0.9, 0.3, 0.7};
         nurbs_constraints constraints = {};
         constraints.struct_size = sizeof(nurbs_constraints);
         constraints.count = 2;
         constraints.kinds = kinds;
         constraints.params = params;
         constraints.targets = arrays::params;
         nurbs_constraint_report report = {};
         report.struct_size = sizeof(nurbs_constraint_report);
         report.residuals = o.values;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_constrain_with(in.surface, &constraints, &report, &call, &o.out);
     }},
    {"constrain_with curvature",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int32_t kinds[] = {NURBS_CONSTRAIN_CURVATURE};
         static constexpr double params[] = {0.1};
         static constexpr double targets[] = {-1, 0.1};
         static constexpr double weight_costs[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
         nurbs_constraints constraints = {};
         constraints.struct_size = sizeof(nurbs_constraints);
         constraints.count = 1;
         constraints.kinds = kinds;
         constraints.params = params;
         constraints.targets = targets;
         constraints.weight_costs = weight_costs;
         constraints.tolerance = 1e-09;
         nurbs_constraint_report report = {};
         report.struct_size = sizeof(nurbs_constraint_report);
         report.residuals = o.values;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_constrain_with(in.curve, &constraints, &report, &call, &o.out);
     }},
    {"constrain_with with costs",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int32_t kinds[] = {NURBS_CONSTRAIN_VALUE, NURBS_CONSTRAIN_VALUE};
         static constexpr int32_t orders[] = {0, 1};
         static constexpr double targets[] = {0.1, 0.9, 0.3, 0.7};
         static constexpr int32_t keep[] = {0, 0};
         static constexpr double costs[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
         static constexpr double weight_costs[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
         nurbs_constraints constraints = {};
         constraints.struct_size = sizeof(nurbs_constraints);
         constraints.count = 2;
         constraints.kinds = kinds;
         constraints.orders = orders;
         constraints.params = arrays::new_knots;
         constraints.targets = targets;
         constraints.keep = keep;
         constraints.costs = costs;
         constraints.weight_costs = weight_costs;
         constraints.tolerance = 1e-06;
         nurbs_constraint_report report = {};
         report.struct_size = sizeof(nurbs_constraint_report);
         report.residuals = o.values;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_constrain_with(in.curve, &constraints, &report, &call, &o.out);
     }},
    {"bend_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double origin[] = {0.1, 0.9};
         static constexpr double along[] = {1, 0};
         static constexpr double across[] = {0, 1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_bend_with(in.curve, origin, along, across, 1, -9, 9, 0.1, o.values, o.states, &call,
             &o.out);
     }},
};

} // namespace

std::span<const Call> edit_calls() {
    return group;
}

} // namespace calls
