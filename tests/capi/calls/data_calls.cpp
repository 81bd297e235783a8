/* SPDX-License-Identifier: MIT */
// Making splines from their data, and their data from splines.
#include "calls/calls.h"

#include "iges_text.h"

namespace calls {

namespace {

const IgesText file = small_file();

nurbs_status make_new(SplineArgs a, Output &o) {
    return create(&a, &o.out);
}

nurbs_status short_knots(const Inputs &, Output &o) {
    static const double knots[] = {0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1};
    const SplineArgs a = circle();
    return nurbs_create_short(1, a.degrees, a.counts, knots, 10, 2, a.points, 0, 0, a.weights, 0, 0, &o.out);
}

nurbs_status grouped_knots(const Inputs &, Output &o) {
    static const int64_t count = 5;
    static const double knots[] = {0, 0.25, 0.5, 0.75, 1};
    static const int32_t times[] = {3, 2, 2, 2, 3};
    const SplineArgs a = circle();
    return nurbs_create_multiplicities(1, a.degrees, a.counts, &count, knots, times, 2, a.points, 0, 0,
                                       a.weights, 0, 0, &o.out);
}

nurbs_status homogeneous(const Inputs &, Output &o) {
    static const double records[] = {1, 1, 1, 2, -1, 1, -1, -1, 1, -1, 1, 2};
    const SplineArgs a = loop();
    return nurbs_create_homogeneous(1, a.degrees, a.counts, a.knots, 9, 1, records, 0, 0, 0, &o.out);
}

nurbs_status averaged(const Inputs &, Output &o) {
    static const double sites[] = {0, 1, 2, 3, 4};
    return nurbs_knots_averaged(2, 5, sites, 8, o.values);
}

nurbs_status periodic_knots(const Inputs &, Output &o) {
    static const double breaks[] = {0, 1, 2, 3};
    return nurbs_knots_periodic(2, 4, breaks, nullptr, 8, o.values);
}

const Call group[] = {
    {"create curve", [](const Inputs &, Output &o) { return make_new(circle(), o); }},
    {"create loop", [](const Inputs &, Output &o) { return make_new(loop(), o); }},
    {"create volume", [](const Inputs &, Output &o) { return make_new(cube(), o); }},
    {"create_homogeneous", homogeneous},
    {"create_short", short_knots},
    {"create_multiplicities", grouped_knots},
    {"create_bezier",
     [](const Inputs &, Output &o) {
         return nurbs_create_bezier(1, arch().degrees, 2, arch().points, 0, 0, nullptr, 0, &o.out);
     }},
    {"create_hermite",
     [](const Inputs &, Output &o) {
         return nurbs_create_hermite(2, new_knots, 2, params, 0, 0, params, 0, 0, &o.out);
     }},
    {"create_power",
     [](const Inputs &, Output &o) {
         static const int32_t degrees[] = {1, 0};
         static const int64_t pieces[] = {1, 1};
         static const double breaks[] = {0, 1, 0, 1};
         return nurbs_create_power(2, degrees, pieces, breaks, 4, 2, params, 0, 0, 0, &o.out);
     }},
    {"with_points",
     [](const Inputs &in, Output &o) {
         return nurbs_with_points(in.curve, circle().points, 0, 0, nullptr, 0, &o.out);
     }},
    {"clone", [](const Inputs &in, Output &o) { return nurbs_clone(in.curve, &o.out); }},
    {"read", [](const Inputs &, Output &o) { return nurbs_read(file.bytes, file.size, nullptr, &o.list); }},
    {"read_file", [](const Inputs &, Output &o) { return nurbs_read_file(file_path, nullptr, &o.list); },
     true},
    {"list_get", [](const Inputs &in, Output &o) { return nurbs_list_get(in.list, 0, &o.out); }},
    {"knots_uniform", [](const Inputs &, Output &o) { return nurbs_knots_uniform(2, 5, 0, 1, 8, o.values); }},
    {"knots_open_uniform",
     [](const Inputs &, Output &o) { return nurbs_knots_open_uniform(2, 5, 0, 1, 8, o.values); }},
    {"knots_bezier",
     [](const Inputs &, Output &o) { return nurbs_knots_bezier(2, 2, nullptr, 8, o.values); }},
    {"knots_averaged", averaged},
    {"knots_periodic", periodic_knots},
    {"knots", [](const Inputs &in, Output &o) { return nurbs_knots(in.curve, 0, 12, o.values); }},
    {"distinct_knots",
     [](const Inputs &in, Output &o) {
         return nurbs_distinct_knots(in.curve, 0, 5, o.values, nullptr, o.spans);
     }},
    {"greville", [](const Inputs &in, Output &o) { return nurbs_greville(in.curve, 0, 9, o.values); }},
    {"points", [](const Inputs &in, Output &o) { return nurbs_points(in.homogeneous, 3, o.values, 0, 0); }},
    {"weights", [](const Inputs &in, Output &o) { return nurbs_weights(in.curve, 9, o.values, 0); }},
    {"homogeneous_points",
     [](const Inputs &in, Output &o) { return nurbs_homogeneous_points(in.curve, 9, o.values, 0, 0); }},
    {"detect_periodic",
     [](const Inputs &in, Output &o) { return nurbs_detect_periodic(in.curve, 0, o.states); }},
    {"to_hermite",
     [](const Inputs &in, Output &o) {
         return nurbs_to_hermite(in.twist, 2, o.values, o.values + 2, o.values + 8, nullptr);
     }},
    {"to_power", [](const Inputs &in,
                    Output &o) { return nurbs_to_power(in.curve, 64, o.values, nullptr, o.spans, nullptr); }},
    {"bezier_extraction",
     [](const Inputs &in, Output &o) {
         return nurbs_bezier_extraction(in.curve, 0, 4, o.values, nullptr, nullptr, o.spans);
     }},
    {"refinement_matrix",
     [](const Inputs &in, Output &o) {
         return nurbs_refinement_matrix(in.curve, 0, 2, new_knots, 0, nullptr, nullptr, nullptr, o.spans);
     }},
    {"basis_matrix", [](const Inputs &, Output &o) { return nurbs_basis_matrix(0, 3, 3, 16, o.values); }},
    {"decompose", [](const Inputs &in, Output &o) { return nurbs_decompose(in.surface, &o.list); }},
    {"split_at_knots",
     [](const Inputs &in, Output &o) { return nurbs_split_at_knots(in.curve, 0, 1, &o.list); }},
    {"boundaries", [](const Inputs &in, Output &o) { return nurbs_boundaries(in.volume, &o.list); }},
};

} // namespace

std::span<const Call> data_calls() {
    return group;
}

} // namespace calls
