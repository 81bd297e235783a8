/* SPDX-License-Identifier: MIT */
// Every function with every one of its allocations failing: the memory status, no handle, no leak, nothing
// written, inputs intact, and the same call succeeds afterwards. Then: what evaluation allocates, and what a
// handle costs.
#include "check.h"

#include "allocations.h"
#include "iges_text.h"
#include "shapes.h"

#include <cstdio>
#include <vector>

namespace {

// Fresh inputs for each attempt, since tables are built at first use; the output array is long enough for
// all.
struct Inputs {
    nurbs *curve = nullptr, *loop = nullptr, *surface = nullptr, *volume = nullptr, *homogeneous = nullptr,
          *twist = nullptr, *segment = nullptr;
    nurbs_list *list = nullptr;
    double values[1024];
    float singles[64];
    int64_t spans[64];
    int32_t states[64];
};

const IgesText file = small_file();
constexpr const char *path = "allocation_failure_test.igs";
const double new_knots[] = {0.3, 0.6};
const double params[] = {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, four[] = {4};

nurbs *make_homogeneous() {
    static const int32_t degree = 2;
    static const int64_t count = 3;
    static const double knots[] = {0, 0, 0, 1, 1, 1}, records[] = {1, 0, 1, 0, 1, 0, -1, 0, 1};
    nurbs *g = nullptr;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 6, 2, records, 0, 0, 0, &g));
    return g;
}

// One conic piece over knots that are not clamped.
nurbs *make_segment() {
    static const int32_t degree = 2;
    static const int64_t count = 3;
    static const double knots[] = {0, 1, 2, 3, 4, 5}, points[] = {0, 0, 1, 1, 2, 0}, weights[] = {1, 3, 5};
    nurbs *g = nullptr;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 6, 2, points, 0, 0, weights, 0, 0, &g));
    return g;
}

void fill(Inputs &in) {
    in.curve = make(circle());
    in.loop = make(loop());
    in.surface = make(trough());
    in.volume = make(cube());
    in.twist = make(twist());
    in.homogeneous = make_homogeneous();
    in.segment = make_segment();
    CHECK_OK(nurbs_read(file.bytes, file.size, nullptr, &in.list));
    FILL(in.values);
    FILL(in.singles);
    FILL(in.spans);
    FILL(in.states);
}

void drop(Inputs &in) {
    nurbs_destroy(in.curve);
    nurbs_destroy(in.loop);
    nurbs_destroy(in.surface);
    nurbs_destroy(in.volume);
    nurbs_destroy(in.segment);
    nurbs_destroy(in.twist);
    nurbs_destroy(in.homogeneous);
    nurbs_list_destroy(in.list);
}

void check_intact(const Inputs &in) {
    CHECK_POINTS(in.curve, circle().points);
    CHECK_WEIGHTS(in.curve, circle().weights);
    CHECK_KNOTS(in.curve, 0, circle().knots);
    CHECK_POINTS(in.loop, loop().points);
    CHECK_POINTS(in.surface, trough().points);
    CHECK_POINTS(in.volume, cube().points);
}

// A call makes a handle, or a list, or neither; it takes what it makes into `out` or `list`.
struct Output {
    nurbs *out;
    nurbs_list *list;
};

struct Case {
    const char *name;
    nurbs_status (*call)(Inputs &in, Output &o);
    bool can_do_without = false; // buffers of the C library for files, tables of evaluation
};

// With the quadratic Bezier curve of these points, of dimension 1 or more.
nurbs_status compose_with(const nurbs *g, int32_t dim, std::initializer_list<double> points, Output &o) {
    static const int32_t degree = 2;
    nurbs *f = nullptr;
    nurbs_status status = nurbs_create_bezier(1, &degree, dim, std::data(points), 0, 0, nullptr, 0, &f);
    if (status == NURBS_OK) {
        status = nurbs_compose(g, f, &o.out);
    }
    nurbs_destroy(f);
    return status;
}

// The boundaries of a surface or volume, blended; 0: bilinearly, else bicubically.
nurbs_status blend_boundaries(const nurbs *g, int order, Output &o) {
    nurbs_list *list = nullptr;
    nurbs *parts[6] = {};
    int64_t count = 0;
    nurbs_status status = nurbs_boundaries(g, &list);
    if (status == NURBS_OK) {
        status = nurbs_list_count(list, &count);
    }
    for (int64_t i = 0; i < count && status == NURBS_OK; ++i) {
        status = nurbs_list_get(list, i, &parts[i]);
    }
    if (status == NURBS_OK) {
        status = count == 6   ? nurbs_volume_coons(parts, 0, &o.out)
                 : order == 0 ? nurbs_surface_coons(parts, 0, &o.out)
                              : nurbs_surface_coons_hermite(parts, nullptr, NURBS_TWIST_ADINI, nullptr, 0,
                                                            nullptr, &o.out);
    }
    for (nurbs *part : parts) {
        nurbs_destroy(part);
    }
    nurbs_list_destroy(list);
    return status;
}

nurbs_status coons_gaps(Inputs &in, Output &) {
    const nurbs *const curves[] = {in.curve, in.curve, in.loop, in.loop};
    return nurbs_coons_gaps(curves, curves, in.values, in.values + 4, in.values + 12);
}

nurbs_status short_knots(Inputs &, Output &o) {
    static const double knots[] = {0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1};
    const SplineArgs a = circle();
    return nurbs_create_short(1, a.degrees, a.counts, knots, 10, 2, a.points, 0, 0, a.weights, 0, 0, &o.out);
}

nurbs_status grouped_knots(Inputs &, Output &o) {
    static const int64_t count = 5;
    static const double knots[] = {0, 0.25, 0.5, 0.75, 1};
    static const int32_t times[] = {3, 2, 2, 2, 3};
    const SplineArgs a = circle();
    return nurbs_create_multiplicities(1, a.degrees, a.counts, &count, knots, times, 2, a.points, 0, 0,
                                       a.weights, 0, 0, &o.out);
}

nurbs_status homogeneous(Inputs &, Output &o) {
    static const double records[] = {1, 1, 1, 2, -1, 1, -1, -1, 1, -1, 1, 2};
    const SplineArgs a = loop();
    return nurbs_create_homogeneous(1, a.degrees, a.counts, a.knots, 9, 1, records, 0, 0, 0, &o.out);
}

nurbs_status averaged(Inputs &in, Output &) {
    static const double sites[] = {0, 1, 2, 3, 4};
    return nurbs_knots_averaged(2, 5, sites, 8, in.values);
}

nurbs_status periodic_knots(Inputs &in, Output &) {
    static const double breaks[] = {0, 1, 2, 3};
    return nurbs_knots_periodic(2, 4, breaks, nullptr, 8, in.values);
}

const double cotangents[64] = {1, 2, 3};
const int64_t grid_counts[] = {2, 2, 2};

const Case cases[] = {
    {"create curve",
     [](Inputs &, Output &o) {
         const SplineArgs a = circle();
         return create(&a, &o.out);
     }},
    {"create loop",
     [](Inputs &, Output &o) {
         const SplineArgs a = loop();
         return create(&a, &o.out);
     }},
    {"create volume",
     [](Inputs &, Output &o) {
         const SplineArgs a = cube();
         return create(&a, &o.out);
     }},
    {"create_homogeneous", homogeneous},
    {"create_short", short_knots},
    {"create_multiplicities", grouped_knots},
    {"create_bezier",
     [](Inputs &, Output &o) {
         return nurbs_create_bezier(1, arch().degrees, 2, arch().points, 0, 0, nullptr, 0, &o.out);
     }},
    {"with_points",
     [](Inputs &in, Output &o) {
         return nurbs_with_points(in.curve, circle().points, 0, 0, nullptr, 0, &o.out);
     }},
    {"clone", [](Inputs &in, Output &o) { return nurbs_clone(in.curve, &o.out); }},
    {"knots_uniform", [](Inputs &in, Output &) { return nurbs_knots_uniform(2, 5, 0, 1, 8, in.values); }},
    {"knots_open_uniform",
     [](Inputs &in, Output &) { return nurbs_knots_open_uniform(2, 5, 0, 1, 8, in.values); }},
    {"knots_bezier", [](Inputs &in, Output &) { return nurbs_knots_bezier(2, 2, nullptr, 8, in.values); }},
    {"knots_averaged", averaged},
    {"knots_periodic", periodic_knots},
    {"knots", [](Inputs &in, Output &) { return nurbs_knots(in.curve, 0, 12, in.values); }},
    {"distinct_knots",
     [](Inputs &in, Output &) { return nurbs_distinct_knots(in.curve, 0, 5, in.values, nullptr, in.spans); }},
    {"greville", [](Inputs &in, Output &) { return nurbs_greville(in.curve, 0, 9, in.values); }},
    {"points", [](Inputs &in, Output &) { return nurbs_points(in.homogeneous, 3, in.values, 0, 0); }},
    {"weights", [](Inputs &in, Output &) { return nurbs_weights(in.curve, 9, in.values, 0); }},
    {"homogeneous_points",
     [](Inputs &in, Output &) { return nurbs_homogeneous_points(in.curve, 9, in.values, 0, 0); }},
    {"hull_size",
     [](Inputs &in, Output &) { return nurbs_hull_size(in.curve, 6, params, 0, 0, in.values, 0, 0); }},
    {"hull_size signed",
     [](Inputs &in, Output &) { return nurbs_hull_size(in.homogeneous, 6, params, 0, 0, in.values, 0, 0); }},
    {"find_spans",
     [](Inputs &in, Output &) {
         return nurbs_find_spans(2, 9, circle().knots, 12, 6, params, 0, in.spans, 0);
     }},
    {"bernstein", [](Inputs &in, Output &) { return nurbs_bernstein(5, 3, 6, params, 0, in.values, 0, 0); }},
    {"basis",
     [](Inputs &in, Output &) {
         return nurbs_basis(2, 9, circle().knots, 12, 4, 6, params, 0, in.spans, in.values, 0, 0, 0);
     }},
    {"rational_basis",
     [](Inputs &in, Output &) {
         return nurbs_rational_basis(in.curve, 6, params, 0, 0, in.spans, in.values, 0, 0, 0);
     }},
    {"rational_basis surface",
     [](Inputs &in, Output &) {
         return nurbs_rational_basis(in.surface, 3, params, 0, 0, in.spans, in.values, 0, 0, 0);
     }},
    {"eval", [](Inputs &in, Output &) { return nurbs_eval(in.curve, 6, params, 0, 0, in.values, 0, 0, 0); }},
    {"eval surface",
     [](Inputs &in, Output &) { return nurbs_eval(in.surface, 3, params, 0, 0, in.values, 0, 0, 0); }},
    {"eval volume",
     [](Inputs &in, Output &) { return nurbs_eval(in.volume, 2, params, 0, 0, in.values, 0, 0, 0); }},
    {"eval_derivs",
     [](Inputs &in, Output &) {
         return nurbs_eval_derivs(in.curve, 5, 6, params, 0, 0, in.values, 0, 0, 0);
     }},
    {"eval_derivs volume",
     [](Inputs &in, Output &) {
         return nurbs_eval_derivs(in.volume, 4, 2, params, 0, 0, in.values, 0, 0, 0);
     }},
    {"eval_grid",
     [](Inputs &in, Output &) {
         return nurbs_eval_grid(in.surface, grid_counts, params, in.values, 0, 0, 0);
     }},
    {"eval_grid_derivs",
     [](Inputs &in, Output &) {
         return nurbs_eval_grid_derivs(in.volume, 2, grid_counts, params, in.values, 0, 0, 0);
     }},
    {"eval_f32",
     [](Inputs &in, Output &) { return nurbs_eval_f32(in.curve, 6, params, 0, 0, in.singles, 0, 0, 0); }},
    {"eval_grid_f32",
     [](Inputs &in, Output &) {
         return nurbs_eval_grid_f32(in.volume, grid_counts, params, in.singles, 0, 0, 0);
     }},
    {"collocation",
     [](Inputs &in, Output &) {
         const SplineArgs a = trough();
         const int32_t orders[] = {1, 0};
         return nurbs_collocation(2, a.degrees, a.counts, a.knots, 12, orders, 3, params, 0, 0, 64, in.values,
                                  in.spans, nullptr, nullptr, 0);
     }},
    {"rational_collocation",
     [](Inputs &in, Output &) {
         const int32_t order = 2;
         return nurbs_rational_collocation(in.curve, &order, 6, params, 0, 0, 64, in.values, in.spans,
                                           nullptr, nullptr, 0);
     }},
    {"bezier_extraction",
     [](Inputs &in, Output &) {
         return nurbs_bezier_extraction(in.curve, 0, 4, in.values, nullptr, nullptr, in.spans);
     }},
    {"eval_adjoint points",
     [](Inputs &in, Output &) {
         return nurbs_eval_adjoint(in.surface, 1, 3, params, 0, 0, cotangents, 0, 0, in.values, 0, 0, nullptr,
                                   0, nullptr, 0, 0, 0);
     }},
    {"eval_adjoint",
     [](Inputs &in, Output &) {
         return nurbs_eval_adjoint(in.curve, 0, 6, params, 0, 0, cotangents, 0, 0, in.values, 0, 0,
                                   in.values + 32, 0, in.values + 64, 0, 0, 0);
     }},
    {"surface_eval_frames",
     [](Inputs &in, Output &) {
         return nurbs_surface_eval_frames(in.surface, 3, params, 0, 0, in.values, 0, 0, in.values + 9, 0, 0,
                                          in.values + 18, 0, 0, in.values + 27, 0, 0, in.states, 0);
     }},
    {"surface_eval_grid_frames",
     [](Inputs &in, Output &) {
         return nurbs_surface_eval_grid_frames(in.surface, grid_counts, params, in.values, 0, 0, nullptr, 0,
                                               0, nullptr, 0, 0, in.values + 12, 0, 0, in.states, 0);
     }},
    {"surface_eval_curvatures",
     [](Inputs &in, Output &) {
         return nurbs_surface_eval_curvatures(in.surface, 3, params, 0, 0, in.values, 0, 0, in.values + 6, 0,
                                              0, in.values + 24, 0, in.values + 27, 0, in.states, 0);
     }},
    {"curve_eval_frames",
     [](Inputs &in, Output &) {
         return nurbs_curve_eval_frames(in.curve, 6, params, 0, in.values, 0, 0, in.values + 12, 0, 0,
                                        in.values + 24, 0, 0, nullptr, 0, 0, in.values + 36, 0, nullptr, 0,
                                        in.states, 0);
     }},
    {"rotation_minimizing_frames",
     [](Inputs &in, Output &) {
         static const double first[] = {0, 1, 2};
         return nurbs_curve_rotation_minimizing_frames(in.twist, 6, params, 0, first, in.values, 0, 0,
                                                       in.values + 18, 0, 0, in.values + 36, 0, 0,
                                                       in.values + 54, 0, 0, in.states, 0);
     }},
    {"iso curve", [](Inputs &in, Output &o) { return nurbs_iso(in.surface, 0, 0.3, 0, &o.out); }},
    {"iso surface", [](Inputs &in, Output &o) { return nurbs_iso(in.volume, 1, 0.3, 0, &o.out); }},
    {"insert_knot", [](Inputs &in, Output &o) { return nurbs_insert_knot(in.curve, 0, 0.3, 2, &o.out); }},
    {"insert_knot periodic",
     [](Inputs &in, Output &o) { return nurbs_insert_knot(in.loop, 0, 2.5, 2, &o.out); }},
    {"insert_knot surface",
     [](Inputs &in, Output &o) { return nurbs_insert_knot(in.surface, 1, 1.5, 1, &o.out); }},
    {"refine", [](Inputs &in, Output &o) { return nurbs_refine(in.curve, 0, 2, new_knots, &o.out); }},
    {"refine_uniform", [](Inputs &in, Output &o) { return nurbs_refine_uniform(in.loop, 0, 3, &o.out); }},
    {"refinement_matrix",
     [](Inputs &in, Output &) {
         return nurbs_refinement_matrix(in.curve, 0, 2, new_knots, 0, nullptr, nullptr, nullptr, in.spans);
     }},
    {"extract", [](Inputs &in, Output &o) { return nurbs_extract(in.curve, new_knots, new_knots + 1, &o.out); }},
    {"clamp", [](Inputs &in, Output &o) { return nurbs_clamp_ends(in.loop, 0, 3, &o.out); }},
    {"move_seam", [](Inputs &in, Output &o) { return nurbs_move_seam(in.loop, 0, 2.5, &o.out); }},
    {"join",
     [](Inputs &in, Output &o) {
         const nurbs *parts[] = {in.curve, in.curve};
         return nurbs_join(2, parts, 0, 9, NURBS_KEEP_GAPS, nullptr, &o.out);
     }},
    {"snap_knots",
     [](Inputs &in, Output &o) { return nurbs_snap_knots(in.loop, 0, 0.26, nullptr, &o.out); }},
    {"create_hermite",
     [](Inputs &, Output &o) {
         return nurbs_create_hermite(2, new_knots, 2, params, 0, 0, params, 0, 0, &o.out);
     }},
    {"to_hermite",
     [](Inputs &in, Output &) {
         return nurbs_to_hermite(in.twist, 2, in.values, in.values + 2, in.values + 8, nullptr);
     }},
    {"to_power",
     [](Inputs &in, Output &) { return nurbs_to_power(in.curve, 64, in.values, nullptr, in.spans, nullptr); }},
    {"create_power",
     [](Inputs &, Output &o) {
         static const int32_t degrees[] = {1, 0};
         static const int64_t pieces[] = {1, 1};
         static const double breaks[] = {0, 1, 0, 1};
         return nurbs_create_power(2, degrees, pieces, breaks, 4, 2, params, 0, 0, 0, &o.out);
     }},
    {"basis_matrix", [](Inputs &in, Output &) { return nurbs_basis_matrix(0, 3, 3, 16, in.values); }},
    {"mirror", [](Inputs &in, Output &o) { return nurbs_mirror(in.curve, params, params, &o.out); }},
    {"project_to_plane",
     [](Inputs &in, Output &o) { return nurbs_project_to_plane(in.curve, params, params, nullptr, &o.out); }},
    {"project_from",
     [](Inputs &in, Output &o) { return nurbs_project_from(in.curve, params + 2, params, params, &o.out); }},
    {"extend", [](Inputs &in, Output &o) { return nurbs_extend(in.surface, 0, NURBS_START, 1, 1, &o.out); }},
    {"unclamp", [](Inputs &in, Output &o) { return nurbs_unclamp(in.volume, 2, 3, &o.out); }},
    {"make_periodic",
     [](Inputs &in, Output &o) { return nurbs_make_periodic(in.curve, 0, 1, nullptr, nullptr, &o.out); }},
    {"detect_periodic",
     [](Inputs &in, Output &) { return nurbs_detect_periodic(in.curve, 0, in.states); }},
    {"continuity",
     [](Inputs &in, Output &) {
         return nurbs_continuity(in.surface, 1, 0, 0, 0, 0, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,
                                 nullptr, in.spans);
     }},
    {"continuity_between",
     [](Inputs &in, Output &) {
         return nurbs_continuity_between(in.curve, NURBS_END, in.curve, NURBS_START, 0, 0, 0, in.states, nullptr,
                                         nullptr, nullptr, nullptr);
     }},
    {"make_compatible",
     [](Inputs &in, Output &o) {
         const nurbs *splines[] = {in.curve, in.loop};
         return nurbs_make_compatible(2, splines, 0.01, NURBS_MAP_DOMAINS, nullptr, &o.list);
     }},
    {"deviation",
     [](Inputs &in, Output &) { return nurbs_deviation(in.surface, in.surface, in.values, in.values + 1); }},
    {"curve_shape_factor",
     [](Inputs &in, Output &) { return nurbs_curve_shape_factor(in.segment, in.values, in.states); }},
    {"box", [](Inputs &in, Output &) { return nurbs_box(in.volume, nullptr, 1e-3, in.values, in.values + 4, nullptr); }},
    {"oriented_box",
     [](Inputs &in, Output &) {
         return nurbs_oriented_box(in.surface, 1e-3, in.values, in.values + 3, in.values + 12);
     }},
    {"tangent_cone",
     [](Inputs &in, Output &) {
         return nurbs_tangent_cone(in.segment, 0, nullptr, 0.1, in.values, in.values + 2);
     }},
    {"normal_cone",
     [](Inputs &in, Output &) {
         return nurbs_normal_cone(in.surface, nullptr, 0.1, in.values, in.values + 3);
     }},
    {"extreme_point",
     [](Inputs &in, Output &) {
         return nurbs_extreme_point(in.curve, params, nullptr, 1e-6, in.values, in.values + 1, in.values + 2);
     }},
    {"closest_points",
     [](Inputs &in, Output &) {
         return nurbs_closest_points(in.curve, 1, params, 0, 0, nullptr, 0, 0, in.values, 0, 0, in.values + 1, 0, 0,
                                     nullptr, 0, in.states, 0);
     }},
    {"closest_local",
     [](Inputs &in, Output &) {
         return nurbs_closest_local(in.curve, 1, params, 0, 0, params, 0, 0, in.values, 0, 0, nullptr, 0, 0,
                                    nullptr, 0, nullptr, 0);
     }},
    {"curve_signed_distances",
     [](Inputs &in, Output &) {
         return nurbs_curve_signed_distances(in.curve, 1, params, 0, 0, 0, 0, in.values, 0, nullptr, 0, nullptr, 0);
     }},
    {"closest_all",
     [](Inputs &in, Output &) {
         return nurbs_closest_all(in.curve, params, nullptr, 0, 0, 8, in.values, nullptr, nullptr, nullptr);
     },
     true},
    {"critical_points",
     [](Inputs &in, Output &) {
         return nurbs_critical_points(in.curve, params, nullptr, 0, 0, 8, in.values, nullptr, nullptr, nullptr,
                                      nullptr);
     },
     true},
    {"curve_features",
     [](Inputs &in, Output &) {
         return nurbs_curve_features(in.twist, 0x7f, 0, nullptr, nullptr, nullptr, in.spans, in.states);
     }},
    {"curve_features periodic",
     [](Inputs &in, Output &) {
         return nurbs_curve_features(in.loop, 0x3f, 16, in.values, in.states, in.values + 16, in.spans, nullptr);
     },
     true},
    {"curve_monotone_pieces",
     [](Inputs &in, Output &) {
         return nurbs_curve_monotone_pieces(in.curve, params, 16, in.values, in.states, in.spans, nullptr);
     }},
    {"curve_convexity", [](Inputs &in, Output &) { return nurbs_curve_convexity(in.curve, in.states); }},
    {"straightness",
     [](Inputs &in, Output &) {
         return nurbs_straightness(in.segment, in.values, in.values + 2, in.values + 4);
     },
     true},
    {"planarity",
     [](Inputs &in, Output &) { return nurbs_planarity(in.surface, in.values, in.values + 3, in.values + 6); }},
    {"boundary_contacts",
     [](Inputs &in, Output &) {
         return nurbs_boundary_contacts(in.surface, 0.1, in.states, in.values, in.states + 2, in.values + 2);
     },
     true},
    {"singular_points",
     [](Inputs &in, Output &) {
         return nurbs_singular_points(in.surface, 0.1, 0, nullptr, nullptr, in.spans, in.states);
     }},
    {"fold_test",
     [](Inputs &in, Output &) {
         return nurbs_fold_test(in.surface, nullptr, in.states, in.values, in.values + 2);
     }},
    {"recognize curve",
     [](Inputs &in, Output &) {
         return nurbs_recognize(in.curve, 1e-9, in.states, in.values, in.values + 9, in.values + 11);
     },
     true},
    {"recognize surface",
     [](Inputs &in, Output &) {
         return nurbs_recognize(in.surface, 0.2, in.states, in.values, in.values + 9, in.values + 11);
     },
     true},
    {"distance",
     [](Inputs &in, Output &) {
         return nurbs_distance(in.curve, in.loop, 1e-6, 0, in.values, in.values + 1, in.values + 2, in.values + 3,
                               in.states);
     }},
    {"hausdorff_distance",
     [](Inputs &in, Output &) {
         return nurbs_hausdorff_distance(in.curve, in.loop, 1e-1, 0, in.values, in.values + 2, in.values + 4,
                                         in.values + 5, in.states);
     }},
    {"curve_length",
     [](Inputs &in, Output &) { return nurbs_curve_length(in.curve, nullptr, 1e-9, in.values, nullptr); }},
    {"curve_lengths",
     [](Inputs &in, Output &) { return nurbs_curve_lengths(in.loop, 1, four, 0, 1e-9, in.values, 0); }},
    {"curve_params_at_lengths",
     [](Inputs &in, Output &) {
         return nurbs_curve_params_at_lengths(in.curve, 1, four, 0, 1e-9, in.values, 0, 0);
     }},
    {"curve_divide",
     [](Inputs &in, Output &) {
         return nurbs_curve_divide(in.curve, nullptr, 5, 1e-9, 0, in.values, in.values + 6);
     }},
    {"curve_divide chords",
     [](Inputs &in, Output &) {
         return nurbs_curve_divide(in.curve, nullptr, 5, 1e-9, NURBS_EQUAL_CHORDS, in.values, nullptr);
     }},
    {"surface_area",
     [](Inputs &in, Output &) { return nurbs_surface_area(in.surface, nullptr, 1e-9, in.values, nullptr); }},
    {"moments",
     [](Inputs &in, Output &) {
         return nurbs_moments(in.surface, 1e-9, in.values, in.values + 1, in.values + 4, in.values + 13);
     }},
    {"enclosed_area",
     [](Inputs &in, Output &) {
         const nurbs *curves[] = {in.loop};
         return nurbs_enclosed_area(1, curves, 1e-9, 1e-9, in.values, in.values + 1, in.values + 3, nullptr);
     }},
    {"enclosed_volume",
     [](Inputs &in, Output &) {
         const nurbs *surfaces[] = {in.surface};
         return nurbs_enclosed_volume(1, surfaces, 1e-9, in.values, nullptr, nullptr, in.values + 1, nullptr);
     }},
    {"remove_knot",
     [](Inputs &in, Output &o) {
         return nurbs_remove_knot(in.curve, 0, 0.5, 1, 9, nullptr, nullptr, &o.out);
     }},
    {"remove_knot periodic",
     [](Inputs &in, Output &o) { return nurbs_remove_knot(in.loop, 0, 3, 1, 9, nullptr, nullptr, &o.out); }},
    {"reduce_knots", [](Inputs &in, Output &o) { return nurbs_reduce_knots(in.curve, -1, 9, nullptr, &o.out); }},
    {"reduce_degree", [](Inputs &in, Output &o) { return nurbs_reduce_degree(in.loop, 0, 1, nullptr, &o.out); }},
    {"simplify", [](Inputs &in, Output &o) { return nurbs_simplify(in.curve, 9, nullptr, &o.out); }},
    {"decompose", [](Inputs &in, Output &o) { return nurbs_decompose(in.surface, &o.list); }},
    {"split_at_knots", [](Inputs &in, Output &o) { return nurbs_split_at_knots(in.curve, 0, 1, &o.list); }},
    {"split",
     [](Inputs &in, Output &o) {
         nurbs *other = nullptr;
         const nurbs_status status = nurbs_split(in.curve, 0, 0.3, &other, &o.out);
         nurbs_destroy(other);
         return status;
     }},
    {"insert_knot 0 times",
     [](Inputs &in, Output &o) { return nurbs_insert_knot(in.surface, 1, 1.5, 0, &o.out); }},
    {"elevate", [](Inputs &in, Output &o) { return nurbs_elevate(in.curve, 0, 2, &o.out); }},
    {"elevate periodic", [](Inputs &in, Output &o) { return nurbs_elevate(in.loop, 0, 2, &o.out); }},
    {"elevate homogeneous", [](Inputs &in, Output &o) { return nurbs_elevate(in.homogeneous, 0, 1, &o.out); }},
    {"reverse", [](Inputs &in, Output &o) { return nurbs_reverse(in.curve, 0, NURBS_KEEP_DOMAIN, &o.out); }},
    {"transpose",
     [](Inputs &in, Output &o) {
         static const int32_t turn[] = {2, 0, 1};
         return nurbs_transpose(in.volume, turn, &o.out);
     }},
    {"derivative", [](Inputs &in, Output &o) { return nurbs_derivative(in.loop, 0, 1, &o.out); }},
    {"derivative rational", [](Inputs &in, Output &o) { return nurbs_derivative(in.curve, 0, 2, &o.out); }},
    {"derivative beyond the degree",
     [](Inputs &in, Output &o) { return nurbs_derivative(in.loop, 0, 9, &o.out); }},
    {"antiderivative", [](Inputs &in, Output &o) { return nurbs_antiderivative(in.volume, 1, &o.out); }},
    {"product", [](Inputs &in, Output &o) { return nurbs_product(in.curve, in.curve, 0, &o.out); }},
    {"product periodic", [](Inputs &in, Output &o) { return nurbs_product(in.loop, in.loop, 0, &o.out); }},
    {"product volume",
     [](Inputs &in, Output &o) { return nurbs_product(in.volume, in.volume, NURBS_PRODUCT_DOT, &o.out); }},
    {"polyline",
     [](Inputs &, Output &o) { return nurbs_curve_polyline(3, 2, params, 0, 0, nullptr, 0, &o.out); }},
    {"polygon",
     [](Inputs &, Output &o) { return nurbs_curve_polygon(2, nullptr, nullptr, nullptr, 1, 5, &o.out); }},
    {"rounded_rectangle",
     [](Inputs &, Output &o) {
         return nurbs_curve_rounded_rectangle(2, nullptr, nullptr, nullptr, 3, 2, 0.5, &o.out);
     }},
    {"circle",
     [](Inputs &, Output &o) {
         return nurbs_curve_circle(3, nullptr, nullptr, nullptr, 1, NURBS_ARC_SMOOTH, &o.out);
     }},
    {"hyperbola",
     [](Inputs &, Output &o) { return nurbs_curve_hyperbola(2, nullptr, nullptr, nullptr, 1, 1, 0, 9, &o.out); }},
    {"arc_through",
     [](Inputs &, Output &o) { return nurbs_curve_arc_through(2, params, params + 2, params + 4, 0, &o.out); }},
    {"conic_shoulder",
     [](Inputs &, Output &o) {
         static const double ends[] = {0, 0, 1, 0}, tangents[] = {1, 1, 1, -1};
         return nurbs_curve_conic_shoulder(2, ends, tangents, ends + 2, tangents + 2, 0.4, &o.out);
     }},
    {"conic_through",
     [](Inputs &, Output &o) {
         static const double five[] = {-2, 4, -1, 1, 0, 0, 1, 1, 2, 4};
         return nurbs_curve_conic_through(2, five, 0, 0, 0, &o.out);
     }},
    {"conic_implicit",
     [](Inputs &, Output &o) {
         static const double ellipse[] = {1, 0, 4, 0, 0, -4};
         return nurbs_curve_conic_implicit(ellipse, 0, 3, 0, &o.out);
     }},
    {"conic_focus",
     [](Inputs &, Output &o) {
         static const double foot[] = {1, 0}, focus[] = {0, 0};
         return nurbs_curve_conic_focus(2, focus, nullptr, foot, 0.5, 0, 6, 0, &o.out);
     }},
    {"helix",
     [](Inputs &, Output &o) {
         return nurbs_curve_helix(3, nullptr, nullptr, nullptr, 1, 1, 1, 0, 1, 0.1, nullptr, &o.out);
     }},
    {"compose",
     [](Inputs &in, Output &o) {
         return compose_with(in.curve, 1, {0.0, 0.25, 1.0}, o);
     }},
    {"compose around a loop",
     [](Inputs &in, Output &o) {
         return compose_with(in.loop, 1, {0.0, 2.0, 9.0}, o);
     }},
    {"compose on a surface",
     [](Inputs &in, Output &o) {
         return compose_with(in.surface, 2, {0, 0, 1, 0, 1, 1}, o);
     }},
    {"sum", [](Inputs &in, Output &o) { return nurbs_sum(in.loop, 1, in.loop, 2, &o.out); }},
    {"sum rational",
     [](Inputs &in, Output &o) {
         nurbs *half = nullptr;
         nurbs_status status = nurbs_reparametrize_moebius(in.curve, 0, 2, &half);
         if (status == NURBS_OK) {
             status = nurbs_sum(in.curve, 1, half, 1, &o.out);
         }
         nurbs_destroy(half);
         return status;
     }},
    {"boundaries", [](Inputs &in, Output &o) { return nurbs_boundaries(in.volume, &o.list); }},
    {"surface_coons", [](Inputs &in, Output &o) { return blend_boundaries(in.surface, 0, o); }},
    {"surface_coons_hermite", [](Inputs &in, Output &o) { return blend_boundaries(in.surface, 3, o); }},
    {"coons_gaps", coons_gaps},
    {"volume_coons", [](Inputs &in, Output &o) { return blend_boundaries(in.volume, 0, o); }},
    {"normalize_weights", [](Inputs &in, Output &o) { return nurbs_normalize_weights(in.homogeneous, &o.out); }},
    {"equalize_end_weights",
     [](Inputs &in, Output &o) { return nurbs_equalize_end_weights(in.curve, 0, &o.out); }},
    {"reparametrize", [](Inputs &in, Output &o) { return nurbs_reparametrize(in.loop, 0, 0, 1, &o.out); }},
    {"make_rational", [](Inputs &in, Output &o) { return nurbs_make_rational(in.loop, &o.out); }},
    {"to_homogeneous", [](Inputs &in, Output &o) { return nurbs_to_homogeneous(in.curve, &o.out); }},
    {"from_homogeneous", [](Inputs &in, Output &o) { return nurbs_from_homogeneous(in.volume, &o.out); }},
    {"transform",
     [](Inputs &in, Output &o) {
         static const double turn[] = {0, 1, -1, 0};
         return nurbs_transform(in.curve, 2, turn, turn, &o.out);
     }},
{"extrude",
     [](Inputs &in, Output &o) {
         static const double up[] = {0, 0, 1};
         return nurbs_extrude(in.twist, up, &o.out);
     }},
    {"revolve", [](Inputs &in, Output &o) { return nurbs_revolve(in.twist, nullptr, nullptr, 6, 0, &o.out); }},
    {"ruled", [](Inputs &in, Output &o) { return nurbs_ruled(in.curve, in.loop, 0, &o.out); }},
    {"ruled Cartesian",
     [](Inputs &in, Output &o) { return nurbs_ruled(in.curve, in.loop, NURBS_RULED_CARTESIAN, &o.out); }},
    {"tensor_sum", [](Inputs &in, Output &o) { return nurbs_tensor_sum(in.curve, 1, in.loop, 2, &o.out); }},
    {"tensor_sum homogeneous",
     [](Inputs &in, Output &o) { return nurbs_tensor_sum(in.homogeneous, 1, in.loop, 2, &o.out); }},
    {"tensor_product", [](Inputs &in, Output &o) { return nurbs_tensor_product(in.twist, in.surface, &o.out); }},
    {"surface_swung", [](Inputs &in, Output &o) { return nurbs_surface_swung(in.curve, in.loop, 1, &o.out); }},
    {"surface_plane",
     [](Inputs &, Output &o) { return nurbs_surface_plane(2, nullptr, new_knots, params, &o.out); }},
    {"surface_bilinear",
     [](Inputs &, Output &o) { return nurbs_surface_bilinear(1, params, 0, 0, &o.out); }},
    {"volume_trilinear",
     [](Inputs &, Output &o) { return nurbs_volume_trilinear(1, cube().points, 0, 0, &o.out); }},
    {"surface_sphere",
     [](Inputs &, Output &o) { return nurbs_surface_sphere(nullptr, params, nullptr, 1, 2, &o.out); }},
    {"surface_spherical_patch",
     [](Inputs &, Output &o) {
         return nurbs_surface_spherical_patch(nullptr, nullptr, nullptr, 1, 0, 4, 0, 1, 0, &o.out);
     }},
    {"surface_sphere_patches",
     [](Inputs &, Output &o) {
         return nurbs_surface_sphere_patches(nullptr, nullptr, nullptr, 1, NURBS_HEMISPHERE, &o.list);
     }},
    {"surface_ellipsoid",
     [](Inputs &, Output &o) {
         return nurbs_surface_ellipsoid(nullptr, nullptr, nullptr, 1, 2, 3, 1, &o.out);
     }},
    {"surface_cylinder",
     [](Inputs &, Output &o) {
         return nurbs_surface_cylinder(nullptr, nullptr, nullptr, 1, 2, 0, 3, 0, &o.out);
     }},
    {"surface_cone",
     [](Inputs &, Output &o) {
         return nurbs_surface_cone(nullptr, nullptr, nullptr, 1, 0, 2, 0, 3, 0, &o.out);
     }},
    {"surface_torus",
     [](Inputs &, Output &o) {
         return nurbs_surface_torus(nullptr, nullptr, nullptr, 3, 1, 0, 3, 0, 6, 2, &o.out);
     }},
    {"surface_paraboloid",
     [](Inputs &, Output &o) {
         return nurbs_surface_paraboloid(nullptr, nullptr, nullptr, 3, 1, 1, 0, 3, 0, &o.out);
     }},
    {"surface_saddle",
     [](Inputs &, Output &o) { return nurbs_surface_saddle(nullptr, nullptr, nullptr, 3, 1, 1, &o.out); }},
    {"surface_hyperboloid",
     [](Inputs &, Output &o) {
         return nurbs_surface_hyperboloid(nullptr, nullptr, nullptr, 3, 1, 1, -9, 9, 0, 3, 0, 0, &o.out);
     }},
        {"transform_projective",
     [](Inputs &in, Output &o) {
         static const double map[] = {1, 0, 0, 0, 1, 0, 0, 0, 2};
         return nurbs_transform_projective(in.curve, 2, map, &o.out);
     }},
    {"pull_weight",
     [](Inputs &in, Output &o) { return nurbs_pull_weight(in.curve, 3, new_knots, 0.01, in.values, &o.out); }},
    {"pull_weights",
     [](Inputs &in, Output &o) {
         static const int64_t both[] = {2, 3};
         return nurbs_pull_weights(in.curve, 2, both, new_knots, 0.01, in.values, &o.out);
     }},
    {"set_weights",
     [](Inputs &in, Output &o) {
         static const int64_t both[] = {2, 3};
         return nurbs_set_weights(in.loop, 2, both, new_knots, &o.out);
     }},
    {"weight_points",
     [](Inputs &in, Output &) {
         return nurbs_weight_points(in.surface, 1, params, in.values, in.values + 3, in.values + 6);
     }},
    {"weight_cross_ratio",
     [](Inputs &in, Output &) {
         return nurbs_weight_cross_ratio(1, params, params + 1, params + 2, params + 3, in.values);
     }},
    {"weight_through",
     [](Inputs &in, Output &o) {
         static const double target[] = {0.75, 0.75}, at = 0.125;
         return nurbs_weight_through(in.curve, 1, &at, target, 1, in.values, &o.out);
     }},
    {"pull_point",
     [](Inputs &in, Output &o) {
         return nurbs_pull_point(in.volume, 0, params, params, 1, in.values, &o.out);
     }},
    {"most_influential",
     [](Inputs &in, Output &) {
         return nurbs_most_influential(in.surface, 3, params, 0, 0, in.spans, in.values);
     }},
    {"insert_on_leg",
     [](Inputs &in, Output &o) { return nurbs_insert_on_leg(in.segment, 0, 0, 0.5, in.values, &o.out); }},
    {"insert_at_point",
     [](Inputs &in, Output &o) {
         static const double corner[] = {0, 1};
         return nurbs_insert_at_point(in.loop, 0, corner, 1, in.spans, in.values, in.values + 1, &o.out);
     }},
    {"constrain",
     [](Inputs &in, Output &o) {
         static const int32_t keep[] = {0, 0};
         return nurbs_constrain(in.curve, 2, nullptr, nullptr, new_knots, params, keep, nullptr, nullptr, 0, in.values,
                                in.spans, in.values + 2, in.values + 3, &o.out);
     }},
    {"constrain directions",
     [](Inputs &in, Output &o) {
         static const int32_t kinds[] = {NURBS_CONSTRAIN_NORMAL, NURBS_CONSTRAIN_VALUE};
         return nurbs_constrain(in.surface, 2, kinds, nullptr, params, params, nullptr, nullptr, nullptr, 0, in.values,
                                in.spans, in.values + 2, in.values + 3, &o.out);
     }},
    {"constrain curvature",
     [](Inputs &in, Output &o) {
         static const int32_t kinds[] = {NURBS_CONSTRAIN_CURVATURE};
         static const double costs[] = {1, 1, 1, 1, 1, 1, 1, 1, 1}, target[] = {-1, 0.1};
         return nurbs_constrain(in.curve, 1, kinds, nullptr, params, target, nullptr, nullptr, costs, 1e-9, in.values,
                                in.spans, in.values + 2, in.values + 3, &o.out);
     }},
    {"warp", [](Inputs &in, Output &o) { return nurbs_warp(in.curve, new_knots, params, 1, 1, &o.out); }},
    {"warp periodic", [](Inputs &in, Output &o) { return nurbs_warp(in.loop, nullptr, params, 1, 1, &o.out); }},
    {"flatten",
     [](Inputs &in, Output &o) {
         return nurbs_flatten(in.curve, new_knots, params, params, nullptr, in.values, &o.out);
     }},
    {"bend",
     [](Inputs &in, Output &o) {
         static const double along[] = {1, 0, 0}, across[] = {0, 1, 0};
         return nurbs_bend(in.curve, params, along, across, 1, -9, 9, 0.1, in.values, in.states, &o.out);
     }},
    {"free_form_deform",
     [](Inputs &in, Output &o) {
         static const double lower[] = {-1, -1}, upper[] = {1, 1};
         nurbs *square = nullptr;
         static const int32_t degrees[] = {1, 1};
         static const double points[] = {0, 0, 0, 1, 1, 0, 1, 2};
         nurbs_status status = nurbs_create_bezier(2, degrees, 2, points, 0, 0, nullptr, 0, &square);
         if (status == NURBS_OK) {
             status = nurbs_free_form_deform(in.curve, square, lower, upper, 0.1, in.values, in.states, &o.out);
         } else {
             o.out = nullptr;
         }
         nurbs_destroy(square);
         return status;
     }},
    {"fair",
     [](Inputs &in, Output &o) {
         return nurbs_fair(in.curve, 2, nullptr, 1e3, in.values, in.values + 2, &o.out);
     }},
    {"fair surface",
     [](Inputs &in, Output &o) {
         static const int32_t none[] = {-1, -1, -1, -1};
         return nurbs_fair(in.surface, 1, none, 1e3, in.values, in.values + 2, &o.out);
     }},
    {"snap_boundary",
     [](Inputs &in, Output &o) {
         return nurbs_snap_boundary(in.curve, 0, NURBS_END, in.segment, 0, NURBS_START, 1, 0, in.values, &o.out);
     }},
    {"snap_boundary surface",
     [](Inputs &in, Output &o) {
         return nurbs_snap_boundary(in.surface, 0, NURBS_END, in.surface, 1, NURBS_START, 1, NURBS_REVERSED,
                                    in.values, &o.out);
     }},
    {"read", [](Inputs &, Output &o) { return nurbs_read(file.bytes, file.size, nullptr, &o.list); }},
    {"read_file", [](Inputs &, Output &o) { return nurbs_read_file(path, nullptr, &o.list); }, true},
    {"list_get", [](Inputs &in, Output &o) { return nurbs_list_get(in.list, 0, &o.out); }},
};

// Functions that return fixed-size answers never allocate.
void scalars_allocate_nothing() {
    Inputs in;
    fill(in);
    allocations::begin();
    allocations::fail(1, true);
    int32_t small = 0;
    int64_t large = 0;
    double domain[2];
    char text[64];
    CHECK(nurbs_axes(in.curve, &small) == NURBS_OK && nurbs_dimension(in.curve, &small) == NURBS_OK);
    CHECK(nurbs_degree(in.curve, 0, &small) == NURBS_OK && nurbs_count(in.curve, 0, &large) == NURBS_OK);
    CHECK(nurbs_point_count(in.curve, &large) == NURBS_OK && nurbs_is_rational(in.curve, &small) == NURBS_OK);
    CHECK(nurbs_is_homogeneous(in.curve, &small) == NURBS_OK);
    CHECK(nurbs_knot_form(in.curve, 0, &small) == NURBS_OK && nurbs_domain(in.curve, 0, domain) == NURBS_OK);
    CHECK(nurbs_derivative_slots(3, 9, &large) == NURBS_OK && nurbs_version() == NURBS_VERSION);
    CHECK(nurbs_list_count(in.list, &large) == NURBS_OK &&
          nurbs_list_note_count(in.list, &large) == NURBS_OK);
    CHECK(nurbs_list_unit(in.list, domain) == NURBS_OK);
    CHECK(nurbs_list_name(in.list, 0, text, 64, &large) == NURBS_OK);
    CHECK(nurbs_list_note(in.list, 0, &small, nullptr, nullptr, text, 64, &large) == NURBS_OK);
    CHECK(nurbs_status_name(NURBS_OK) != nullptr && nurbs_last_error(text, 64) >= 0);
    nurbs_read_options options;
    CHECK(nurbs_read_options_init(&options, sizeof options) == NURBS_OK);
    allocations::fail(0, false);
    allocations::end();
    drop(in);
}

// One attempt with allocation k failing; returns whether there was one.
bool attempt(const Case &c, int64_t k, bool on) {
    Inputs in;
    Output o = {check_poison(), nullptr};
    const int before = check_failures;
    allocations::begin();
    fill(in);
    check_forget();
    allocations::fail(k, on);
    const nurbs_status status = c.call(in, o);
    const bool failed = allocations::log.failed;
    allocations::fail(0, false);
    const bool refused = failed && !(c.can_do_without && status == NURBS_OK);
    if (refused) {
        CHECK_INT(status, NURBS_ERROR_MEMORY);
        CHECK(o.out == nullptr || o.out == check_poison());
        CHECK(o.list == nullptr);
        CHECK_UNTOUCHED(in.values);
        CHECK_UNTOUCHED(in.singles);
        CHECK_UNTOUCHED(in.spans);
        CHECK_UNTOUCHED(in.states);
        check_intact(in);
        o = {check_poison(), nullptr};
    } else {
        CHECK_INT(status, NURBS_OK);
    }
    if (refused) {
        CHECK_INT(c.call(in, o), NURBS_OK);
    }
    nurbs_destroy(o.out == check_poison() ? nullptr : o.out);
    nurbs_list_destroy(o.list);
    drop(in);
    CHECK_INT(allocations::log.live, 0);
    allocations::end();
    if (check_failures != before) {
        std::fprintf(stderr, "    ... in %s, allocation %lld%s\n", c.name, static_cast<long long>(k),
                     on ? " and all that follow" : "");
    }
    return failed;
}

void every_allocation_fails() {
    for (const Case &c : cases) {
        int64_t k = 1;
        while (attempt(c, k, false) && attempt(c, k, true)) {
            ++k;
        }
        std::printf("%-24s %lld allocations\n", c.name, static_cast<long long>(k - 1));
    }
}

// Allocations of the second call of `run`: the first one may build tables.
template <class Run>
int64_t repeated_cost(Run &&run) {
    run();
    allocations::begin();
    allocations::fail(0, false);
    run();
    const int64_t count = allocations::log.count;
    allocations::end();
    return count;
}

int64_t eval_cost(const nurbs *g, int axes, int64_t n, int32_t order) {
    std::vector<double> at(static_cast<size_t>(n * axes), 0.3), out(static_cast<size_t>(n * 40 * 4));
    return repeated_cost([&] {
        CHECK(order < 0 ? nurbs_eval(g, n, at.data(), 0, 0, out.data(), 0, 0, 0) == NURBS_OK
                        : nurbs_eval_derivs(g, order, n, at.data(), 0, 0, out.data(), 0, 0, 0) == NURBS_OK);
    });
}

int64_t grid_cost(const nurbs *g, int axes, int64_t side, int32_t order) {
    const int64_t counts[] = {side, side, side};
    std::vector<double> at(static_cast<size_t>(side * axes), 0.3),
        out(static_cast<size_t>(side * side * side * 40));
    return repeated_cost([&] {
        CHECK(order < 0
                  ? nurbs_eval_grid(g, counts, at.data(), out.data(), 0, 0, 0) == NURBS_OK
                  : nurbs_eval_grid_derivs(g, order, counts, at.data(), out.data(), 0, 0, 0) == NURBS_OK);
    });
}

int64_t linear_cost(const nurbs *g, int axes, int64_t n) {
    const auto size = static_cast<size_t>(n);
    std::vector<double> at(size * static_cast<size_t>(axes), 0.3), values(size * 8), to_params(at);
    std::vector<double> given(size * 40), net(1024), weights(256);
    std::vector<int64_t> columns(size * 8), rows(size + 1);
    return repeated_cost([&] {
        CHECK(nurbs_rational_collocation(g, nullptr, n, at.data(), 0, 0, 8 * n, values.data(), columns.data(),
                                         rows.data(), nullptr, 0) == NURBS_OK);
        CHECK(nurbs_eval_adjoint(g, 1, n, at.data(), 0, 0, given.data(), 0, 0, net.data(), 0, 0,
                                 weights.data(), 0, to_params.data(), 0, 0, 0) == NURBS_OK);
    });
}

int64_t frame_cost(const nurbs *g, int64_t n) {
    std::vector<double> at(static_cast<size_t>(2 * n), 0.3), out(static_cast<size_t>(n * 3));
    return repeated_cost([&] {
        CHECK(nurbs_surface_eval_frames(g, n, at.data(), 0, 0, nullptr, 0, 0, nullptr, 0, 0, nullptr, 0, 0,
                                        out.data(), 0, 0, nullptr, 0) == NURBS_OK);
    });
}

void frames_allocate_nothing_per_point() {
    nurbs *g = make(trough());
    CHECK_INT(frame_cost(g, 100), frame_cost(g, 1000));
    nurbs_destroy(g);
}

void evaluation_allocates_nothing_per_point() {
    const SplineArgs shapes[] = {circle(), arch(), loop(), trough(), cube()};
    for (const SplineArgs &a : shapes) {
        SplineArgs b = a;
        static const double shifted[] = {-2, -1, 0, 1, 2, 3, 4, 5, 6};
        b.knots = a.flags != 0 ? shifted : a.knots; /* so that 0.3 lies in every domain */
        nurbs *g = make(b);
        for (int32_t order = -1; order < 3; ++order) {
            CHECK_INT(eval_cost(g, a.axes, 100, order), eval_cost(g, a.axes, 1000, order));
            CHECK_INT(grid_cost(g, a.axes, 10, order), grid_cost(g, a.axes, 20, order));
        }
        CHECK_INT(linear_cost(g, a.axes, 100), linear_cost(g, a.axes, 1000));
        if (a.axes < 3) {
            CHECK_INT(eval_cost(g, a.axes, 1000, -1), 0);
        }
        nurbs_destroy(g);
    }
}

// A handle costs its data once and at most 1 KiB.
void handles_cost_their_data(int64_t count, bool rational) {
    const int32_t degree = 3, dim = 3;
    const int64_t knot_count = count + degree + 1;
    std::vector<double> knots(static_cast<size_t>(knot_count)), points(static_cast<size_t>(count * dim), 0.5);
    const std::vector<double> weights(static_cast<size_t>(count), 1.5);
    CHECK_OK(nurbs_knots_uniform(degree, count, 0, 1, knot_count, knots.data()));
    nurbs *g = nullptr;
    allocations::begin();
    CHECK_OK(nurbs_create(1, &degree, &count, knots.data(), knot_count, dim, points.data(), 0, 0,
                          rational ? weights.data() : nullptr, 0, 0, &g));
    const auto data = static_cast<size_t>(knot_count + count * dim + (rational ? count : 0)) * sizeof(double);
    const size_t bytes = allocations::log.held;
    std::printf("%7lld points, %s: %zu bytes beside %zu of data\n", static_cast<long long>(count),
                rational ? "rational" : "polynomial", bytes - data, data);
    CHECK(bytes >= data && bytes <= data + 1024);
    nurbs *clone = nullptr;
    CHECK_OK(nurbs_clone(g, &clone));
    CHECK(allocations::log.held <= bytes + 256);
    nurbs_destroy(clone);
    nurbs_destroy(g);
    CHECK_INT(allocations::log.live, 0);
    allocations::end();
}

bool write_file() {
    std::FILE *f = std::fopen(path, "wb");
    const auto size = static_cast<size_t>(file.size);
    return f != nullptr && std::fwrite(file.bytes, 1, size, f) == size && std::fclose(f) == 0;
}

} // namespace

int main() {
    if (allocations_belong_to_a_sanitizer) {
        std::puts("skipped: the sanitizer replaces malloc itself");
        return 77;
    }
    CHECK(write_file());
    scalars_allocate_nothing();
    every_allocation_fails();
    evaluation_allocates_nothing_per_point();
    frames_allocate_nothing_per_point();
    for (const int64_t count : {10, 100, 1000, 10000, 100000}) {
        handles_cost_their_data(count, false);
        handles_cost_their_data(count, true);
    }
    std::remove(path);
    return check_summary("allocation_failure");
}
