/* SPDX-License-Identifier: MIT */
// Generated from tests/capi/calls/*.toml and include/nurbs/nurbs.h by: python3 cmake/interface/generate.py . - do not edit.
// clang-format off
#include "calls/calls.h"

namespace calls {

namespace {

const Call group[] = {
    {"iso curve",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_iso(in.surface, 0, 0.3, 0, &o.out);
     }},
    {"iso surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_iso(in.volume, 1, 0.3, 0, &o.out);
     }},
    {"insert_knot",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_insert_knot(in.curve, 0, 0.3, 2, &o.out);
     }},
    {"insert_knot periodic",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_insert_knot(in.loop, 0, 2.5, 2, &o.out);
     }},
    {"insert_knot surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_insert_knot(in.surface, 1, 1.5, 1, &o.out);
     }},
    {"insert_knot 0 times",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_insert_knot(in.surface, 1, 1.5, 0, &o.out);
     }},
    {"refine",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_refine(in.curve, 0, 2, arrays::new_knots, &o.out);
     }},
    {"refine_uniform",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_refine_uniform(in.loop, 0, 3, &o.out);
     }},
    {"extract",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double lower[] = {0.3};
         static constexpr double upper[] = {0.6};
         return nurbs_extract(in.curve, lower, upper, &o.out);
     }},
    {"split",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_split(in.curve, 0, 0.3, &o.out, &o.other);
     }},
    {"clamp_ends",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_clamp_ends(in.loop, 0, NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END, &o.out);
     }},
    {"unclamp",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_unclamp(in.volume, 2, NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END, &o.out);
     }},
    {"move_seam",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_move_seam(in.loop, 0, 2.5, &o.out);
     }},
    {"join",
     [](const Inputs &in, Output &o) -> nurbs_status {
         const nurbs *const parts[] = {in.curve, in.curve};
         return nurbs_join(2, parts, 0, 9, 0, o.values, &o.out);
     }},
    {"join with gaps",
     [](const Inputs &in, Output &o) -> nurbs_status {
         const nurbs *const parts[] = {in.curve, in.curve};
         return nurbs_join(2, parts, 0, 9, NURBS_KEEP_GAPS, o.values, &o.out);
     }},
    {"snap_knots",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_snap_knots(in.loop, 0, 0.26, o.values, &o.out);
     }},
    {"extend",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_extend(in.surface, 0, NURBS_START, 1, 1, &o.out);
     }},
    {"make_periodic",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_make_periodic(in.curve, 0, 1, o.values, o.states, &o.out);
     }},
    {"make_compatible",
     [](const Inputs &in, Output &o) -> nurbs_status {
         const nurbs *const splines[] = {in.curve, in.loop};
         return nurbs_make_compatible(2, splines, 0.01, NURBS_MAP_DOMAINS, o.values, &o.list);
     }},
    {"remove_knot",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_remove_knot(in.curve, 0, 0.5, 1, 9, o.states, o.values, &o.out);
     }},
    {"remove_knot periodic",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_remove_knot(in.loop, 0, 3, 1, 9, o.states, o.values, &o.out);
     }},
    {"reduce_knots",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_reduce_knots(in.curve, -1, 9, o.values, &o.out);
     }},
    {"reduce_degree",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_reduce_degree(in.loop, 0, 1, o.values, &o.out);
     }},
    {"simplify",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_simplify(in.curve, 9, o.values, &o.out);
     }},
    {"elevate",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_elevate(in.curve, 0, 2, &o.out);
     }},
    {"elevate periodic",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_elevate(in.loop, 0, 2, &o.out);
     }},
    {"elevate homogeneous",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_elevate(in.homogeneous, 0, 1, &o.out);
     }},
    {"reverse",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_reverse(in.curve, 0, NURBS_KEEP_DOMAIN, &o.out);
     }},
    {"transpose",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int32_t permutation[] = {2, 0, 1};
         return nurbs_transpose(in.volume, permutation, &o.out);
     }},
    {"reparametrize",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_reparametrize(in.loop, 0, 0, 1, &o.out);
     }},
    {"reparametrize_moebius",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_reparametrize_moebius(in.curve, 0, 2, &o.out);
     }},
    {"derivative",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_derivative(in.loop, 0, 1, &o.out);
     }},
    {"derivative rational",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_derivative(in.curve, 0, 2, &o.out);
     }},
    {"derivative beyond the degree",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_derivative(in.loop, 0, 9, &o.out);
     }},
    {"antiderivative",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_antiderivative(in.volume, 1, &o.out);
     }},
    {"product",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_product(in.curve, in.curve, 0, &o.out);
     }},
    {"product periodic",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_product(in.loop, in.loop, 0, &o.out);
     }},
    {"product volume",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_product(in.volume, in.volume, NURBS_PRODUCT_DOT, &o.out);
     }},
    {"compose",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_ramp(in, make_ramp);
         if (made_ramp.status() != NURBS_OK) {
             return made_ramp.status();
         }
         return nurbs_compose(in.curve, made_ramp, &o.out);
     }},
    {"compose around a loop",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_round(in, make_round);
         if (made_round.status() != NURBS_OK) {
             return made_round.status();
         }
         return nurbs_compose(in.loop, made_round, &o.out);
     }},
    {"compose on a surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_diagonal(in, make_diagonal);
         if (made_diagonal.status() != NURBS_OK) {
             return made_diagonal.status();
         }
         return nurbs_compose(in.surface, made_diagonal, &o.out);
     }},
    {"sum",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_sum(in.loop, 1, in.loop, 2, &o.out);
     }},
    {"sum rational",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_half(in, make_half);
         if (made_half.status() != NURBS_OK) {
             return made_half.status();
         }
         return nurbs_sum(in.curve, 1, made_half, 1, &o.out);
     }},
    {"reduce_knots_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_reduce_knots_with(in.curve, -1, 9, o.values, &call, &o.out);
     }},
    {"reduce_degree_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_reduce_degree_with(in.loop, 0, 1, o.values, &call, &o.out);
     }},
    {"simplify_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_simplify_with(in.curve, 9, o.values, &call, &o.out);
     }},
    {"product_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_product_with(in.curve, in.curve, 0, &call, &o.out);
     }},
    {"product_with periodic",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_product_with(in.loop, in.loop, 0, &call, &o.out);
     }},
    {"product_with volume",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_product_with(in.volume, in.volume, NURBS_PRODUCT_DOT, &call, &o.out);
     }},
    {"compose_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_ramp(in, make_ramp);
         if (made_ramp.status() != NURBS_OK) {
             return made_ramp.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_compose_with(in.curve, made_ramp, &call, &o.out);
     }},
    {"compose_with around a loop",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_round(in, make_round);
         if (made_round.status() != NURBS_OK) {
             return made_round.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_compose_with(in.loop, made_round, &call, &o.out);
     }},
    {"compose_with on a surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_diagonal(in, make_diagonal);
         if (made_diagonal.status() != NURBS_OK) {
             return made_diagonal.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_compose_with(in.surface, made_diagonal, &call, &o.out);
     }},
};

} // namespace

std::span<const Call> form_calls() {
    return group;
}

} // namespace calls
