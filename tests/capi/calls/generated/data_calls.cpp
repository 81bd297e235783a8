/* SPDX-License-Identifier: MIT */
// Generated from tests/capi/calls/*.toml and include/nurbs/nurbs.h by: python3 cmake/interface/generate.py . - do not edit.
// clang-format off
#include "calls/calls.h"

namespace calls {

namespace {

const Call group[] = {
    {"clone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_clone(in.curve, &o.out);
     }},
    {"destroy",
     [](const Inputs &in, Output &) -> nurbs_status {
         Made made_copy(in, make_copy);
         if (made_copy.status() != NURBS_OK) {
             return made_copy.status();
         }
         nurbs_destroy(made_copy.release());
         return NURBS_OK;
     }},
    {"with_points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0};
         return nurbs_with_points(in.curve, points, 0, 0, nullptr, 0, &o.out);
     }},
    {"with_points rational",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0};
         static constexpr double weights[] = {1, 0.7071067811865476, 1, 0.7071067811865476, 1,
             0.7071067811865476, 1, 0.7071067811865476, 1};
         return nurbs_with_points(in.curve, points, 0, 0, weights, 0, &o.out);
     }},
    {"create_bezier",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {3};
         static constexpr double points[] = {0, 0, 1, 2, 3, 2, 4, 0};
         return nurbs_create_bezier(1, degrees, 2, points, 0, 0, nullptr, 0, &o.out);
     }},
    {"create_hermite",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double points[] = {0.1, 0.9, 0.3, 0.7};
         static constexpr double tangents[] = {0.1, 0.9, 0.3, 0.7};
         return nurbs_create_hermite(2, arrays::new_knots, 2, points, 0, 0, tangents, 0, 0, &o.out);
     }},
    {"parametrize",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int64_t counts[] = {4};
         static constexpr double points[] = {0, 0, 1, 2, 3, 2, 4, 0};
         return nurbs_parametrize(1, counts, 2, points, 0, 0, NURBS_PARAMS_FOLEY_NIELSON, 0, 0, o.values);
     }},
    {"params_universal",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_params_universal(3, 7, o.values);
     }},
    {"tangents",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double params[] = {0, 1, 3, 4};
         static constexpr double points[] = {0, 1, 2, 4};
         return nurbs_tangents(NURBS_TANGENTS_AKIMA, 4, params, 1, points, 0, 0, 0, o.values, 0, 0);
     }},
    {"tangents monotone",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double params[] = {0, 1, 3, 4};
         static constexpr double points[] = {0, 1, 2, 0};
         return nurbs_tangents(NURBS_TANGENTS_MONOTONE, 4, params, 1, points, 0, 0, NURBS_PERIODIC, o.values,
             0, 0);
     }},
    {"parametrize surface",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int64_t counts[] = {2, 2};
         static constexpr double points[] = {0, 0, 1, 2, 3, 2, 4, 0};
         return nurbs_parametrize(2, counts, 2, points, 0, 0, NURBS_PARAMS_CHORD, 0, 0, o.values);
     }},
    {"read",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_read(texts::file, 1134, nullptr, &o.list);
     }, true},
    {"read in millimetres",
     [](const Inputs &, Output &o) -> nurbs_status {
         nurbs_read_options options;
         (void)nurbs_read_options_init(&options, sizeof options);
         options.unit = 0.001;
         return nurbs_read(texts::file, 1134, &options, &o.list);
     }, true},
    {"read_file",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_read_file(file_path, nullptr, &o.list);
     }, true},
    {"read_file in millimetres",
     [](const Inputs &, Output &o) -> nurbs_status {
         nurbs_read_options options;
         (void)nurbs_read_options_init(&options, sizeof options);
         options.unit = 0.001;
         return nurbs_read_file(file_path, &options, &o.list);
     }, true},
    {"list_get",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_list_get(in.list, 0, &o.out);
     }},
    {"list_destroy",
     [](const Inputs &in, Output &) -> nurbs_status {
         Made made_edges(in, make_edges);
         if (made_edges.status() != NURBS_OK) {
             return made_edges.status();
         }
         nurbs_list_destroy(made_edges.release());
         return NURBS_OK;
     }},
    {"knots_uniform",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_knots_uniform(2, 5, 0, 1, 8, o.values);
     }},
    {"knots_open_uniform",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_knots_open_uniform(2, 5, 0, 1, 8, o.values);
     }},
    {"knots_bezier",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_knots_bezier(2, 2, nullptr, 8, o.values);
     }},
    {"knots_bezier with breaks",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_knots_bezier(2, 1, arrays::new_knots, 6, o.values);
     }},
    {"knots_averaged",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double params[] = {0, 1, 2, 3, 4};
         return nurbs_knots_averaged(2, 5, params, 8, o.values);
     }},
    {"knots_periodic",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double breaks[] = {0, 1, 2, 3};
         return nurbs_knots_periodic(2, 4, breaks, nullptr, 8, o.values);
     }},
    {"knots_periodic twice",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t multiplicities[] = {2, 2};
         return nurbs_knots_periodic(2, 2, arrays::new_knots, multiplicities, 7, o.values);
     }},
    {"knots",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_knots(in.curve, 0, 12, o.values);
     }},
    {"short_knots",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_short_knots(in.curve, 0, 10, o.values, o.spans);
     }},
    {"unwrapped_knots",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_unwrapped_knots(in.loop, 0, 5, o.values, o.spans);
     }},
    {"unwrapped_points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_unwrapped_points(in.loop, 4, o.values, o.values + 8, o.spans);
     }},
    {"to_bytes",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_to_bytes(in.loop, 0, o.text, o.spans);
     }},
    {"from_bytes",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_from_bytes(texts::loop_bytes, 352, &o.out);
     }},
    {"bytes_kind",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_bytes_kind(texts::loop_bytes, 352, o.states, o.states + 1, o.states + 2);
     }},
    {"list_to_bytes",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_edges(in, make_edges);
         if (made_edges.status() != NURBS_OK) {
             return made_edges.status();
         }
         return nurbs_list_to_bytes(made_edges, 0, o.text, o.spans);
     }},
    {"list_from_bytes",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_list_from_bytes(texts::list_bytes, 640, &o.list);
     }},
    {"face_to_bytes",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_face_to_bytes(in.face, 0, o.text, o.spans);
     }},
    {"face_from_bytes",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_face_from_bytes(texts::face_bytes, 960, &o.face);
     }},
    {"model_to_bytes",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_to_bytes(in.model, 0, o.text, o.spans);
     }},
    {"model_from_bytes",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_model_from_bytes(texts::model_bytes, 2112, &o.model);
     }},
    {"list_create",
     [](const Inputs &in, Output &o) -> nurbs_status {
         const nurbs *const splines[] = {in.curve, in.loop, in.curve};
         return nurbs_list_create(3, splines, nullptr, 0.001, &o.list);
     }},
    {"distinct_knots",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_distinct_knots(in.curve, 0, 5, o.values, o.states, o.spans);
     }},
    {"greville",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_greville(in.curve, 0, 9, o.values);
     }},
    {"points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_points(in.homogeneous, 3, o.values, 0, 0);
     }},
    {"weights",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_weights(in.curve, 9, o.values, 0);
     }},
    {"homogeneous_points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_homogeneous_points(in.curve, 9, o.values, 0, 0);
     }},
    {"detect_periodic",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_detect_periodic(in.curve, 0, o.states);
     }},
    {"eval_knot_derivative",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_eval_knot_derivative(in.curve, 0, 4, &o.out);
     }},
    {"eval_knot_derivative of a period",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_eval_knot_derivative(in.loop, 0, 1, &o.out);
     }},
    {"to_hermite",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_to_hermite(in.twist, 2, o.values, o.values + 2, o.values + 8, o.spans);
     }},
    {"to_power",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_to_power(in.curve, 36, o.values, o.values + 36, o.spans, o.spans + 1);
     }},
    {"to_power surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_to_power(in.surface, 54, o.values, o.values + 54, o.spans, o.spans + 2);
     }},
    {"bezier_extraction",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_bezier_extraction(in.curve, 0, 4, o.values, o.spans, o.values + 36, o.spans + 4);
     }},
    {"refinement_matrix",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_refinement_matrix(in.curve, 0, 2, arrays::new_knots, 33, o.values, o.spans, o.spans + 33,
             o.spans + 45);
     }},
    {"basis_matrix",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_basis_matrix(NURBS_BASIS_POWER, NURBS_BASIS_BSPLINE, 3, 16, o.values);
     }},
    {"decompose",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_decompose(in.surface, &o.list);
     }},
    {"bezier_pieces",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_bezier_pieces(in.surface, 3, o.values, o.values + 54, o.values + 72, o.spans, o.spans +
             2);
     }},
    {"bezier_pieces rational",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_bezier_pieces(in.curve, 4, o.values, o.values + 24, o.values + 36, o.spans, o.spans + 1);
     }},
    {"bezier_cells",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_bezier_cells(in.surface, 4, o.spans, o.states, o.spans + 24, o.spans + 25);
     }},
    {"bezier_cells closed",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_bezier_cells(in.loop, 8, o.spans, nullptr, nullptr, o.spans + 24);
     }},
    {"bezier_cell_points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_bezier_cell_points(in.surface, 32, o.values, o.values + 96, o.spans);
     }},
    {"bezier_cell_points rational",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_bezier_cell_points(in.curve, 32, o.values, o.values + 64, nullptr);
     }},
    {"split_at_knots",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_split_at_knots(in.curve, 0, 1, &o.list);
     }},
    {"boundaries",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_boundaries(in.volume, &o.list);
     }},
    {"create curve",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {2};
         static constexpr int64_t counts[] = {9};
         static constexpr double knots[] = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
         static constexpr double points[] = {1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0};
         static constexpr double weights[] = {1, 0.7071067811865476, 1, 0.7071067811865476, 1,
             0.7071067811865476, 1, 0.7071067811865476, 1};
         return nurbs_create(1, degrees, counts, knots, 12, 2, points, 0, 0, weights, 0, 0, &o.out);
     }},
    {"create loop",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {2};
         static constexpr int64_t counts[] = {6};
         static constexpr double knots[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
         static constexpr double points[] = {1, 1, -1, 1, -1, -1, 1, -1, 1, 1, -1, 1};
         return nurbs_create(1, degrees, counts, knots, 9, 2, points, 0, 0, nullptr, 0, NURBS_PERIODIC,
             &o.out);
     }},
    {"create volume",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {1, 1, 1};
         static constexpr int64_t counts[] = {2, 2, 2};
         static constexpr double knots[] = {0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1};
         static constexpr double points[] = {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 0, 0, 1, 0,
             1, 0, 1, 1, 0, 0, 1, 1, 1, 1};
         return nurbs_create(3, degrees, counts, knots, 12, 4, points, 0, 0, nullptr, 0, 0, &o.out);
     }},
    {"create_homogeneous",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {2};
         static constexpr int64_t counts[] = {6};
         static constexpr double knots[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
         static constexpr double points[] = {1, 1, 1, 2, -1, 1, -1, -1, 1, -1, 1, 2};
         return nurbs_create_homogeneous(1, degrees, counts, knots, 9, 1, points, 0, 0, 0, &o.out);
     }},
    {"create_periodic",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {2};
         static constexpr int64_t counts[] = {4};
         static constexpr double knots[] = {2, 3, 4, 5, 6};
         static constexpr double points[] = {1, 1, -1, 1, -1, -1, 1, -1};
         static constexpr double weights[] = {1, 2, 1, 0.5};
         return nurbs_create_periodic(1, degrees, counts, knots, 5, 2, points, 0, 0, weights, 0,
             NURBS_PERIODIC, &o.out);
     }},
    {"create_short",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {2};
         static constexpr int64_t counts[] = {9};
         static constexpr double knots[] = {0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1};
         static constexpr double points[] = {1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0};
         static constexpr double weights[] = {1, 0.7071067811865476, 1, 0.7071067811865476, 1,
             0.7071067811865476, 1, 0.7071067811865476, 1};
         return nurbs_create_short(1, degrees, counts, knots, 10, 2, points, 0, 0, weights, 0, 0, &o.out);
     }},
    {"create_multiplicities",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {2};
         static constexpr int64_t counts[] = {9};
         static constexpr int64_t distinct_counts[] = {5};
         static constexpr double distinct_knots[] = {0, 0.25, 0.5, 0.75, 1};
         static constexpr int32_t multiplicities[] = {3, 2, 2, 2, 3};
         static constexpr double points[] = {1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0};
         static constexpr double weights[] = {1, 0.7071067811865476, 1, 0.7071067811865476, 1,
             0.7071067811865476, 1, 0.7071067811865476, 1};
         return nurbs_create_multiplicities(1, degrees, counts, distinct_counts, distinct_knots,
             multiplicities, 2, points, 0, 0, weights, 0, 0, &o.out);
     }},
    {"create_power",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {1, 0};
         static constexpr int64_t piece_counts[] = {1, 1};
         static constexpr double breaks[] = {0, 1, 0, 1};
         static constexpr double coefficients[] = {0.1, 0.9, 0.3, 0.7};
         return nurbs_create_power(2, degrees, piece_counts, breaks, 4, 2, coefficients, 0, 0, 0, &o.out);
     }},
    {"refinement_matrix size",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_refinement_matrix(in.curve, 0, 2, arrays::new_knots, 0, nullptr, nullptr, nullptr,
             o.spans);
     }},
    {"create_bezier rational",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {3};
         static constexpr double points[] = {0, 0, 1, 2, 3, 2, 4, 0};
         static constexpr double weights[] = {1, 0.7071067811865476, 1, 0.7071067811865476};
         return nurbs_create_bezier(1, degrees, 2, points, 0, 0, weights, 0, &o.out);
     }},
    {"interpolate",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {3};
         static constexpr int64_t counts[] = {5};
         static constexpr double params[] = {0, 0.25, 0.5, 0.75, 1};
         static constexpr double points[] = {0, 0, 1, 2, 3, 2, 4, 0, 5, 5};
         return nurbs_interpolate(1, degrees, counts, params, 2, points, 0, 0, nullptr, 0, o.values, &o.out);
     }},
    {"interpolate natural",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {3};
         static constexpr int64_t counts[] = {3};
         static constexpr double params[] = {0, 0.5, 1};
         static constexpr double points[] = {0, 0, 1, 2, 3, 2};
         static constexpr int32_t ends[] = {1, 1};
         return nurbs_interpolate(1, degrees, counts, params, 2, points, 0, 0, ends, 0, o.values, &o.out);
     }},
    {"interpolate loop",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {2};
         static constexpr int64_t counts[] = {5};
         static constexpr double params[] = {0, 0.25, 0.5, 0.75, 1};
         static constexpr double points[] = {0, 1, 0, -1, 0};
         return nurbs_interpolate(1, degrees, counts, params, 1, points, 0, 0, nullptr, NURBS_PERIODIC,
             o.values, &o.out);
     }},
    {"interpolate_over_knots",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {1, 2};
         static constexpr int64_t counts[] = {2, 3};
         static constexpr double params[] = {0, 1, 0, 0.5, 1};
         static constexpr double knots[] = {0, 0, 1, 1, 0, 0, 0, 1, 1, 1};
         static constexpr double points[] = {0, 1, 2, 3, 4, 5};
         return nurbs_interpolate_over_knots(2, degrees, counts, params, knots, 10, 1, points, 0, 0, 0,
             &o.out);
     }},
    {"interpolate_derivatives",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {3, 2};
         static constexpr int64_t counts[] = {5, 3};
         static constexpr double params[] = {0, 0, 0.5, 1, 1, 0, 0.5, 1};
         static constexpr int32_t orders[] = {0, 1, 0, 0, 1, 0, 0, 0};
         static constexpr double values[] = {0, 1, 2, 1, 1, 1, 3, 4, 5, 6, 7, 8, 0, 0, 0};
         return nurbs_interpolate_derivatives(2, degrees, counts, params, orders, 1, values, 0, 0, nullptr, 0,
             &o.out);
     }},
    {"interpolate_derivatives ends",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {3, 3};
         static constexpr int64_t counts[] = {4, 4};
         static constexpr double params[] = {0, 0, 1, 1, 0, 0.5, 0.75, 1};
         static constexpr int32_t orders[] = {0, 1, 0, 1, 0, 0, 0, 0};
         static constexpr double values[] = {0, 1, 2, 1, 1, 1, 3, 0.5, 5, 6, 7, 8, 1, 0, 0, 1};
         static constexpr int32_t ends[] = {0, 0, 1, 1};
         return nurbs_interpolate_derivatives(2, degrees, counts, params, orders, 1, values, 0, 0, ends, 0,
             &o.out);
     }},
    {"curve_interpolate",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double params[] = {0, 0, 1, 1};
         static constexpr int32_t orders[] = {0, 1, 0, 1};
         static constexpr double targets[] = {0, 0, 1, 0, 2, 1, 1, 1};
         return nurbs_curve_interpolate(3, 4, params, orders, 2, targets, 0, 0, nullptr, 0, 0, &o.out);
     }},
    {"curve_interpolate directions",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double params[] = {0, 0, 1, 1};
         static constexpr int32_t orders[] = {0, -1, 0, -1};
         static constexpr double targets[] = {0, 0, 1, 0, 2, 1, 1, 1};
         return nurbs_curve_interpolate(3, 4, params, orders, 2, targets, 0, 0, nullptr, 0, 0, &o.out);
     }},
    {"curve_interpolate over knots",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double params[] = {0, 0.5, 1};
         static constexpr double targets[] = {0, 1, 0};
         static constexpr double knots[] = {0, 0, 0, 1, 1, 1};
         return nurbs_curve_interpolate(2, 3, params, nullptr, 1, targets, 0, 0, knots, 6, 0, &o.out);
     }},
    {"tangent_lengths",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double params[] = {0, 0, 1, 1};
         static constexpr int32_t orders[] = {0, -1, 0, -1};
         static constexpr double targets[] = {0, 0, 1, 0, 2, 1, 1, 1};
         return nurbs_tangent_lengths(3, 4, params, orders, 2, targets, 0, 0, nullptr, 0, 0, o.values);
     }},
    {"tangent_lengths over knots",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double params[] = {0, 0, 1};
         static constexpr int32_t orders[] = {0, -1, 0};
         static constexpr double targets[] = {0, 0, 1, 0, 2, 1};
         static constexpr double knots[] = {0, 0, 0, 1, 1, 1};
         return nurbs_tangent_lengths(2, 3, params, orders, 2, targets, 0, 0, knots, 6, 0, o.values);
     }},
    {"data_init",
     [](const Inputs &, Output &) -> nurbs_status {
         nurbs_data data;
         return nurbs_data_init(&data, sizeof(nurbs_data));
     }},
    {"statistics_create",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {1, 1};
         static constexpr int64_t break_counts[] = {2, 3};
         static constexpr double breaks[] = {0, 1, 0, 1, 2};
         return nurbs_statistics_create(2, degrees, break_counts, breaks, 5, 2, 1, 1, &o.statistics);
     }},
    {"statistics_add",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double params[] = {0.25, 0.75};
         static constexpr double values[] = {1, 2};
         static constexpr double weights[] = {1, 0.5};
         nurbs_data data = {};
         data.struct_size = sizeof(nurbs_data);
         data.n = 2;
         data.axes = 1;
         data.dim = 1;
         data.params = params;
         data.values = values;
         data.weights = weights;
         return nurbs_statistics_add(in.statistics, &data, &o.statistics);
     }},
    {"statistics_merge",
     [](const Inputs &in, Output &o) -> nurbs_status {
         const nurbs_statistics *const parts[] = {in.statistics, in.statistics, in.no_statistics};
         static constexpr int32_t signs[] = {1, -1, 1};
         return nurbs_statistics_merge(3, parts, signs, &o.statistics);
     }},
    {"statistics_clone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_statistics_clone(in.statistics, &o.statistics);
     }},
    {"statistics_destroy",
     [](const Inputs &in, Output &) -> nurbs_status {
         Made made_more_statistics(in, make_more_statistics);
         if (made_more_statistics.status() != NURBS_OK) {
             return made_more_statistics.status();
         }
         nurbs_statistics_destroy(made_more_statistics.release());
         return NURBS_OK;
     }},
    {"statistics_size",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_statistics_size(in.statistics, o.states, o.states + 1, o.spans, o.spans + 1, o.values);
     }},
    {"statistics_to_bytes",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_statistics_to_bytes(in.no_statistics, 0, o.text, o.spans);
     }},
    {"statistics_from_bytes",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_statistics_from_bytes(texts::no_data, 192, &o.statistics);
     }},
    {"fit_options_init",
     [](const Inputs &, Output &) -> nurbs_status {
         nurbs_fit_options options;
         return nurbs_fit_options_init(&options, sizeof(nurbs_fit_options));
     }},
    {"fit",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {2};
         static constexpr int64_t counts[] = {4};
         static constexpr double knots[] = {0, 0, 0, 0.5, 1, 1, 1};
         nurbs_fit_options options = {};
         options.struct_size = sizeof(nurbs_fit_options);
         options.smoothing = NURBS_SMOOTHING_LAMBDA;
         options.penalty_order = 1;
         options.lambda = 0.5;
         nurbs_fit_report report = {};
         report.struct_size = sizeof(nurbs_fit_report);
         return nurbs_fit(in.statistics, degrees, counts, knots, 7, 0, &options, &report, &o.out);
     }},
    {"fit_errors",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_ramp(in, make_ramp);
         if (made_ramp.status() != NURBS_OK) {
             return made_ramp.status();
         }
         static constexpr double params[] = {0, 0.25, 1};
         return nurbs_fit_errors(in.statistics, made_ramp, 1, 0.5, 1, 3, params, 0, 0, 0, o.values);
     }},
    {"fit_criteria",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_ramp(in, make_ramp);
         if (made_ramp.status() != NURBS_OK) {
             return made_ramp.status();
         }
         static constexpr double lambdas[] = {0.5, 2};
         return nurbs_fit_criteria(in.statistics, made_ramp, 1, 2, lambdas, o.values);
     }},
    {"fit_points",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double params[] = {0, 0, 1, 0, 0, 1, 1, 1, 0.5, 0.5, 0.25, 0.5};
         static constexpr double values[] = {0, 1, 2, 1, 0, 1};
         nurbs_data data = {};
         data.struct_size = sizeof(nurbs_data);
         data.n = 6;
         data.axes = 2;
         data.dim = 1;
         data.params = params;
         data.values = values;
         static constexpr int32_t degrees[] = {1, 1};
         static constexpr int64_t counts[] = {2, 2};
         static constexpr double knots[] = {0, 0, 1, 1, 0, 0, 1, 1};
         nurbs_fit_options options = {};
         options.struct_size = sizeof(nurbs_fit_options);
         options.smoothing = NURBS_SMOOTHING_GCV;
         options.penalty_order = 1;
         nurbs_fit_report report = {};
         report.struct_size = sizeof(nurbs_fit_report);
         return nurbs_fit_points(&data, degrees, counts, knots, 8, 0, &options, &report, &o.out);
     }},
    {"fit_tolerance",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double params[] = {0, 0.25, 0.5, 0.75, 1};
         static constexpr double values[] = {0, 1, 2, 1, 0, 0, 1, 1, 2, 1};
         nurbs_data data = {};
         data.struct_size = sizeof(nurbs_data);
         data.n = 5;
         data.axes = 1;
         data.dim = 2;
         data.params = params;
         data.values = values;
         static constexpr int32_t degrees[] = {2};
         static constexpr double domain[] = {0, 1};
         nurbs_fit_options options = {};
         options.struct_size = sizeof(nurbs_fit_options);
         options.smoothing = NURBS_SMOOTHING_NONE;
         options.penalty_order = 2;
         nurbs_fit_report report = {};
         report.struct_size = sizeof(nurbs_fit_report);
         return nurbs_fit_tolerance(&data, degrees, domain, 0.01, 0, 0, &options, &report, &o.out);
     }, true},
    {"cloud_start",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {1};
         static constexpr int64_t counts[] = {3};
         static constexpr double knots[] = {0, 0, 0.5, 1, 1};
         static constexpr double points[] = {0, 0, 1, 1, 2, 1};
         return nurbs_cloud_start(1, degrees, counts, knots, 5, 3, 2, points, 0, 0, 0, &o.out);
     }},
    {"cloud_options_init",
     [](const Inputs &, Output &) -> nurbs_status {
         nurbs_cloud_options options;
         return nurbs_cloud_options_init(&options, sizeof(nurbs_cloud_options));
     }},
    {"fit_cloud",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0, 0, 0, 1, 1, 0, 2, 1, 2};
         static constexpr double weights[] = {1, 2, 1};
         nurbs_cloud_options options;
         (void)nurbs_cloud_options_init(&options, sizeof options);
         options.penalty_order = 2;
         options.rounds = 3;
         options.lambda = 0.5;
         options.first_lambda = 1;
         options.tolerance = 0.001;
         nurbs_cloud_report report = {};
         report.struct_size = sizeof(nurbs_cloud_report);
         return nurbs_fit_cloud(in.twist, 3, points, 0, 0, weights, 0, &options, &report, &o.out);
     }, true},
    {"approximate",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {3};
         return nurbs_approximate(in.curve, degrees, 0.3, 0, o.values, &o.out);
     }, true},
    {"face_create",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_south(in, make_south);
         if (made_south.status() != NURBS_OK) {
             return made_south.status();
         }
         Made made_east(in, make_east);
         if (made_east.status() != NURBS_OK) {
             return made_east.status();
         }
         Made made_north(in, make_north);
         if (made_north.status() != NURBS_OK) {
             return made_north.status();
         }
         Made made_west(in, make_west);
         if (made_west.status() != NURBS_OK) {
             return made_west.status();
         }
         static constexpr int64_t sizes[] = {1, 4};
         const nurbs *const curves[] = {in.outline, made_south, made_east, made_north, made_west};
         static constexpr int64_t keys[] = {0, 7, -8, 0, 9};
         return nurbs_face_create(in.surface, 2, sizes, curves, nullptr, keys, 0.001, NURBS_KEEP_GAPS, nullptr,
             &o.face);
     }},
    {"face_create without crossings",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_south(in, make_south);
         if (made_south.status() != NURBS_OK) {
             return made_south.status();
         }
         Made made_east(in, make_east);
         if (made_east.status() != NURBS_OK) {
             return made_east.status();
         }
         Made made_north(in, make_north);
         if (made_north.status() != NURBS_OK) {
             return made_north.status();
         }
         Made made_west(in, make_west);
         if (made_west.status() != NURBS_OK) {
             return made_west.status();
         }
         static constexpr int64_t sizes[] = {4};
         const nurbs *const curves[] = {made_south, made_east, made_north, made_west};
         return nurbs_face_create(in.surface, 1, sizes, curves, nullptr, nullptr, 0.001, NURBS_CHECK_CROSSINGS,
             nullptr, &o.face);
     }},
    {"face_create of edges",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_first_edge(in, make_first_edge);
         if (made_first_edge.status() != NURBS_OK) {
             return made_first_edge.status();
         }
         Made made_second_edge(in, make_second_edge);
         if (made_second_edge.status() != NURBS_OK) {
             return made_second_edge.status();
         }
         Made made_third_edge(in, make_third_edge);
         if (made_third_edge.status() != NURBS_OK) {
             return made_third_edge.status();
         }
         static constexpr int64_t sizes[] = {3};
         const nurbs *const edges[] = {made_first_edge, made_second_edge, made_third_edge};
         static constexpr int64_t keys[] = {1, 2, 3};
         return nurbs_face_create(in.surface, 1, sizes, nullptr, edges, keys, 1e-09, 0, nullptr, &o.face);
     }},
    {"face_create whole",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_face_create(in.surface, 0, nullptr, nullptr, nullptr, nullptr, 0, 0, nullptr, &o.face);
     }},
    {"face_clone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_face_clone(in.face, &o.face);
     }},
    {"face_destroy",
     [](const Inputs &in, Output &) -> nurbs_status {
         Made made_another_face(in, make_another_face);
         if (made_another_face.status() != NURBS_OK) {
             return made_another_face.status();
         }
         nurbs_face_destroy(made_another_face.release());
         return NURBS_OK;
     }},
    {"face_surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_face_surface(in.face, &o.out);
     }},
    {"face_loops",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_face_loops(in.face, 1, o.spans, o.spans + 1);
     }},
    {"face_curve",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_face_curve(in.face, 0, 0, &o.out);
     }},
    {"face_edge",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_face_edge(in.face, 0, 0, o.spans, &o.out);
     }},
    {"face_deviation",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_face_deviation(in.face, 0, 0, o.values, o.states);
     }},
    {"face_tolerance",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_face_tolerance(in.face, o.values);
     }},
    {"face_classify",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_face_classify(in.face, 3, arrays::params, 0, 0, 0, o.states);
     }},
    {"face_area",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_face_area(in.face, 1e-06, o.values, o.values + 1);
     }},
    {"face_moments",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_face_moments(in.face, 1e-06, o.values, o.values + 1, o.values + 4, o.values + 13);
     }},
    {"face_quadrature",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_face_quadrature(in.face, 1, 64, o.values, o.values + 128, o.values + 192, o.spans);
     }},
    {"face_box",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_face_box(in.face, 0.001, o.values, o.values + 3, o.values + 6);
     }},
    {"read_model",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_read_model(texts::solid, 963, nullptr, &o.model);
     }, true},
    {"read_model in millimetres",
     [](const Inputs &, Output &o) -> nurbs_status {
         nurbs_read_options options;
         (void)nurbs_read_options_init(&options, sizeof options);
         options.unit = 0.001;
         return nurbs_read_model(texts::solid, 963, &options, &o.model);
     }, true},
    {"read_model_file",
     [](const Inputs &, Output &o) -> nurbs_status {
         return nurbs_read_model_file(solid_path, nullptr, &o.model);
     }, true},
    {"read_model_file in millimetres",
     [](const Inputs &, Output &o) -> nurbs_status {
         nurbs_read_options options;
         (void)nurbs_read_options_init(&options, sizeof options);
         options.unit = 0.001;
         return nurbs_read_model_file(solid_path, &options, &o.model);
     }, true},
    {"model_create",
     [](const Inputs &in, Output &o) -> nurbs_status {
         const nurbs_face *const faces[] = {in.face, in.face};
         return nurbs_model_create(2, faces, 0.001, &o.model);
     }},
    {"model_sew",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         const nurbs_face *const faces[] = {in.face, made_ball_face};
         return nurbs_model_sew(2, faces, 1e-06, 0.001, &o.model);
     }},
    {"region_create",
     [](const Inputs &in, Output &o) -> nurbs_status {
         const nurbs *const curves[] = {in.outline};
         return nurbs_region_create(1, curves, 1, 0, &o.model);
     }, true},
    {"region_combine",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_moved_outline(in, make_moved_outline);
         if (made_moved_outline.status() != NURBS_OK) {
             return made_moved_outline.status();
         }
         Made made_moved_face(in, make_moved_face);
         if (made_moved_face.status() != NURBS_OK) {
             return made_moved_face.status();
         }
         const nurbs_face *const a[] = {in.face};
         const nurbs_face *const b[] = {made_moved_face};
         return nurbs_region_combine(3, 1, a, 1, b, 0, &o.model);
     }, true},
    {"face_split",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_divider(in, make_divider);
         if (made_divider.status() != NURBS_OK) {
             return made_divider.status();
         }
         const nurbs *const curves[] = {made_divider};
         return nurbs_face_split(in.face, 1, curves, 0, &o.model);
     }, true},
    {"face_trim",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_cutter(in, make_cutter);
         if (made_cutter.status() != NURBS_OK) {
             return made_cutter.status();
         }
         return nurbs_face_trim(in.face, made_cutter, 1, 1e-06, &o.model);
     }, true},
    {"model_edge_gaps",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_edge_gaps(in.model, 8, o.spans, o.values, o.states, o.spans + 8);
     }},
    {"model_clone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_clone(in.model, &o.model);
     }},
    {"model_destroy",
     [](const Inputs &in, Output &) -> nurbs_status {
         Made made_another_model(in, make_another_model);
         if (made_another_model.status() != NURBS_OK) {
             return made_another_model.status();
         }
         nurbs_model_destroy(made_another_model.release());
         return NURBS_OK;
     }},
    {"model_face",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_face(in.model, 1, o.spans, o.states, o.states + 1, o.values, &o.face);
     }},
    {"model_edge",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_edge(in.model, 1, o.spans, o.spans + 1, o.states, &o.out);
     }},
    {"model_splines",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_splines(in.model, &o.list);
     }},
    {"write_options_init",
     [](const Inputs &, Output &) -> nurbs_status {
         nurbs_write_options options;
         return nurbs_write_options_init(&options, sizeof(nurbs_write_options));
     }},
    {"model_write",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_model_write(in.model, 1, nullptr, 0, o.text, o.spans);
     }},
    {"model_write in inches",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         options.tolerance = 0.001;
         return nurbs_model_write(in.model, 1, &options, 0, o.text, o.spans);
     }},
    {"model_write as IGES",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         options.tolerance = 0.001;
         return nurbs_model_write(in.model, 2, &options, 0, o.text, o.spans);
     }},
    {"model_write_file",
     [](const Inputs &in, Output &) -> nurbs_status {
         return nurbs_model_write_file(in.model, replaced_path, 1, nullptr);
     }},
    {"model_write_file in inches",
     [](const Inputs &in, Output &) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         return nurbs_model_write_file(in.model, replaced_path, 1, &options);
     }},
    {"list_write",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_edges(in, make_edges);
         if (made_edges.status() != NURBS_OK) {
             return made_edges.status();
         }
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         options.tolerance = 0.001;
         return nurbs_list_write(made_edges, 1, &options, 0, o.text, o.spans);
     }},
    {"list_write as IGES",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_edges(in, make_edges);
         if (made_edges.status() != NURBS_OK) {
             return made_edges.status();
         }
         return nurbs_list_write(made_edges, 2, nullptr, 0, o.text, o.spans);
     }},
    {"list_write_file",
     [](const Inputs &in, Output &) -> nurbs_status {
         Made made_edges(in, make_edges);
         if (made_edges.status() != NURBS_OK) {
             return made_edges.status();
         }
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         return nurbs_list_write_file(made_edges, replaced_path, 1, &options);
     }},
    {"surface_sections in two planes",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double normal[] = {0, 0.5, 2};
         static constexpr double offsets[] = {1, 3};
         return nurbs_surface_sections(in.surface, normal, 2, offsets, 0.01, &o.meet);
     }},
    {"surface_sections",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double normal[] = {0, 0, 1};
         static constexpr double offsets[] = {1.5};
         return nurbs_surface_sections(in.surface, normal, 1, offsets, 0.0001, &o.meet);
     }},
    {"surface_contours along a direction",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double d[] = {0.2, 0.1, 1};
         return nurbs_surface_contours(in.surface, 1, d, 0, nullptr, 0.01, &o.meet);
     }},
    {"surface_contours",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double d[] = {0, 0, 2};
         static constexpr double cosines[] = {0.9};
         return nurbs_surface_contours(in.surface, 3, d, 1, cosines, 0.01, &o.meet);
     }},
    {"surface_reflections of normals",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double direction[] = {0, 0, 1};
         static constexpr double points[] = {0.5, 0.25, 0};
         return nurbs_surface_reflections(in.surface, 1, nullptr, direction, 1, points, 0, 0, 0.01, &o.meet);
     }},
    {"surface_reflections",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double eye[] = {0.1, 0, -1};
         static constexpr double direction[] = {1, 0, 0};
         static constexpr double points[] = {0, 0.5, 6, 0, 1, 6};
         return nurbs_surface_reflections(in.surface, 2, eye, direction, 2, points, 0, 0, 0.01, &o.meet);
     }},
    {"surface_level",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double coefficients[] = {0, 0, 1, -1.5};
         return nurbs_surface_level(in.surface, 1, coefficients, 0.01, &o.meet);
     }},
    {"surface_level_curves",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_heights(in, make_heights);
         if (made_heights.status() != NURBS_OK) {
             return made_heights.status();
         }
         static constexpr double values[] = {0.5};
         return nurbs_surface_level_curves(in.surface, made_heights, 1, values, 0.01, &o.meet);
     }},
    {"surface_intersections",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_wall(in, make_wall);
         if (made_wall.status() != NURBS_OK) {
             return made_wall.status();
         }
         return nurbs_surface_intersections(made_wall, in.surface, 0.1, &o.meet);
     }},
    {"surface_self_intersections",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_surface_self_intersections(in.surface, 0.1, &o.meet);
     }},
    {"face_intersections",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_wall(in, make_wall);
         if (made_wall.status() != NURBS_OK) {
             return made_wall.status();
         }
         Made made_upright_outline(in, make_upright_outline);
         if (made_upright_outline.status() != NURBS_OK) {
             return made_upright_outline.status();
         }
         Made made_upright(in, make_upright);
         if (made_upright.status() != NURBS_OK) {
             return made_upright.status();
         }
         return nurbs_face_intersections(in.face, made_upright, 0.1, &o.meet);
     }},
    {"meet_kinds",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_meet_kinds(in.meet, 4, o.states, o.spans);
     }},
    {"surface_project_curve",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_wall(in, make_wall);
         if (made_wall.status() != NURBS_OK) {
             return made_wall.status();
         }
         static constexpr double direction[] = {1, 0.2, 0.1};
         return nurbs_surface_project_curve(made_wall, in.twist, direction, 0.01, &o.meet);
     }, true},
    {"face_project_curve",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double direction[] = {0, 0, 1};
         return nurbs_face_project_curve(in.face, in.twist, direction, 0.1, &o.meet);
     }, true},
    {"model_sections",
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
         static constexpr double normals[] = {0, 0, 1};
         static constexpr double offsets[] = {0.1};
         return nurbs_model_sections(made_ball, 1, normals, offsets, 0.1, &o.meet);
     }},
    {"model_intersections",
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
         return nurbs_model_intersections(in.model, made_ball, 0.1, &o.meet);
     }},
    {"meet_faces_second",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_meet_faces_second(in.meet, 4, o.spans, o.spans + 4, o.spans + 8);
     }},
    {"meet_joints_second",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_meet_joints_second(in.meet, 8, o.spans, o.spans + 8, o.spans + 16);
     }},
    {"meet_ways",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_meet_ways(in.meet, 4, o.spans, o.spans + 4, o.spans + 8, o.states, o.values, o.spans +
             12);
     }},
    {"meet_ways closed",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_meet_ways(in.meet, 4, nullptr, nullptr, nullptr, o.states, nullptr, nullptr);
     }},
    {"meet_faces",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_meet_faces(in.meet, 4, o.spans, o.spans + 4, o.spans + 8);
     }},
    {"meet_joints",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_meet_joints(in.meet, 8, o.spans, o.values, o.spans + 8, o.spans + 16, o.spans + 24);
     }},
    {"meet_trim",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_meet_trim(in.meet, in.face, &o.meet);
     }},
    {"meet_trim_second",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_wall(in, make_wall);
         if (made_wall.status() != NURBS_OK) {
             return made_wall.status();
         }
         Made made_crossing(in, make_crossing);
         if (made_crossing.status() != NURBS_OK) {
             return made_crossing.status();
         }
         return nurbs_meet_trim_second(made_crossing, in.face, &o.meet);
     }},
    {"mesh_options_init",
     [](const Inputs &, Output &) -> nurbs_status {
         nurbs_mesh_options options;
         return nurbs_mesh_options_init(&options, sizeof(nurbs_mesh_options));
     }},
    {"mesh_surface",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.chord = 1;
         options.relative_chord = 0;
         return nurbs_mesh_surface(in.surface, &options, &o.mesh);
     }},
    {"mesh_surface by length",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.chord = 10;
         options.relative_chord = 0;
         options.longest = 1.5;
         return nurbs_mesh_surface(in.surface, &options, &o.mesh);
     }},
    {"mesh_surface by angle",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.chord = 10;
         options.relative_chord = 0;
         options.angle = 0.5;
         return nurbs_mesh_surface(in.surface, &options, &o.mesh);
     }},
    {"mesh_face",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.chord = 1;
         options.relative_chord = 0;
         return nurbs_mesh_face(in.face, &options, &o.mesh);
     }, true},
    {"mesh_model",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.chord = 1;
         options.relative_chord = 0;
         return nurbs_mesh_model(in.model, &options, &o.mesh);
     }, true},
    {"mesh_surface without small angles",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.chord = 10;
         options.relative_chord = 0;
         options.minimum_angle = 0.4;
         return nurbs_mesh_surface(in.surface, &options, &o.mesh);
     }},
    {"mesh_surface_levels",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double chords[] = {1};
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.longest = 10;
         return nurbs_mesh_surface_levels(in.surface, 1, chords, &options, &o.mesh);
     }},
    {"mesh_face_levels",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double chords[] = {1};
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.longest = 10;
         return nurbs_mesh_face_levels(in.face, 1, chords, &options, &o.mesh);
     }, true},
    {"mesh_model_levels",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double chords[] = {1};
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.longest = 10;
         return nurbs_mesh_model_levels(in.model, 1, chords, &options, &o.mesh);
     }, true},
    {"mesh_volume",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.chord = 0.1;
         options.relative_chord = 0;
         return nurbs_mesh_volume(in.solid, &options, 100, &o.mesh);
     }, true},
    {"mesh_points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_points(in.mesh, 16, o.values, o.spans);
     }},
    {"mesh_points_f32",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_points_f32(in.mesh, 16, o.singles, o.spans);
     }},
    {"mesh_vertices",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_vertices(in.mesh, 16, o.spans, o.values, o.values + 32, o.spans + 16);
     }},
    {"mesh_vertices normals",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_vertices(in.mesh, 16, nullptr, nullptr, o.values, nullptr);
     }},
    {"mesh_vertices_f32",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_vertices_f32(in.mesh, 8, o.singles, o.singles + 24, o.singles + 40, o.spans);
     }},
    {"mesh_triangles",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_triangles(in.mesh, 0, 16, o.spans, o.spans + 48);
     }},
    {"mesh_triangles welded",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_triangles(in.mesh, NURBS_MESH_WELDED, 16, o.spans, o.spans + 48);
     }},
    {"mesh_triangles_i32",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_triangles_i32(in.mesh, 0, 16, o.states, o.spans);
     }},
    {"mesh_quads",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_quads(in.mesh, 0, 4, o.spans, o.spans + 16, o.spans + 20);
     }},
    {"mesh_quads welded",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_quads(in.mesh, NURBS_MESH_WELDED, 4, o.spans, o.spans + 16, o.spans + 20);
     }},
    {"mesh_faces",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_faces(in.mesh, 2, o.spans, o.spans + 2, o.spans + 4, o.spans + 6, o.values, o.values
             + 2, o.states, o.spans + 8);
     }},
    {"mesh_edges",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_edges(in.mesh, 4, o.spans, o.spans + 4, o.spans + 8, o.values, o.states, o.spans +
             12);
     }},
    {"mesh_edge_points",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_edge_points(in.mesh, 16, o.spans, o.spans + 16);
     }},
    {"mesh_write",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_write(in.mesh, 3, nullptr, 0, o.text, o.spans);
     }},
    {"mesh_write as text",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         return nurbs_mesh_write(in.mesh, 4, &options, 0, o.text, o.spans);
     }},
    {"mesh_write as OBJ",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         return nurbs_mesh_write(in.mesh, 5, &options, 0, o.text, o.spans);
     }},
    {"mesh_write as PLY",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         return nurbs_mesh_write(in.mesh, 6, &options, 0, o.text, o.spans);
     }},
    {"mesh_write as GLB",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         return nurbs_mesh_write(in.mesh, 7, &options, 0, o.text, o.spans);
     }},
    {"mesh_write as VTU",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         return nurbs_mesh_write(in.mesh, 8, &options, 0, o.text, o.spans);
     }},
    {"mesh_write_file",
     [](const Inputs &in, Output &) -> nurbs_status {
         return nurbs_mesh_write_file(in.mesh, replaced_path, 8, nullptr);
     }},
    {"mesh_write_file in inches",
     [](const Inputs &in, Output &) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         return nurbs_mesh_write_file(in.mesh, replaced_path, 3, &options);
     }},
    {"mesh_hexahedra",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_hexahedra(in.block, 3, o.spans, o.values, o.states, o.states + 3, o.spans + 24);
     }},
    {"mesh_clone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_mesh_clone(in.mesh, &o.mesh);
     }},
    {"meet_clone",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_meet_clone(in.meet, &o.meet);
     }},
    {"meet_destroy",
     [](const Inputs &in, Output &) -> nurbs_status {
         Made made_another_meet(in, make_another_meet);
         if (made_another_meet.status() != NURBS_OK) {
             return made_another_meet.status();
         }
         nurbs_meet_destroy(made_another_meet.release());
         return NURBS_OK;
     }},
    {"mesh_destroy",
     [](const Inputs &in, Output &) -> nurbs_status {
         Made made_another_mesh(in, make_another_mesh);
         if (made_another_mesh.status() != NURBS_OK) {
             return made_another_mesh.status();
         }
         nurbs_mesh_destroy(made_another_mesh.release());
         return NURBS_OK;
     }},
    {"meet_branches",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_meet_branches(in.meet, 4, o.spans, o.spans + 4, o.spans + 12, o.values, o.spans + 16);
     }},
    {"meet_branches levels",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_meet_branches(in.meet, 4, o.spans, nullptr, nullptr, nullptr, nullptr);
     }},
    {"meet_branch",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_meet_branch(in.meet, 1, &o.out, &o.other);
     }},
    {"meet_branch_second",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_wall(in, make_wall);
         if (made_wall.status() != NURBS_OK) {
             return made_wall.status();
         }
         Made made_crossing(in, make_crossing);
         if (made_crossing.status() != NURBS_OK) {
             return made_crossing.status();
         }
         return nurbs_meet_branch_second(made_crossing, 0, &o.out);
     }},
    {"meet_nodes",
     [](const Inputs &in, Output &o) -> nurbs_status {
         return nurbs_meet_nodes(in.meet, 8, o.spans, o.states, o.values, o.values + 16, o.spans + 8);
     }},
    {"meet_nodes_second",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_wall(in, make_wall);
         if (made_wall.status() != NURBS_OK) {
             return made_wall.status();
         }
         Made made_crossing(in, make_crossing);
         if (made_crossing.status() != NURBS_OK) {
             return made_crossing.status();
         }
         return nurbs_meet_nodes_second(made_crossing, 2, o.values, o.values + 4, o.spans);
     }},
    {"read_with",
     [](const Inputs &, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_read_with(texts::file, 1134, nullptr, &call, &o.list);
     }, true},
    {"read_with in millimetres",
     [](const Inputs &, Output &o) -> nurbs_status {
         nurbs_read_options options;
         (void)nurbs_read_options_init(&options, sizeof options);
         options.unit = 0.001;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_read_with(texts::file, 1134, &options, &call, &o.list);
     }, true},
    {"read_file_with",
     [](const Inputs &, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_read_file_with(file_path, nullptr, &call, &o.list);
     }, true},
    {"read_file_with in millimetres",
     [](const Inputs &, Output &o) -> nurbs_status {
         nurbs_read_options options;
         (void)nurbs_read_options_init(&options, sizeof options);
         options.unit = 0.001;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_read_file_with(file_path, &options, &call, &o.list);
     }, true},
    {"statistics_add_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double params[] = {0.25, 0.75};
         static constexpr double values[] = {1, 2};
         static constexpr double weights[] = {1, 0.5};
         nurbs_data data = {};
         data.struct_size = sizeof(nurbs_data);
         data.n = 2;
         data.axes = 1;
         data.dim = 1;
         data.params = params;
         data.values = values;
         data.weights = weights;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_statistics_add_with(in.statistics, &data, &call, &o.statistics);
     }},
    {"fit_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {2};
         static constexpr int64_t counts[] = {4};
         static constexpr double knots[] = {0, 0, 0, 0.5, 1, 1, 1};
         nurbs_fit_options options = {};
         options.struct_size = sizeof(nurbs_fit_options);
         options.smoothing = NURBS_SMOOTHING_LAMBDA;
         options.penalty_order = 1;
         options.lambda = 0.5;
         nurbs_fit_report report = {};
         report.struct_size = sizeof(nurbs_fit_report);
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_fit_with(in.statistics, degrees, counts, knots, 7, 0, &options, &report, &call, &o.out);
     }},
    {"fit_errors_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_ramp(in, make_ramp);
         if (made_ramp.status() != NURBS_OK) {
             return made_ramp.status();
         }
         static constexpr double params[] = {0, 0.25, 1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_fit_errors_with(in.statistics, made_ramp, 1, 0.5, 1, 3, params, 0, 0, 0, o.values,
             &call);
     }},
    {"fit_criteria_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_ramp(in, make_ramp);
         if (made_ramp.status() != NURBS_OK) {
             return made_ramp.status();
         }
         static constexpr double lambdas[] = {0.5, 2};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_fit_criteria_with(in.statistics, made_ramp, 1, 2, lambdas, o.values, &call);
     }},
    {"fit_points_with",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double params[] = {0, 0, 1, 0, 0, 1, 1, 1, 0.5, 0.5, 0.25, 0.5};
         static constexpr double values[] = {0, 1, 2, 1, 0, 1};
         nurbs_data data = {};
         data.struct_size = sizeof(nurbs_data);
         data.n = 6;
         data.axes = 2;
         data.dim = 1;
         data.params = params;
         data.values = values;
         static constexpr int32_t degrees[] = {1, 1};
         static constexpr int64_t counts[] = {2, 2};
         static constexpr double knots[] = {0, 0, 1, 1, 0, 0, 1, 1};
         nurbs_fit_options options = {};
         options.struct_size = sizeof(nurbs_fit_options);
         options.smoothing = NURBS_SMOOTHING_GCV;
         options.penalty_order = 1;
         nurbs_fit_report report = {};
         report.struct_size = sizeof(nurbs_fit_report);
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_fit_points_with(&data, degrees, counts, knots, 8, 0, &options, &report, &call, &o.out);
     }},
    {"fit_tolerance_with",
     [](const Inputs &, Output &o) -> nurbs_status {
         static constexpr double params[] = {0, 0.25, 0.5, 0.75, 1};
         static constexpr double values[] = {0, 1, 2, 1, 0, 0, 1, 1, 2, 1};
         nurbs_data data = {};
         data.struct_size = sizeof(nurbs_data);
         data.n = 5;
         data.axes = 1;
         data.dim = 2;
         data.params = params;
         data.values = values;
         static constexpr int32_t degrees[] = {2};
         static constexpr double domain[] = {0, 1};
         nurbs_fit_options options = {};
         options.struct_size = sizeof(nurbs_fit_options);
         options.smoothing = NURBS_SMOOTHING_NONE;
         options.penalty_order = 2;
         nurbs_fit_report report = {};
         report.struct_size = sizeof(nurbs_fit_report);
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_fit_tolerance_with(&data, degrees, domain, 0.01, 0, 0, &options, &report, &call, &o.out);
     }, true},
    {"fit_cloud_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double points[] = {0, 0, 0, 1, 1, 0, 2, 1, 2};
         static constexpr double weights[] = {1, 2, 1};
         nurbs_cloud_options options;
         (void)nurbs_cloud_options_init(&options, sizeof options);
         options.penalty_order = 2;
         options.rounds = 3;
         options.lambda = 0.5;
         options.first_lambda = 1;
         options.tolerance = 0.001;
         nurbs_cloud_report report = {};
         report.struct_size = sizeof(nurbs_cloud_report);
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_fit_cloud_with(in.twist, 3, points, 0, 0, weights, 0, &options, &report, &call, &o.out);
     }, true},
    {"approximate_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr int32_t degrees[] = {3};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_approximate_with(in.curve, degrees, 0.3, 0, o.values, &call, &o.out);
     }, true},
    {"face_create_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_south(in, make_south);
         if (made_south.status() != NURBS_OK) {
             return made_south.status();
         }
         Made made_east(in, make_east);
         if (made_east.status() != NURBS_OK) {
             return made_east.status();
         }
         Made made_north(in, make_north);
         if (made_north.status() != NURBS_OK) {
             return made_north.status();
         }
         Made made_west(in, make_west);
         if (made_west.status() != NURBS_OK) {
             return made_west.status();
         }
         static constexpr int64_t sizes[] = {1, 4};
         const nurbs *const curves[] = {in.outline, made_south, made_east, made_north, made_west};
         static constexpr int64_t keys[] = {0, 7, -8, 0, 9};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_create_with(in.surface, 2, sizes, curves, nullptr, keys, 0.001, NURBS_KEEP_GAPS,
             nullptr, &call, &o.face);
     }},
    {"face_create_with without crossings",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_south(in, make_south);
         if (made_south.status() != NURBS_OK) {
             return made_south.status();
         }
         Made made_east(in, make_east);
         if (made_east.status() != NURBS_OK) {
             return made_east.status();
         }
         Made made_north(in, make_north);
         if (made_north.status() != NURBS_OK) {
             return made_north.status();
         }
         Made made_west(in, make_west);
         if (made_west.status() != NURBS_OK) {
             return made_west.status();
         }
         static constexpr int64_t sizes[] = {4};
         const nurbs *const curves[] = {made_south, made_east, made_north, made_west};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_create_with(in.surface, 1, sizes, curves, nullptr, nullptr, 0.001,
             NURBS_CHECK_CROSSINGS, nullptr, &call, &o.face);
     }},
    {"face_create_with of edges",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_first_edge(in, make_first_edge);
         if (made_first_edge.status() != NURBS_OK) {
             return made_first_edge.status();
         }
         Made made_second_edge(in, make_second_edge);
         if (made_second_edge.status() != NURBS_OK) {
             return made_second_edge.status();
         }
         Made made_third_edge(in, make_third_edge);
         if (made_third_edge.status() != NURBS_OK) {
             return made_third_edge.status();
         }
         static constexpr int64_t sizes[] = {3};
         const nurbs *const edges[] = {made_first_edge, made_second_edge, made_third_edge};
         static constexpr int64_t keys[] = {1, 2, 3};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_create_with(in.surface, 1, sizes, nullptr, edges, keys, 1e-09, 0, nullptr, &call,
             &o.face);
     }},
    {"face_create_with whole",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_create_with(in.surface, 0, nullptr, nullptr, nullptr, nullptr, 0, 0, nullptr, &call,
             &o.face);
     }},
    {"face_classify_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_classify_with(in.face, 3, arrays::params, 0, 0, 0, o.states, &call);
     }},
    {"face_area_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_area_with(in.face, 1e-06, o.values, o.values + 1, &call);
     }},
    {"face_moments_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_moments_with(in.face, 1e-06, o.values, o.values + 1, o.values + 4, o.values + 13,
             &call);
     }},
    {"face_quadrature_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_quadrature_with(in.face, 1, 64, o.values, o.values + 128, o.values + 192, o.spans,
             &call);
     }},
    {"face_box_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_box_with(in.face, 0.001, o.values, o.values + 3, o.values + 6, &call);
     }},
    {"read_model_with",
     [](const Inputs &, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_read_model_with(texts::solid, 963, nullptr, &call, &o.model);
     }, true},
    {"read_model_with in millimetres",
     [](const Inputs &, Output &o) -> nurbs_status {
         nurbs_read_options options;
         (void)nurbs_read_options_init(&options, sizeof options);
         options.unit = 0.001;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_read_model_with(texts::solid, 963, &options, &call, &o.model);
     }, true},
    {"read_model_file_with",
     [](const Inputs &, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_read_model_file_with(solid_path, nullptr, &call, &o.model);
     }, true},
    {"read_model_file_with in millimetres",
     [](const Inputs &, Output &o) -> nurbs_status {
         nurbs_read_options options;
         (void)nurbs_read_options_init(&options, sizeof options);
         options.unit = 0.001;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_read_model_file_with(solid_path, &options, &call, &o.model);
     }, true},
    {"model_sew_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_sphere(in, make_sphere);
         if (made_sphere.status() != NURBS_OK) {
             return made_sphere.status();
         }
         Made made_ball_face(in, make_ball_face);
         if (made_ball_face.status() != NURBS_OK) {
             return made_ball_face.status();
         }
         const nurbs_face *const faces[] = {in.face, made_ball_face};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_sew_with(2, faces, 1e-06, 0.001, &call, &o.model);
     }},
    {"region_create_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         const nurbs *const curves[] = {in.outline};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_region_create_with(1, curves, 1, 0, &call, &o.model);
     }, true},
    {"region_combine_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_moved_outline(in, make_moved_outline);
         if (made_moved_outline.status() != NURBS_OK) {
             return made_moved_outline.status();
         }
         Made made_moved_face(in, make_moved_face);
         if (made_moved_face.status() != NURBS_OK) {
             return made_moved_face.status();
         }
         const nurbs_face *const a[] = {in.face};
         const nurbs_face *const b[] = {made_moved_face};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_region_combine_with(3, 1, a, 1, b, 0, &call, &o.model);
     }, true},
    {"face_split_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_divider(in, make_divider);
         if (made_divider.status() != NURBS_OK) {
             return made_divider.status();
         }
         const nurbs *const curves[] = {made_divider};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_split_with(in.face, 1, curves, 0, &call, &o.model);
     }, true},
    {"face_trim_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_cutter(in, make_cutter);
         if (made_cutter.status() != NURBS_OK) {
             return made_cutter.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_trim_with(in.face, made_cutter, 1, 1e-06, &call, &o.model);
     }, true},
    {"model_write_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_write_with(in.model, 1, nullptr, 0, o.text, o.spans, &call);
     }},
    {"model_write_with in inches",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         options.tolerance = 0.001;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_write_with(in.model, 1, &options, 0, o.text, o.spans, &call);
     }},
    {"model_write_with as IGES",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         options.tolerance = 0.001;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_write_with(in.model, 2, &options, 0, o.text, o.spans, &call);
     }},
    {"model_write_file_with",
     [](const Inputs &in, Output &) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_write_file_with(in.model, replaced_path, 1, nullptr, &call);
     }},
    {"model_write_file_with in inches",
     [](const Inputs &in, Output &) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_write_file_with(in.model, replaced_path, 1, &options, &call);
     }},
    {"list_write_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_edges(in, make_edges);
         if (made_edges.status() != NURBS_OK) {
             return made_edges.status();
         }
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         options.tolerance = 0.001;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_list_write_with(made_edges, 1, &options, 0, o.text, o.spans, &call);
     }},
    {"list_write_with as IGES",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_edges(in, make_edges);
         if (made_edges.status() != NURBS_OK) {
             return made_edges.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_list_write_with(made_edges, 2, nullptr, 0, o.text, o.spans, &call);
     }},
    {"list_write_file_with",
     [](const Inputs &in, Output &) -> nurbs_status {
         Made made_edges(in, make_edges);
         if (made_edges.status() != NURBS_OK) {
             return made_edges.status();
         }
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_list_write_file_with(made_edges, replaced_path, 1, &options, &call);
     }},
    {"surface_sections_with in two planes",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double normal[] = {0, 0.5, 2};
         static constexpr double offsets[] = {1, 3};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_sections_with(in.surface, normal, 2, offsets, 0.01, &call, &o.meet);
     }},
    {"surface_sections_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double normal[] = {0, 0, 1};
         static constexpr double offsets[] = {1.5};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_sections_with(in.surface, normal, 1, offsets, 0.0001, &call, &o.meet);
     }},
    {"surface_contours_with along a direction",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double d[] = {0.2, 0.1, 1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_contours_with(in.surface, 1, d, 0, nullptr, 0.01, &call, &o.meet);
     }},
    {"surface_contours_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double d[] = {0, 0, 2};
         static constexpr double cosines[] = {0.9};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_contours_with(in.surface, 3, d, 1, cosines, 0.01, &call, &o.meet);
     }},
    {"surface_reflections_with of normals",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double direction[] = {0, 0, 1};
         static constexpr double points[] = {0.5, 0.25, 0};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_reflections_with(in.surface, 1, nullptr, direction, 1, points, 0, 0, 0.01, &call,
             &o.meet);
     }},
    {"surface_reflections_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double eye[] = {0.1, 0, -1};
         static constexpr double direction[] = {1, 0, 0};
         static constexpr double points[] = {0, 0.5, 6, 0, 1, 6};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_reflections_with(in.surface, 2, eye, direction, 2, points, 0, 0, 0.01, &call,
             &o.meet);
     }},
    {"surface_level_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double coefficients[] = {0, 0, 1, -1.5};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_level_with(in.surface, 1, coefficients, 0.01, &call, &o.meet);
     }},
    {"surface_level_curves_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_heights(in, make_heights);
         if (made_heights.status() != NURBS_OK) {
             return made_heights.status();
         }
         static constexpr double values[] = {0.5};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_level_curves_with(in.surface, made_heights, 1, values, 0.01, &call, &o.meet);
     }},
    {"surface_intersections_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_wall(in, make_wall);
         if (made_wall.status() != NURBS_OK) {
             return made_wall.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_intersections_with(made_wall, in.surface, 0.1, &call, &o.meet);
     }},
    {"surface_self_intersections_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_self_intersections_with(in.surface, 0.1, &call, &o.meet);
     }},
    {"face_intersections_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_wall(in, make_wall);
         if (made_wall.status() != NURBS_OK) {
             return made_wall.status();
         }
         Made made_upright_outline(in, make_upright_outline);
         if (made_upright_outline.status() != NURBS_OK) {
             return made_upright_outline.status();
         }
         Made made_upright(in, make_upright);
         if (made_upright.status() != NURBS_OK) {
             return made_upright.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_intersections_with(in.face, made_upright, 0.1, &call, &o.meet);
     }},
    {"surface_project_curve_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_wall(in, make_wall);
         if (made_wall.status() != NURBS_OK) {
             return made_wall.status();
         }
         static constexpr double direction[] = {1, 0.2, 0.1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_surface_project_curve_with(made_wall, in.twist, direction, 0.01, &call, &o.meet);
     }, true},
    {"face_project_curve_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double direction[] = {0, 0, 1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_face_project_curve_with(in.face, in.twist, direction, 0.1, &call, &o.meet);
     }, true},
    {"model_sections_with",
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
         static constexpr double normals[] = {0, 0, 1};
         static constexpr double offsets[] = {0.1};
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_model_sections_with(made_ball, 1, normals, offsets, 0.1, &call, &o.meet);
     }},
    {"model_intersections_with",
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
         return nurbs_model_intersections_with(in.model, made_ball, 0.1, &call, &o.meet);
     }},
    {"meet_trim_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_meet_trim_with(in.meet, in.face, &call, &o.meet);
     }},
    {"meet_trim_second_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         Made made_wall(in, make_wall);
         if (made_wall.status() != NURBS_OK) {
             return made_wall.status();
         }
         Made made_crossing(in, make_crossing);
         if (made_crossing.status() != NURBS_OK) {
             return made_crossing.status();
         }
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_meet_trim_second_with(made_crossing, in.face, &call, &o.meet);
     }},
    {"mesh_surface_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.chord = 1;
         options.relative_chord = 0;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_surface_with(in.surface, &options, &call, &o.mesh);
     }},
    {"mesh_surface_with by length",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.chord = 10;
         options.relative_chord = 0;
         options.longest = 1.5;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_surface_with(in.surface, &options, &call, &o.mesh);
     }},
    {"mesh_surface_with by angle",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.chord = 10;
         options.relative_chord = 0;
         options.angle = 0.5;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_surface_with(in.surface, &options, &call, &o.mesh);
     }},
    {"mesh_face_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.chord = 1;
         options.relative_chord = 0;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_face_with(in.face, &options, &call, &o.mesh);
     }, true},
    {"mesh_model_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.chord = 1;
         options.relative_chord = 0;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_model_with(in.model, &options, &call, &o.mesh);
     }, true},
    {"mesh_surface_with without small angles",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.chord = 10;
         options.relative_chord = 0;
         options.minimum_angle = 0.4;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_surface_with(in.surface, &options, &call, &o.mesh);
     }},
    {"mesh_surface_levels_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double chords[] = {1};
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.longest = 10;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_surface_levels_with(in.surface, 1, chords, &options, &call, &o.mesh);
     }},
    {"mesh_face_levels_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double chords[] = {1};
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.longest = 10;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_face_levels_with(in.face, 1, chords, &options, &call, &o.mesh);
     }, true},
    {"mesh_model_levels_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         static constexpr double chords[] = {1};
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.longest = 10;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_model_levels_with(in.model, 1, chords, &options, &call, &o.mesh);
     }, true},
    {"mesh_volume_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_mesh_options options;
         (void)nurbs_mesh_options_init(&options, sizeof options);
         options.chord = 0.1;
         options.relative_chord = 0;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_volume_with(in.solid, &options, 100, &call, &o.mesh);
     }, true},
    {"mesh_write_with",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_write_with(in.mesh, 3, nullptr, 0, o.text, o.spans, &call);
     }},
    {"mesh_write_with as text",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_write_with(in.mesh, 4, &options, 0, o.text, o.spans, &call);
     }},
    {"mesh_write_with as OBJ",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_write_with(in.mesh, 5, &options, 0, o.text, o.spans, &call);
     }},
    {"mesh_write_with as PLY",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_write_with(in.mesh, 6, &options, 0, o.text, o.spans, &call);
     }},
    {"mesh_write_with as GLB",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_write_with(in.mesh, 7, &options, 0, o.text, o.spans, &call);
     }},
    {"mesh_write_with as VTU",
     [](const Inputs &in, Output &o) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_write_with(in.mesh, 8, &options, 0, o.text, o.spans, &call);
     }},
    {"mesh_write_file_with",
     [](const Inputs &in, Output &) -> nurbs_status {
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_write_file_with(in.mesh, replaced_path, 8, nullptr, &call);
     }},
    {"mesh_write_file_with in inches",
     [](const Inputs &in, Output &) -> nurbs_status {
         nurbs_write_options options;
         (void)nurbs_write_options_init(&options, sizeof options);
         options.unit = 0.0254;
         nurbs_call_options call;
         (void)nurbs_call_options_init(&call, sizeof call);
         return nurbs_mesh_write_file_with(in.mesh, replaced_path, 3, &options, &call);
     }},
};

} // namespace

std::span<const Call> data_calls() {
    return group;
}

} // namespace calls
