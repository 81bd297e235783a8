/* SPDX-License-Identifier: MIT */
// Generated from tests/capi/calls/*.toml and include/nurbs/nurbs.h by: python3 cmake/interface/generate.py . - do not edit.
// clang-format off
#include "calls/calls.h"

namespace calls {

namespace {

const Call group[] = {
    {"find_spans",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double knots[] = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
         return nurbs_find_spans(2, 9, knots, 12, 6, arrays::params, 0, o.spans, 0);
     }},
    {"bernstein",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_bernstein(5, 3, 6, arrays::params, 0, o.values, 0, 0);
     }},
    {"basis",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double knots[] = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
         return nurbs_basis(2, 9, knots, 12, 4, 6, arrays::params, 0, o.spans, o.values, 0, 0, 0);
     }},
    {"rational_basis",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_rational_basis(in.curve, 6, arrays::params, 0, 0, o.spans, o.values, 0, 0, 0);
     }},
    {"rational_basis surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_rational_basis(in.surface, 3, arrays::params, 0, 0, o.spans, o.values, 0, 0, 0);
     }},
    {"basis_gradients",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_basis_gradients(in.curve, 6, arrays::params, 0, 0, o.spans, o.values, 0, 0, 0);
     }},
    {"basis_gradients surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_basis_gradients(in.surface, 3, arrays::params, 0, 0, o.spans, o.values, 0, 0, 0);
     }},
    {"eval",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_eval(in.curve, 6, arrays::params, 0, 0, o.values, 0, 0, 0);
     }},
    {"eval surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_eval(in.surface, 3, arrays::params, 0, 0, o.values, 0, 0, 0);
     }},
    {"eval volume",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_eval(in.volume, 2, arrays::params, 0, 0, o.values, 0, 0, 0);
     }},
    {"eval_derivs",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_eval_derivs(in.curve, 5, 6, arrays::params, 0, 0, o.values, 0, 0, 0);
     }},
    {"eval_derivs volume",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_eval_derivs(in.volume, 4, 2, arrays::params, 0, 0, o.values, 0, 0, 0);
     }},
    {"eval_grid",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int64_t counts[] = {2, 2};
         static constexpr double params[] = {0.1, 0.9, 0.3, 0.7};
         return nurbs_eval_grid(in.surface, counts, params, o.values, 0, 0, 0);
     }},
    {"eval_grid_derivs",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int64_t counts[] = {2, 2, 2};
         return nurbs_eval_grid_derivs(in.volume, 2, counts, arrays::params, o.values, 0, 0, 0);
     }},
    {"eval_f32",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_eval_f32(in.curve, 6, arrays::params, 0, 0, o.singles, 0, 0, 0);
     }},
    {"eval_grid_f32",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int64_t counts[] = {2, 2, 2};
         return nurbs_eval_grid_f32(in.volume, counts, arrays::params, o.singles, 0, 0, 0);
     }},
    {"rational_collocation",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_rational_collocation(in.curve, nullptr, 6, arrays::params, 0, 0, 18, o.values, o.spans,
             o.spans + 18, o.spans + 25, 0);
     }},
    {"rational_collocation of derivatives",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int32_t orders[] = {2};
         return nurbs_rational_collocation(in.curve, orders, 6, arrays::params, 0, 0, 18, o.values, o.spans,
             o.spans + 18, o.spans + 25, 0);
     }},
    {"hull_size",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_hull_size(in.curve, 6, arrays::params, 0, 0, o.values, 0, 0);
     }},
    {"hull_size signed",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_hull_size(in.homogeneous, 6, arrays::params, 0, 0, o.values, 0, 0);
     }},
    {"surface_eval_frames",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_surface_eval_frames(in.surface, 3, arrays::params, 0, 0, o.values, 0, 0, o.values + 9, 0,
             0, o.values + 18, 0, 0, o.values + 27, 0, 0, o.states, 0);
     }},
    {"surface_eval_grid_frames",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int64_t counts[] = {2, 2};
         static constexpr double params[] = {0.1, 0.9, 0.3, 0.7};
         return nurbs_surface_eval_grid_frames(in.surface, counts, params, o.values, 0, 0, o.values + 12, 0, 0,
             o.values + 24, 0, 0, o.values + 36, 0, 0, o.states, 0);
     }},
    {"surface_eval_curvatures",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_surface_eval_curvatures(in.surface, 3, arrays::params, 0, 0, o.values, 0, 0, o.values +
             6, 0, 0, o.values + 24, 0, o.values + 27, 0, o.states, 0);
     }},
    {"curve_eval_frames",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_curve_eval_frames(in.curve, 6, arrays::params, 0, o.values, 0, 0, o.values + 12, 0, 0,
             o.values + 24, 0, 0, nullptr, 0, 0, o.values + 36, 0, nullptr, 0, o.states, 0);
     }},
    {"curve_eval_frames in space",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_curve_eval_frames(in.twist, 6, arrays::params, 0, o.values, 0, 0, o.values + 18, 0, 0,
             o.values + 36, 0, 0, o.values + 54, 0, 0, o.values + 72, 0, o.values + 78, 0, o.states, 0);
     }},
    {"curve_rotation_minimizing_frames",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double first_normal[] = {0, 1, 2};
         return nurbs_curve_rotation_minimizing_frames(in.twist, 6, arrays::params, 0, first_normal, o.values,
             0, 0, o.values + 18, 0, 0, o.values + 36, 0, 0, o.values + 54, 0, 0, o.states, 0);
     }},
    {"weight_points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double params[] = {0.1, 0.9};
         return nurbs_weight_points(in.surface, 1, params, o.values, o.values + 3, o.values + 6);
     }},
    {"weight_cross_ratio",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double control_point[] = {0.1};
         static constexpr double at_zero[] = {0.9};
         static constexpr double at_one[] = {0.3};
         static constexpr double at_weight[] = {0.7};
         return nurbs_weight_cross_ratio(1, control_point, at_zero, at_one, at_weight, o.values);
     }},
    {"most_influential",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_most_influential(in.surface, 3, arrays::params, 0, 0, o.spans, o.values);
     }},
    {"blossom",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double params[] = {0.1};
         return nurbs_blossom(in.curve, params, 2, arrays::new_knots, o.values, 0);
     }},
    {"collocation",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {2, 1};
         static constexpr int64_t counts[] = {3, 4};
         static constexpr double knots[] = {0, 0, 0, 1, 1, 1, 0, 0, 1, 2, 3, 3};
         return nurbs_collocation(2, degrees, counts, knots, 12, nullptr, 3, arrays::params, 0, 0, 18,
             o.values, o.spans, o.spans + 18, o.spans + 22, 0);
     }},
    {"collocation of derivatives",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {2, 1};
         static constexpr int64_t counts[] = {3, 4};
         static constexpr double knots[] = {0, 0, 0, 1, 1, 1, 0, 0, 1, 2, 3, 3};
         static constexpr int32_t orders[] = {1, 0};
         return nurbs_collocation(2, degrees, counts, knots, 12, orders, 3, arrays::params, 0, 0, 18, o.values,
             o.spans, o.spans + 18, o.spans + 22, 0);
     }},
    {"eval_adjoint",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double cotangents[] = {1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0};
         return nurbs_eval_adjoint(in.curve, 0, 6, arrays::params, 0, 0, cotangents, 0, 0, o.values, 0, 0,
             o.values + 18, 0, o.values + 27, 0, 0, 0);
     }},
    {"eval_adjoint points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double cotangents[] = {1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
             0, 0, 0, 0, 0, 0};
         return nurbs_eval_adjoint(in.surface, 1, 3, arrays::params, 0, 0, cotangents, 0, 0, o.values, 0, 0,
             nullptr, 0, nullptr, 0, 0, 0);
     }},
    {"eval_adjoint_knots",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double cotangents[] = {1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0};
         return nurbs_eval_adjoint_knots(in.curve, 0, 0, 6, arrays::params, 0, 0, cotangents, 0, 0, o.values,
             0);
     }},
    {"eval_adjoint_knots surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double cotangents[] = {1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
             0, 0, 0, 0, 0, 0};
         return nurbs_eval_adjoint_knots(in.surface, 1, 1, 3, arrays::params, 0, 0, cotangents, 0, 0, o.values,
             0);
     }},
};

} // namespace

std::span<const Call> evaluation_calls() {
    return group;
}

} // namespace calls
