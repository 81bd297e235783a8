/* SPDX-License-Identifier: MIT */
// Points, derivatives, frames and basis functions.
#include "calls/calls.h"

namespace calls {

namespace {

const double cotangents[64] = {1, 2, 3};
const int64_t grid_counts[] = {2, 2, 2};

const Call group[] = {
    {"find_spans",
     [](const Inputs &, Output &o) {
         return nurbs_find_spans(2, 9, circle().knots, 12, 6, params, 0, o.spans, 0);
     }},
    {"bernstein",
     [](const Inputs &, Output &o) { return nurbs_bernstein(5, 3, 6, params, 0, o.values, 0, 0); }},
    {"basis",
     [](const Inputs &, Output &o) {
         return nurbs_basis(2, 9, circle().knots, 12, 4, 6, params, 0, o.spans, o.values, 0, 0, 0);
     }},
    {"rational_basis",
     [](const Inputs &in, Output &o) {
         return nurbs_rational_basis(in.curve, 6, params, 0, 0, o.spans, o.values, 0, 0, 0);
     }},
    {"rational_basis surface",
     [](const Inputs &in, Output &o) {
         return nurbs_rational_basis(in.surface, 3, params, 0, 0, o.spans, o.values, 0, 0, 0);
     }},
    {"eval",
     [](const Inputs &in, Output &o) { return nurbs_eval(in.curve, 6, params, 0, 0, o.values, 0, 0, 0); }},
    {"eval surface",
     [](const Inputs &in, Output &o) { return nurbs_eval(in.surface, 3, params, 0, 0, o.values, 0, 0, 0); }},
    {"eval volume",
     [](const Inputs &in, Output &o) { return nurbs_eval(in.volume, 2, params, 0, 0, o.values, 0, 0, 0); }},
    {"eval_derivs",
     [](const Inputs &in, Output &o) {
         return nurbs_eval_derivs(in.curve, 5, 6, params, 0, 0, o.values, 0, 0, 0);
     }},
    {"eval_derivs volume",
     [](const Inputs &in, Output &o) {
         return nurbs_eval_derivs(in.volume, 4, 2, params, 0, 0, o.values, 0, 0, 0);
     }},
    {"eval_grid",
     [](const Inputs &in, Output &o) {
         return nurbs_eval_grid(in.surface, grid_counts, params, o.values, 0, 0, 0);
     }},
    {"eval_grid_derivs",
     [](const Inputs &in, Output &o) {
         return nurbs_eval_grid_derivs(in.volume, 2, grid_counts, params, o.values, 0, 0, 0);
     }},
    {"eval_f32", [](const Inputs &in,
                    Output &o) { return nurbs_eval_f32(in.curve, 6, params, 0, 0, o.singles, 0, 0, 0); }},
    {"eval_grid_f32",
     [](const Inputs &in, Output &o) {
         return nurbs_eval_grid_f32(in.volume, grid_counts, params, o.singles, 0, 0, 0);
     }},
    {"collocation",
     [](const Inputs &, Output &o) {
         const SplineArgs a = trough();
         const int32_t orders[] = {1, 0};
         return nurbs_collocation(2, a.degrees, a.counts, a.knots, 12, orders, 3, params, 0, 0, 64, o.values,
                                  o.spans, nullptr, nullptr, 0);
     }},
    {"rational_collocation",
     [](const Inputs &in, Output &o) {
         const int32_t order = 2;
         return nurbs_rational_collocation(in.curve, &order, 6, params, 0, 0, 64, o.values, o.spans, nullptr,
                                           nullptr, 0);
     }},
    {"eval_adjoint points",
     [](const Inputs &in, Output &o) {
         return nurbs_eval_adjoint(in.surface, 1, 3, params, 0, 0, cotangents, 0, 0, o.values, 0, 0, nullptr,
                                   0, nullptr, 0, 0, 0);
     }},
    {"eval_adjoint",
     [](const Inputs &in, Output &o) {
         return nurbs_eval_adjoint(in.curve, 0, 6, params, 0, 0, cotangents, 0, 0, o.values, 0, 0,
                                   o.values + 32, 0, o.values + 64, 0, 0, 0);
     }},
    {"hull_size",
     [](const Inputs &in, Output &o) { return nurbs_hull_size(in.curve, 6, params, 0, 0, o.values, 0, 0); }},
    {"hull_size signed",
     [](const Inputs &in, Output &o) {
         return nurbs_hull_size(in.homogeneous, 6, params, 0, 0, o.values, 0, 0);
     }},
    {"surface_eval_frames",
     [](const Inputs &in, Output &o) {
         return nurbs_surface_eval_frames(in.surface, 3, params, 0, 0, o.values, 0, 0, o.values + 9, 0, 0,
                                          o.values + 18, 0, 0, o.values + 27, 0, 0, o.states, 0);
     }},
    {"surface_eval_grid_frames",
     [](const Inputs &in, Output &o) {
         return nurbs_surface_eval_grid_frames(in.surface, grid_counts, params, o.values, 0, 0, nullptr, 0, 0,
                                               nullptr, 0, 0, o.values + 12, 0, 0, o.states, 0);
     }},
    {"surface_eval_curvatures",
     [](const Inputs &in, Output &o) {
         return nurbs_surface_eval_curvatures(in.surface, 3, params, 0, 0, o.values, 0, 0, o.values + 6, 0, 0,
                                              o.values + 24, 0, o.values + 27, 0, o.states, 0);
     }},
    {"curve_eval_frames",
     [](const Inputs &in, Output &o) {
         return nurbs_curve_eval_frames(in.curve, 6, params, 0, o.values, 0, 0, o.values + 12, 0, 0,
                                        o.values + 24, 0, 0, nullptr, 0, 0, o.values + 36, 0, nullptr, 0,
                                        o.states, 0);
     }},
    {"rotation_minimizing_frames",
     [](const Inputs &in, Output &o) {
         static const double first[] = {0, 1, 2};
         return nurbs_curve_rotation_minimizing_frames(in.twist, 6, params, 0, first, o.values, 0, 0,
                                                       o.values + 18, 0, 0, o.values + 36, 0, 0,
                                                       o.values + 54, 0, 0, o.states, 0);
     }},
    {"weight_points",
     [](const Inputs &in, Output &o) {
         return nurbs_weight_points(in.surface, 1, params, o.values, o.values + 3, o.values + 6);
     }},
    {"weight_cross_ratio",
     [](const Inputs &, Output &o) {
         return nurbs_weight_cross_ratio(1, params, params + 1, params + 2, params + 3, o.values);
     }},
    {"most_influential",
     [](const Inputs &in, Output &o) {
         return nurbs_most_influential(in.surface, 3, params, 0, 0, o.spans, o.values);
     }},
    {"blossom",
     [](const Inputs &in, Output &o) { return nurbs_blossom(in.curve, params, 2, new_knots, o.values, 0); }},
};

} // namespace

std::span<const Call> evaluation_calls() {
    return group;
}

} // namespace calls
