/* SPDX-License-Identifier: MIT */
// Other forms of a spline, parts and sums of splines.
#include "calls/calls.h"

namespace calls {

namespace {

// With the quadratic Bezier curve of these three points, of dimension 1 or more.
nurbs_status compose_with(const nurbs *g, int32_t dim, const double *points, Output &o) {
    static const int32_t degree = 2;
    nurbs *f = nullptr;
    nurbs_status status = nurbs_create_bezier(1, &degree, dim, points, 0, 0, nullptr, 0, &f);
    if (status == NURBS_OK) {
        status = nurbs_compose(g, f, &o.out);
    }
    nurbs_destroy(f);
    return status;
}

nurbs_status compose_curve(const Inputs &in, Output &o) {
    static const double points[] = {0, 0.25, 1};
    return compose_with(in.curve, 1, points, o);
}

nurbs_status compose_loop(const Inputs &in, Output &o) {
    static const double points[] = {0, 2, 9};
    return compose_with(in.loop, 1, points, o);
}

nurbs_status compose_surface(const Inputs &in, Output &o) {
    static const double points[] = {0, 0, 1, 0, 1, 1};
    return compose_with(in.surface, 2, points, o);
}

const Call group[] = {
    {"iso curve", [](const Inputs &in, Output &o) { return nurbs_iso(in.surface, 0, 0.3, 0, &o.out); }},
    {"iso surface", [](const Inputs &in, Output &o) { return nurbs_iso(in.volume, 1, 0.3, 0, &o.out); }},
    {"insert_knot",
     [](const Inputs &in, Output &o) { return nurbs_insert_knot(in.curve, 0, 0.3, 2, &o.out); }},
    {"insert_knot periodic",
     [](const Inputs &in, Output &o) { return nurbs_insert_knot(in.loop, 0, 2.5, 2, &o.out); }},
    {"insert_knot surface",
     [](const Inputs &in, Output &o) { return nurbs_insert_knot(in.surface, 1, 1.5, 1, &o.out); }},
    {"refine", [](const Inputs &in, Output &o) { return nurbs_refine(in.curve, 0, 2, new_knots, &o.out); }},
    {"refine_uniform",
     [](const Inputs &in, Output &o) { return nurbs_refine_uniform(in.loop, 0, 3, &o.out); }},
    {"extract",
     [](const Inputs &in, Output &o) { return nurbs_extract(in.curve, new_knots, new_knots + 1, &o.out); }},
    {"clamp", [](const Inputs &in, Output &o) { return nurbs_clamp_ends(in.loop, 0, 3, &o.out); }},
    {"move_seam", [](const Inputs &in, Output &o) { return nurbs_move_seam(in.loop, 0, 2.5, &o.out); }},
    {"join",
     [](const Inputs &in, Output &o) {
         const nurbs *parts[] = {in.curve, in.curve};
         return nurbs_join(2, parts, 0, 9, NURBS_KEEP_GAPS, nullptr, &o.out);
     }},
    {"snap_knots",
     [](const Inputs &in, Output &o) { return nurbs_snap_knots(in.loop, 0, 0.26, nullptr, &o.out); }},
    {"extend",
     [](const Inputs &in, Output &o) { return nurbs_extend(in.surface, 0, NURBS_START, 1, 1, &o.out); }},
    {"unclamp", [](const Inputs &in, Output &o) { return nurbs_unclamp(in.volume, 2, 3, &o.out); }},
    {"make_periodic",
     [](const Inputs &in, Output &o) {
         return nurbs_make_periodic(in.curve, 0, 1, nullptr, nullptr, &o.out);
     }},
    {"make_compatible",
     [](const Inputs &in, Output &o) {
         const nurbs *splines[] = {in.curve, in.loop};
         return nurbs_make_compatible(2, splines, 0.01, NURBS_MAP_DOMAINS, nullptr, &o.list);
     }},
    {"remove_knot",
     [](const Inputs &in, Output &o) {
         return nurbs_remove_knot(in.curve, 0, 0.5, 1, 9, nullptr, nullptr, &o.out);
     }},
    {"remove_knot periodic",
     [](const Inputs &in, Output &o) {
         return nurbs_remove_knot(in.loop, 0, 3, 1, 9, nullptr, nullptr, &o.out);
     }},
    {"reduce_knots",
     [](const Inputs &in, Output &o) { return nurbs_reduce_knots(in.curve, -1, 9, nullptr, &o.out); }},
    {"reduce_degree",
     [](const Inputs &in, Output &o) { return nurbs_reduce_degree(in.loop, 0, 1, nullptr, &o.out); }},
    {"simplify", [](const Inputs &in, Output &o) { return nurbs_simplify(in.curve, 9, nullptr, &o.out); }},
    {"split",
     [](const Inputs &in, Output &o) {
         nurbs *other = nullptr;
         const nurbs_status status = nurbs_split(in.curve, 0, 0.3, &other, &o.out);
         nurbs_destroy(other);
         return status;
     }},
    {"insert_knot 0 times",
     [](const Inputs &in, Output &o) { return nurbs_insert_knot(in.surface, 1, 1.5, 0, &o.out); }},
    {"elevate", [](const Inputs &in, Output &o) { return nurbs_elevate(in.curve, 0, 2, &o.out); }},
    {"elevate periodic", [](const Inputs &in, Output &o) { return nurbs_elevate(in.loop, 0, 2, &o.out); }},
    {"elevate homogeneous",
     [](const Inputs &in, Output &o) { return nurbs_elevate(in.homogeneous, 0, 1, &o.out); }},
    {"reverse",
     [](const Inputs &in, Output &o) { return nurbs_reverse(in.curve, 0, NURBS_KEEP_DOMAIN, &o.out); }},
    {"transpose",
     [](const Inputs &in, Output &o) {
         static const int32_t turn[] = {2, 0, 1};
         return nurbs_transpose(in.volume, turn, &o.out);
     }},
    {"derivative", [](const Inputs &in, Output &o) { return nurbs_derivative(in.loop, 0, 1, &o.out); }},
    {"derivative rational",
     [](const Inputs &in, Output &o) { return nurbs_derivative(in.curve, 0, 2, &o.out); }},
    {"derivative beyond the degree",
     [](const Inputs &in, Output &o) { return nurbs_derivative(in.loop, 0, 9, &o.out); }},
    {"antiderivative",
     [](const Inputs &in, Output &o) { return nurbs_antiderivative(in.volume, 1, &o.out); }},
    {"product", [](const Inputs &in, Output &o) { return nurbs_product(in.curve, in.curve, 0, &o.out); }},
    {"product periodic",
     [](const Inputs &in, Output &o) { return nurbs_product(in.loop, in.loop, 0, &o.out); }},
    {"product volume",
     [](const Inputs &in, Output &o) {
         return nurbs_product(in.volume, in.volume, NURBS_PRODUCT_DOT, &o.out);
     }},
    {"compose", compose_curve},
    {"compose around a loop", compose_loop},
    {"compose on a surface", compose_surface},
    {"sum", [](const Inputs &in, Output &o) { return nurbs_sum(in.loop, 1, in.loop, 2, &o.out); }},
    {"sum rational",
     [](const Inputs &in, Output &o) {
         nurbs *half = nullptr;
         nurbs_status status = nurbs_reparametrize_moebius(in.curve, 0, 2, &half);
         if (status == NURBS_OK) {
             status = nurbs_sum(in.curve, 1, half, 1, &o.out);
         }
         nurbs_destroy(half);
         return status;
     }},
    {"reparametrize",
     [](const Inputs &in, Output &o) { return nurbs_reparametrize(in.loop, 0, 0, 1, &o.out); }},
};

} // namespace

std::span<const Call> form_calls() {
    return group;
}

} // namespace calls
