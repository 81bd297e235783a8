/* SPDX-License-Identifier: MIT */
// Generated from tests/capi/calls/*.toml and include/nurbs/nurbs.h by: python3 cmake/interface/generate.py . - do not edit.
// clang-format off
#include "calls/calls.h"

namespace calls {

namespace {

const Call group[] = {
    {"axes",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_axes(in.curve, o.states);
     }},
    {"dimension",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_dimension(in.curve, o.states);
     }},
    {"point_count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_point_count(in.curve, o.spans);
     }},
    {"is_rational",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_is_rational(in.curve, o.states);
     }},
    {"is_homogeneous",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_is_homogeneous(in.curve, o.states);
     }},
    {"degree",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_degree(in.surface, 1, o.states);
     }},
    {"count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_count(in.surface, 1, o.spans);
     }},
    {"knot_form",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_knot_form(in.surface, 1, o.states);
     }},
    {"domain",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_domain(in.surface, 1, o.values);
     }},
    {"derivative_slots",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_derivative_slots(3, 9, o.spans);
     }},
    {"unwrapped_count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_unwrapped_count(in.loop, 0, o.spans);
     }},
    {"list_count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_list_count(in.list, o.spans);
     }},
    {"list_note_count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_list_note_count(in.list, o.spans);
     }},
    {"list_unit",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_list_unit(in.list, o.values);
     }},
    {"list_name",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_list_name(in.list, 0, o.text, 64, o.spans);
     }},
    {"list_note",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_list_note(in.list, 0, o.states, o.spans, o.states + 1, o.text, 128, o.spans + 1);
     }},
    {"model_counts",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_counts(in.model, o.spans, o.spans + 1, o.spans + 2, o.spans + 3, o.spans + 4);
     }},
    {"meet_counts",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_meet_counts(in.meet, o.spans, o.spans + 1, o.states);
     }},
    {"mesh_counts",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_counts(in.mesh, o.spans, o.spans + 1, o.spans + 2, o.spans + 3, o.spans + 4, o.spans
             + 5);
     }},
    {"mesh_bound",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_bound(in.mesh, o.values, o.values + 1, o.states);
     }},
    {"model_face_name",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_face_name(in.model, 1, o.text, 16, o.spans);
     }},
    {"model_face_solid",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_face_solid(in.model, 1, o.spans, o.states);
     }},
    {"model_face_layers",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_face_layers(in.layered, 0, 2, o.spans, o.spans + 2);
     }},
    {"model_spline_layers",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_spline_layers(in.layered, 0, 2, o.spans, o.spans + 2);
     }},
    {"model_layer_count",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_layer_count(in.layered, o.spans);
     }},
    {"model_layer",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_layer(in.layered, 0, o.text, 16, o.spans);
     }},
    {"model_edge_uses",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_edge_uses(in.model, 1, 1, o.spans, o.spans + 3);
     }},
    {"model_vertex",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_vertex(in.model, 0, o.values);
     }},
    {"model_part",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_part(in.model, 0, o.text, 16, o.spans);
     }},
    {"model_use",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_use(in.model, 0, o.spans, o.spans + 1, o.values);
     }},
    {"read_options_init",
     [](const Inputs &, Output &) -> nurbs_status {
         nurbs_read_options options;
         return nurbs_read_options_init(&options, sizeof(nurbs_read_options));
     }},
    {"call_options_init",
     [](const Inputs &, Output &) -> nurbs_status {
         nurbs_call_options options;
         return nurbs_call_options_init(&options, sizeof(nurbs_call_options));
     }},
    {"version",
     [](const Inputs &, Output &o) -> nurbs_status {
         o.states[0] = nurbs_version();
         return NURBS_OK;
     }},
    {"status_name",
     [](const Inputs &, Output &o) -> nurbs_status {
         snprintf(o.text, sizeof o.text, "%s", nurbs_status_name(NURBS_OK));
         return NURBS_OK;
     }},
    {"last_error",
     [](const Inputs &, Output &o) -> nurbs_status {
         o.spans[0] = nurbs_last_error(o.text, 64);
         return NURBS_OK;
     }},
};

} // namespace

std::span<const Call> scalar_calls() {
    return group;
}

} // namespace calls
