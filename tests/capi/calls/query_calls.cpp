/* SPDX-License-Identifier: MIT */
// Continuity, bounds, closest points, features, measures.
#include "calls/calls.h"

namespace calls {

namespace {

const double four[] = {4};

nurbs_status coons_gaps(const Inputs &in, Output &o) {
    const nurbs *const curves[] = {in.curve, in.curve, in.loop, in.loop};
    return nurbs_coons_gaps(curves, curves, o.values, o.values + 4, o.values + 12);
}

const Call group[] = {
    {"continuity",
     [](const Inputs &in, Output &o) {
         return nurbs_continuity(in.surface, 1, 0, 0, 0, 0, nullptr, nullptr, nullptr, nullptr, nullptr,
                                 nullptr, nullptr, o.spans);
     }},
    {"continuity_between",
     [](const Inputs &in, Output &o) {
         return nurbs_continuity_between(in.curve, NURBS_END, in.curve, NURBS_START, 0, 0, 0, o.states,
                                         nullptr, nullptr, nullptr, nullptr);
     }},
    {"deviation", [](const Inputs &in,
                     Output &o) { return nurbs_deviation(in.surface, in.surface, o.values, o.values + 1); }},
    {"curve_shape_factor",
     [](const Inputs &in, Output &o) { return nurbs_curve_shape_factor(in.segment, o.values, o.states); }},
    {"box", [](const Inputs &in,
               Output &o) { return nurbs_box(in.volume, nullptr, 1e-3, o.values, o.values + 4, nullptr); }},
    {"oriented_box",
     [](const Inputs &in, Output &o) {
         return nurbs_oriented_box(in.surface, 1e-3, o.values, o.values + 3, o.values + 12);
     }},
    {"tangent_cone",
     [](const Inputs &in, Output &o) {
         return nurbs_tangent_cone(in.segment, 0, nullptr, 0.1, o.values, o.values + 2);
     }},
    {"normal_cone",
     [](const Inputs &in, Output &o) {
         return nurbs_normal_cone(in.surface, nullptr, 0.1, o.values, o.values + 3);
     }},
    {"extreme_point",
     [](const Inputs &in, Output &o) {
         return nurbs_extreme_point(in.curve, params, nullptr, 1e-6, o.values, o.values + 1, o.values + 2);
     }},
    {"closest_points",
     [](const Inputs &in, Output &o) {
         return nurbs_closest_points(in.curve, 1, params, 0, 0, nullptr, 0, 0, o.values, 0, 0, o.values + 1,
                                     0, 0, nullptr, 0, o.states, 0);
     }},
    {"closest_local",
     [](const Inputs &in, Output &o) {
         return nurbs_closest_local(in.curve, 1, params, 0, 0, params, 0, 0, o.values, 0, 0, nullptr, 0, 0,
                                    nullptr, 0, nullptr, 0);
     }},
    {"curve_signed_distances",
     [](const Inputs &in, Output &o) {
         return nurbs_curve_signed_distances(in.curve, 1, params, 0, 0, 0, 0, o.values, 0, nullptr, 0,
                                             nullptr, 0);
     }},
    {"closest_all",
     [](const Inputs &in, Output &o) {
         return nurbs_closest_all(in.curve, params, nullptr, 0, 0, 8, o.values, nullptr, nullptr, nullptr);
     },
     true},
    {"critical_points",
     [](const Inputs &in, Output &o) {
         return nurbs_critical_points(in.curve, params, nullptr, 0, 0, 8, o.values, nullptr, nullptr, nullptr,
                                      nullptr);
     },
     true},
    {"curve_features",
     [](const Inputs &in, Output &o) {
         return nurbs_curve_features(in.twist, 0x7f, 0, nullptr, nullptr, nullptr, o.spans, o.states);
     }},
    {"curve_features periodic",
     [](const Inputs &in, Output &o) {
         return nurbs_curve_features(in.loop, 0x3f, 16, o.values, o.states, o.values + 16, o.spans, nullptr);
     },
     true},
    {"curve_monotone_pieces",
     [](const Inputs &in, Output &o) {
         return nurbs_curve_monotone_pieces(in.curve, params, 16, o.values, o.states, o.spans, nullptr);
     }},
    {"curve_convexity",
     [](const Inputs &in, Output &o) { return nurbs_curve_convexity(in.curve, o.states); }},
    {"straightness",
     [](const Inputs &in, Output &o) {
         return nurbs_straightness(in.segment, o.values, o.values + 2, o.values + 4);
     },
     true},
    {"planarity",
     [](const Inputs &in, Output &o) {
         return nurbs_planarity(in.surface, o.values, o.values + 3, o.values + 6);
     }},
    {"boundary_contacts",
     [](const Inputs &in, Output &o) {
         return nurbs_boundary_contacts(in.surface, 0.1, o.states, o.values, o.states + 2, o.values + 2);
     },
     true},
    {"singular_points",
     [](const Inputs &in, Output &o) {
         return nurbs_singular_points(in.surface, 0.1, 0, nullptr, nullptr, o.spans, o.states);
     }},
    {"fold_test",
     [](const Inputs &in, Output &o) {
         return nurbs_fold_test(in.surface, nullptr, o.states, o.values, o.values + 2);
     }},
    {"recognize curve",
     [](const Inputs &in, Output &o) {
         return nurbs_recognize(in.curve, 1e-9, o.states, o.values, o.values + 9, o.values + 12);
     },
     true},
    {"recognize surface",
     [](const Inputs &in, Output &o) {
         return nurbs_recognize(in.surface, 0.2, o.states, o.values, o.values + 9, o.values + 12);
     },
     true},
    {"distance",
     [](const Inputs &in, Output &o) {
         return nurbs_distance(in.curve, in.loop, 1e-6, 0, o.values, o.values + 1, o.values + 2, o.values + 3,
                               o.states);
     }},
    {"hausdorff_distance",
     [](const Inputs &in, Output &o) {
         return nurbs_hausdorff_distance(in.curve, in.loop, 1e-1, 0, o.values, o.values + 2, o.values + 4,
                                         o.values + 5, o.states);
     }},
    {"curve_length",
     [](const Inputs &in, Output &o) {
         return nurbs_curve_length(in.curve, nullptr, 1e-9, o.values, nullptr);
     }},
    {"curve_lengths",
     [](const Inputs &in, Output &o) { return nurbs_curve_lengths(in.loop, 1, four, 0, 1e-9, o.values, 0); }},
    {"curve_params_at_lengths",
     [](const Inputs &in, Output &o) {
         return nurbs_curve_params_at_lengths(in.curve, 1, four, 0, 1e-9, o.values, 0, 0);
     }},
    {"curve_divide",
     [](const Inputs &in, Output &o) {
         return nurbs_curve_divide(in.curve, nullptr, 5, 1e-9, 0, o.values, o.values + 6);
     }},
    {"curve_divide chords",
     [](const Inputs &in, Output &o) {
         return nurbs_curve_divide(in.curve, nullptr, 5, 1e-9, NURBS_EQUAL_CHORDS, o.values, nullptr);
     }},
    {"surface_area",
     [](const Inputs &in, Output &o) {
         return nurbs_surface_area(in.surface, nullptr, 1e-9, o.values, nullptr);
     }},
    {"moments",
     [](const Inputs &in, Output &o) {
         return nurbs_moments(in.surface, 1e-9, o.values, o.values + 1, o.values + 4, o.values + 13);
     }},
    {"enclosed_area",
     [](const Inputs &in, Output &o) {
         const nurbs *curves[] = {in.loop};
         return nurbs_enclosed_area(1, curves, 1e-9, 1e-9, o.values, o.values + 1, o.values + 3, nullptr);
     }},
    {"enclosed_volume",
     [](const Inputs &in, Output &o) {
         const nurbs *surfaces[] = {in.surface};
         return nurbs_enclosed_volume(1, surfaces, 1e-9, o.values, nullptr, nullptr, o.values + 1, nullptr);
     }},
    {"coons_gaps", coons_gaps},
    {"farthest_points",
     [](const Inputs &in, Output &o) {
         return nurbs_farthest_points(in.curve, 1, params, 0, 0, nullptr, 0, 0, o.values, 0, 0, o.values + 1,
                                      0, 0, nullptr, 0, o.states, 0);
     }},
    {"conic_axes",
     [](const Inputs &, Output &o) {
         static const double ellipse[] = {1, 0, 4, 0, 0, -4};
         return nurbs_conic_axes(ellipse, o.states, o.values, o.values + 2, o.values + 4);
     }},
};

} // namespace

std::span<const Call> query_calls() {
    return group;
}

} // namespace calls
