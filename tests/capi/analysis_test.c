/* SPDX-License-Identifier: MIT */
/* Features of shapes: known ones, the query of lengths, and what is refused. */
#include "shapes.h"

#include <float.h>

static void features(void) {
    nurbs *g = make(arch()); /* symmetric about t = 1/2: one maximum of curvature there */
    double params[4], values[4];
    int32_t found[4], complete = -1;
    int64_t count = -1;
    CHECK_OK(nurbs_curve_features(g, 0x3f, 0, NULL, NULL, NULL, &count, &complete));
    CHECK_INT(complete, 1);
    CHECK_INT(count, 1);
    CHECK_OK(nurbs_curve_features(g, 0x3f, 4, params, found, values, &count, NULL));
    CHECK_INT(found[0], NURBS_FEATURE_CURVATURE_MAXIMUM);
    CHECK(fabs(params[0] - 0.5) < 1e-14);
    CHECK(fabs(values[0] + 12 / (4.5 * 4.5)) < 1e-12); /* y'' / x'^2 */
    CHECK_OK(nurbs_curve_features(g, 0, 0, NULL, NULL, NULL, &count, &complete));
    CHECK_INT(count, 0);
    nurbs_destroy(g);
    g = make(twist());
    CHECK_OK(nurbs_curve_features(g, NURBS_FEATURE_TORSION | NURBS_FEATURE_CUSP | NURBS_FEATURE_INFLECTION, 0,
                                  NULL, NULL, NULL, &count, &complete));
    CHECK_INT(count, 0);
    CHECK_INT(complete, 1);
    nurbs_destroy(g);
    g = make(loop()); /* parabolas that meet smoothly: their curvature is largest in the middle of each */
    CHECK_OK(nurbs_curve_features(g, NURBS_FEATURE_CURVATURE_MAXIMUM | NURBS_FEATURE_CURVATURE_MINIMUM, 0,
                                  NULL, NULL, NULL, &count, &complete));
    CHECK_INT(count, 8);
    CHECK_INT(complete, 1);
    nurbs_destroy(g);
}

static nurbs *curve_over(int32_t degree, int64_t count, const double *knots, int32_t dim,
                         const double *points, uint32_t flags) {
    nurbs *g = NULL;
    CHECK_OK(
        nurbs_create(1, &degree, &count, knots, count + degree + 1, dim, points, 0, 0, NULL, 0, flags, &g));
    return g;
}

/* Straight to the origin and at a right angle on, standing still there: a cusp whose curvature is 0. */
static void cusp_of_lines(void) {
    const double knots[] = {0, 0, 0, 0.5, 0.5, 1, 1, 1}, points[] = {-1, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    nurbs *g = curve_over(2, 5, knots, 2, points, 0);
    double at = 0, value = -1;
    int32_t found = 0;
    int64_t count = 0;
    CHECK_OK(nurbs_curve_features(g, NURBS_FEATURE_CUSP, 1, &at, &found, &value, &count, NULL));
    CHECK(count == 1 && at == 0.5 && value == 0);
    nurbs_destroy(g);
}

/* y = t^2, from 1 on 2 t - 1 + 3 (t - 1)^2: the curvature falls, jumps up at 1, and falls. */
static void curvature_that_jumps(void) {
    const double knots[] = {0, 0, 0, 1, 2, 2, 2}, points[] = {0, 0, 0.5, 0, 1.5, 2, 2, 6};
    nurbs *g = curve_over(2, 4, knots, 2, points, 0);
    const uint32_t kinds = NURBS_FEATURE_CURVATURE_MAXIMUM | NURBS_FEATURE_CURVATURE_MINIMUM;
    double at[2] = {0};
    int32_t found[2] = {0};
    int64_t count = 0;
    CHECK_OK(nurbs_curve_features(g, kinds, 2, at, found, NULL, &count, NULL));
    CHECK_INT(count, 2);
    CHECK_DOUBLES(at, ((const double[]){1, 1}), 2);
    CHECK_INT(found[0] | found[1], kinds);
    nurbs_destroy(g);
}

/* A figure of eight that runs through its centre at t = 3, its seam, and at 6: C(3 + s) = -C(3 - s). */
static void inflection_at_a_seam(void) {
    const double knots[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    const double points[] = {-2, -1, 0, 0, 0,  0,  2, 1, 0, 2, -1, 0, 0, 0,
                             0,  -2, 1, 0, -2, -1, 0, 0, 0, 0, 2,  1, 0};
    nurbs *space = curve_over(3, 9, knots, 3, points, NURBS_PERIODIC), *moved = NULL;
    double at[4] = {0}, again[4] = {0};
    int64_t count = 0, other = 0;
    CHECK_OK(nurbs_curve_features(space, NURBS_FEATURE_INFLECTION, 4, at, NULL, NULL, &count, NULL));
    CHECK_OK(nurbs_move_seam(space, 0, 4.5, &moved));
    CHECK_OK(nurbs_curve_features(moved, NURBS_FEATURE_INFLECTION, 4, again, NULL, NULL, &other, NULL));
    CHECK_INT(count, 2);
    CHECK_INT(other, 2);
    CHECK_NEAR(at, ((const double[]){3, 6}), 2, 1e-14);
    CHECK_NEAR(again, ((const double[]){6, 9}), 2, 1e-14);
    nurbs_destroy(moved);
    nurbs_destroy(space);
}

/* Two arcs that turn to the left with one tangent where they jump. */
static void convex_but_for_a_jump(void) {
    const double knots[] = {0, 0, 0, 1, 1, 1, 2, 2, 2};
    const double points[] = {0, 0, 1, 0, 2, 1, 2.5, 1, 3.5, 2, 3.5, 3};
    nurbs *g = curve_over(2, 6, knots, 2, points, 0), *part = NULL, *rest = NULL;
    int32_t convexity = -1;
    CHECK_OK(nurbs_split(g, 0, 1, &part, &rest));
    for (int i = 0; i < 2; ++i) {
        CHECK_OK(nurbs_curve_convexity(i == 0 ? part : rest, &convexity));
        CHECK_INT(convexity, NURBS_CONVEXITY_LEFT);
    }
    CHECK_OK(nurbs_curve_convexity(g, &convexity));
    CHECK_INT(convexity, NURBS_CONVEXITY_NONE);
    nurbs_destroy(rest);
    nurbs_destroy(part);
    nurbs_destroy(g);
}

static void straight_from_start_to_end(void) {
    const double ends[][4] = {{0, 0, 2, 1}, {2, 1, 0, 0}, {-3, 5, 1, -1}, {1, -1, -3, 5}};
    const int32_t degree = 1;
    for (int i = 0; i < 4; ++i) {
        nurbs *g = NULL;
        double direction[2], bound;
        CHECK_OK(nurbs_create_bezier(1, &degree, 2, ends[i], 0, 0, NULL, 0, &g));
        CHECK_OK(nurbs_straightness(g, NULL, direction, &bound));
        CHECK(direction[0] * (ends[i][2] - ends[i][0]) > 0 && direction[1] * (ends[i][3] - ends[i][1]) > 0);
        nurbs_destroy(g);
    }
}

/* S = (v (1 - v) u (1 - u), v), a point at both ends of axis 1: J = v (1 - v) (1 - 2 u). */
static void fold_between_poles(void) {
    const double points[] = {0, 0, 0, 0.5, 0, 1, 0, 0, 0.25, 0.5, 0, 1, 0, 0, 0, 0.5, 0, 1};
    const int32_t degrees[] = {2, 2};
    nurbs *g = NULL;
    int32_t result = -1;
    double positive[2], negative[2];
    CHECK_OK(nurbs_create_bezier(2, degrees, 2, points, 0, 0, NULL, 0, &g));
    CHECK_OK(nurbs_fold_test(g, NULL, &result, positive, negative));
    CHECK_INT(result, NURBS_FOLD_FOUND);
    CHECK(positive[0] < 0.5 && positive[1] > 0 && positive[1] < 1);
    CHECK(negative[0] > 0.5 && negative[1] > 0 && negative[1] < 1);
    nurbs_destroy(g);
}

/* S_u = 0 along the line between two pieces: one place, not one of each. */
static void singular_between_pieces(void) {
    const double knots[] = {0, 0, 0, 0.5, 0.5, 1, 1, 1, 0, 0, 1, 1};
    const double points[] = {0, 0, 0, 1, 0.5, 0, 0.5, 1, 0.5, 0, 0.5, 1, 0.5, 0, 0.5, 1, 1, 0, 1, 1};
    const int32_t degrees[] = {2, 1};
    const int64_t counts[] = {5, 2};
    nurbs *g = NULL;
    double box[4] = {0};
    int64_t count = 0;
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 12, 2, points, 0, 0, NULL, 0, 0, &g));
    CHECK_OK(nurbs_singular_points(g, 1e-3, 0, NULL, NULL, &count, NULL));
    CHECK_INT(count, 1);
    CHECK_OK(nurbs_singular_points(g, 1e-3, 1, NULL, box, &count, NULL));
    CHECK_DOUBLES(box, ((const double[]){0.5, 0.5, 0, 1}), 4);
    nurbs_destroy(g);
}

/* A periodic axis closes, however its knots are rounded. */
static void periodic_contact(void) {
    const double breaks[] = {0, 0.1, 0.3, 0.7, 1.1};
    const double points[] = {0,   0,   0, 1, 1.3, 0, 1.3, 1, 1.1, 0.7, 1.1, 1.7, 0.1, 0.9,
                             0.1, 1.9, 0, 0, 0,   1, 1.3, 0, 1.3, 1,   1.1, 0.7, 1.1, 1.7};
    const int32_t degrees[] = {3, 1};
    const int64_t counts[] = {7, 2};
    double knots[15] = {0}, gaps[2];
    int32_t closed[2];
    nurbs *g = NULL;
    CHECK_OK(nurbs_knots_periodic(3, 5, breaks, NULL, 11, knots));
    knots[13] = knots[14] = 1;
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 15, 2, points, 0, 0, NULL, 0, NURBS_PERIODIC, &g));
    CHECK_OK(nurbs_boundary_contacts(g, 0, closed, gaps, NULL, NULL));
    CHECK(closed[0] == 1 && gaps[0] == 0 && closed[1] == 0);
    nurbs_destroy(g);
}

/* An end that is not clamped is rounded: (1 + (1 + eps)) / 2 becomes 1, as the other end is, and as the other
 * end of that boundary of the surface is. */
static void unclamped_contacts(void) {
    const double points[] = {1, 1, 1 + DBL_EPSILON, 1, 1, 3, 1, 1, 1, 1},
                 column[] = {1, 1 + DBL_EPSILON, 1 - 2 * DBL_EPSILON, 1, 1},
                 knots[] = {0, 1, 2, 3, 4, 5, 6, 7, 0, 0, 1, 1};
    const int32_t degrees[] = {2, 1};
    const int64_t counts[] = {5, 2};
    double gaps[2], sizes[4];
    int32_t closed[2], collapsed[4];
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(1, degrees, counts, knots, 8, 1, column, 0, 0, NULL, 0, 0, &g));
    CHECK_OK(nurbs_boundary_contacts(g, 1e-13, closed, gaps, NULL, NULL));
    CHECK(closed[0] == 1 && gaps[0] >= DBL_EPSILON / 2);
    nurbs_destroy(g);
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 12, 1, points, 0, 0, NULL, 0, 0, &g));
    CHECK_OK(nurbs_boundary_contacts(g, 1e-13, closed, gaps, collapsed, sizes));
    CHECK(closed[0] == 1 && gaps[0] >= DBL_EPSILON / 2);
    CHECK(closed[1] == 0 && gaps[1] >= 1);
    CHECK(collapsed[0] == 1 && sizes[0] >= DBL_EPSILON / 4);
    nurbs_destroy(g);
}

/* Weights of both signs magnify the rounding at ends that are not clamped: x = 3 w(t) / w(t) = 3 at the start,
 * where w(t) is 2^-20 of the weights, and what is computed there at the end. */
static void cancelling_contacts(void) {
    const int32_t degree = 2;
    const int64_t count = 5;
    for (int i = 0; i < 20; ++i) {
        const double knots[] = {0, 1, 2, 3.1 + i / 16.0, 4.5, 5, 6, 7}, share = 1 / (knots[3] - 1);
        const double w = (float)((1 - share) / share * (1 + 0x1p-20)); /* 3 w is exact, too */
        double records[] = {-3, -1, 3 * w, w, 3, 1, 3, 1, 3, 1}, start = 0, gap = 0;
        nurbs *g = NULL;
        CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 8, 1, records, 0, 0, 0, &g));
        CHECK_OK(nurbs_eval(g, 1, &knots[2], 0, 0, &start, 0, 0, 0));
        nurbs_destroy(g);
        records[6] = records[8] = start;
        CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 8, 1, records, 0, 0, 0, &g));
        CHECK_OK(nurbs_boundary_contacts(g, 1, NULL, &gap, NULL, NULL));
        CHECK(gap >= fabs(start - 3));
        nurbs_destroy(g);
    }
}

static void monotone_pieces(void) {
    nurbs *g = make(arch());
    const double up[] = {0, 1};
    double starts[2];
    int32_t signs[2], complete;
    int64_t count;
    CHECK_OK(nurbs_curve_monotone_pieces(g, up, 2, starts, signs, &count, &complete));
    CHECK_INT(count, 2);
    CHECK_INT(complete, 1);
    CHECK_DOUBLE(starts[0], 0);
    CHECK(fabs(starts[1] - 0.5) < 1e-15);
    CHECK_INT(signs[0], 1);
    CHECK_INT(signs[1], -1);
    nurbs_destroy(g);
    g = make(stairs());
    CHECK_OK(nurbs_curve_monotone_pieces(g, up + 1, 0, NULL, NULL, &count, NULL));
    CHECK_INT(count, 3);
    nurbs_destroy(g);
}

static void other_shapes(void) {
    int32_t convexity = -1, closed[3], collapsed[6], result = -1;
    double origin[4], direction[4], bound, gaps[3], sizes[6], at[3];
    nurbs *g = make(circle());
    CHECK_OK(nurbs_curve_convexity(g, &convexity));
    CHECK_INT(convexity, NURBS_CONVEXITY_LEFT);
    CHECK_OK(nurbs_boundary_contacts(g, 0, closed, gaps, collapsed, sizes));
    CHECK(closed[0] == 1 && gaps[0] == 0 && collapsed[0] == 1 && collapsed[1] == 1 && sizes[1] == 0);
    nurbs_destroy(g);
    g = make(patch()); /* z = u v: planes z = (u + v) / 2 - 1/8 are 1/8 from it */
    CHECK_OK(nurbs_planarity(g, origin, direction, &bound));
    CHECK(bound >= 0.1 && bound <= 0.26);
    CHECK_OK(nurbs_straightness(g, origin, direction, &bound));
    CHECK(bound >= 0.5 && bound <= 1.2);
    CHECK_OK(nurbs_fold_test(g, NULL, &result, at, NULL));
    CHECK_INT(result, NURBS_FOLD_NONE);
    CHECK(at[0] >= 0 && at[0] <= 1);
    nurbs_destroy(g);
    g = make(cube());
    CHECK_OK(nurbs_boundary_contacts(g, 0.5, closed, gaps, collapsed, sizes));
    CHECK(closed[0] == 0 && gaps[0] >= 1 && collapsed[5] == 0 && sizes[0] >= 0.7 && sizes[0] < 0.8);
    CHECK_OK(nurbs_straightness(g, origin, direction, &bound));
    nurbs_destroy(g);
    g = make(trough());
    int64_t count = -1;
    CHECK_OK(nurbs_singular_points(g, 1e-6, 0, NULL, NULL, &count, result == 0 ? closed : NULL));
    CHECK_INT(count, 0);
    CHECK_INT(closed[0], 1);
    nurbs_destroy(g);
}

/* A curve that is one point: C' vanishes everywhere. */
static void a_point(void) {
    const double points[] = {1, 2, 1, 2, 1, 2};
    const int32_t degree = 2;
    nurbs *g = NULL;
    double box[2], bound, direction[2];
    int32_t convexity, complete;
    int64_t count;
    CHECK_OK(nurbs_create_bezier(1, &degree, 2, points, 0, 0, NULL, 0, &g));
    CHECK_OK(nurbs_curve_convexity(g, &convexity));
    CHECK_INT(convexity, NURBS_CONVEXITY_UNDECIDED);
    CHECK_OK(nurbs_curve_features(g, 0x3f, 0, NULL, NULL, NULL, &count, &complete));
    CHECK_INT(count, 0);
    CHECK_OK(nurbs_straightness(g, NULL, direction, &bound));
    CHECK(bound < 1e-13 && hypot(direction[0], direction[1]) > 0.99);
    CHECK_OK(nurbs_singular_points(g, 1e-6, 1, NULL, box, &count, NULL));
    CHECK_INT(count, 1);
    CHECK(box[0] == 0 && box[1] == 1);
    CHECK_FAILS(nurbs_singular_points(g, 1e-6, 1, box + 1, box, &count, NULL), NURBS_ERROR_OVERLAP,
                "boxes|params");
    nurbs_destroy(g);
}

/* A weight that vanishes inside: nothing is proven, nothing fails. */
static void a_pole(void) {
    const int32_t degree = 2;
    const int64_t size = 3;
    const double knots[] = {0, 0, 0, 1, 1, 1}, records[] = {1, 1, 1, 0, 1, 0, 1, 2, -1};
    nurbs *g = NULL;
    int32_t complete = -1, convexity = -1;
    int64_t count;
    double bound;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &size, knots, 6, 2, records, 0, 0, 0, &g));
    CHECK_OK(nurbs_curve_features(g, 0x3f, 0, NULL, NULL, NULL, &count, &complete));
    CHECK_INT(complete, 0);
    CHECK_OK(nurbs_curve_convexity(g, &convexity));
    CHECK_FAILS(nurbs_straightness(g, NULL, NULL, &bound), NURBS_ERROR_NOT_REPRESENTABLE, "bound");
    nurbs_destroy(g);
}

static void refused_curves(void) {
    nurbs *g = make(arch()), *s = make(patch()), *line = make(jump()), *round = make(loop());
    double a[8], b[8];
    int32_t i[8], complete;
    int64_t count;
    const double up[] = {0, 1}, nothing[] = {0, 0}, nan[] = {NAN, 0};
    FILL(a);
    FILL(b);
    FILL(i);
    CHECK_FAILS(nurbs_curve_features(NULL, 1, 0, a, i, b, &count, &complete), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_curve_features(s, 1, 0, a, i, b, &count, &complete), NURBS_ERROR_AXES, "2 axes");
    CHECK_FAILS(nurbs_curve_features(line, 1, 0, a, i, b, &count, &complete), NURBS_ERROR_DIMENSION,
                "dimension 1");
    CHECK_FAILS(nurbs_curve_features(g, 0x80, 0, a, i, b, &count, &complete), NURBS_ERROR_FLAGS, "0x80");
    CHECK_FAILS(nurbs_curve_features(g, NURBS_FEATURE_TORSION, 0, a, i, b, &count, &complete),
                NURBS_ERROR_DIMENSION, "TORSION");
    CHECK_FAILS(nurbs_curve_features(g, 6, -1, a, i, b, &count, &complete), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_curve_features(round, 6, 7, a, i, b, &count, &complete), NURBS_ERROR_SIZE, "cap = 7|8");
    CHECK_FAILS(nurbs_curve_features(round, 6, 8, a, i, a + 1, &count, &complete), NURBS_ERROR_OVERLAP,
                "values|params");
    CHECK_FAILS(nurbs_curve_monotone_pieces(NULL, up, 0, a, i, &count, &complete), NURBS_ERROR_NULL,
                "g is NULL");
    CHECK_FAILS(nurbs_curve_monotone_pieces(s, up, 0, a, i, &count, &complete), NURBS_ERROR_AXES, "curve");
    CHECK_FAILS(nurbs_curve_monotone_pieces(g, NULL, 0, a, i, &count, &complete), NURBS_ERROR_NULL,
                "direction");
    CHECK_FAILS(nurbs_curve_monotone_pieces(g, nothing, 0, a, i, &count, &complete), NURBS_ERROR_DIRECTION,
                "direction is zero");
    CHECK_FAILS(nurbs_curve_monotone_pieces(g, nan, 0, a, i, &count, &complete), NURBS_ERROR_DIRECTION,
                "direction[0]");
    CHECK_FAILS(nurbs_curve_monotone_pieces(g, up, -1, a, i, &count, &complete), NURBS_ERROR_COUNT, "cap");
    CHECK_FAILS(nurbs_curve_monotone_pieces(g, up, 1, a, i, &count, &complete), NURBS_ERROR_SIZE,
                "cap = 1|2");
    CHECK_FAILS(nurbs_curve_monotone_pieces(g, up, 2, a, i, (int64_t *)(void *)a, NULL), NURBS_ERROR_OVERLAP,
                "count|starts");
    CHECK_FAILS(nurbs_curve_convexity(NULL, i), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_curve_convexity(g, NULL), NURBS_ERROR_NULL, "convexity");
    CHECK_FAILS(nurbs_curve_convexity(s, i), NURBS_ERROR_AXES, "curve");
    CHECK_FAILS(nurbs_curve_convexity(line, i), NURBS_ERROR_DIMENSION, "dimension 1");
    CHECK_UNTOUCHED(a);
    CHECK_UNTOUCHED(b);
    CHECK_UNTOUCHED(i);
    nurbs_destroy(round);
    nurbs_destroy(line);
    nurbs_destroy(s);
    nurbs_destroy(g);
}

static void refused(void) {
    nurbs *g = make(trough()), *c = make(arch()), *v = make(cube());
    double a[8], b[8], d[8];
    int32_t i[8], j[8];
    int64_t count;
    const double up[] = {0, 0, 1}, zero[] = {0, 0, 0}, bad[] = {0, INFINITY, 0};
    FILL(a);
    FILL(b);
    FILL(d);
    FILL(i);
    FILL(j);
    CHECK_FAILS(nurbs_straightness(NULL, a, b, d), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_straightness(g, a, b, NULL), NURBS_ERROR_NULL, "bound");
    CHECK_FAILS(nurbs_straightness(g, a, a + 2, d), NURBS_ERROR_OVERLAP, "direction|origin");
    CHECK_FAILS(nurbs_planarity(NULL, a, b, d), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_planarity(c, a, b, d), NURBS_ERROR_DIMENSION, "dimension 2");
    CHECK_FAILS(nurbs_planarity(g, a, b, NULL), NURBS_ERROR_NULL, "bound");
    CHECK_FAILS(nurbs_planarity(g, a, b, b), NURBS_ERROR_OVERLAP, "bound|normal");
    CHECK_FAILS(nurbs_boundary_contacts(NULL, 0, i, a, j, b), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_boundary_contacts(g, -1, i, a, j, b), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_boundary_contacts(g, 0, i, a, i, b), NURBS_ERROR_OVERLAP, "collapsed|closed");
    CHECK_FAILS(nurbs_singular_points(NULL, 1, 0, a, b, &count, i), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_singular_points(v, 1, 0, a, b, &count, i), NURBS_ERROR_AXES, "3 axes");
    CHECK_FAILS(nurbs_singular_points(g, 0, 0, a, b, &count, i), NURBS_ERROR_TOLERANCE, "tolerance = 0");
    CHECK_FAILS(nurbs_singular_points(g, NAN, 0, a, b, &count, i), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_singular_points(g, 1, -3, a, b, &count, i), NURBS_ERROR_COUNT, "cap = -3");
    CHECK_FAILS(nurbs_fold_test(NULL, up, i, a, b), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_fold_test(c, NULL, i, a, b), NURBS_ERROR_AXES, "1 axis");
    CHECK_FAILS(nurbs_fold_test(v, NULL, i, a, b), NURBS_ERROR_DIMENSION, "dimension 4");
    CHECK_FAILS(nurbs_fold_test(g, up, NULL, a, b), NURBS_ERROR_NULL, "result");
    CHECK_FAILS(nurbs_fold_test(g, zero, i, a, b), NURBS_ERROR_DIRECTION, "reference is zero");
    CHECK_FAILS(nurbs_fold_test(g, bad, i, a, b), NURBS_ERROR_DIRECTION, "reference[1]");
    CHECK_FAILS(nurbs_fold_test(g, up, i, a, a + 1), NURBS_ERROR_OVERLAP, "negative|positive");
    CHECK_UNTOUCHED(a);
    CHECK_UNTOUCHED(b);
    CHECK_UNTOUCHED(d);
    CHECK_UNTOUCHED(i);
    CHECK_UNTOUCHED(j);
    nurbs_destroy(v);
    nurbs_destroy(c);
    nurbs_destroy(g);
}

static void reference_that_does_not_suit(void) {
    const double corners[] = {0, 0, 1, 0, 0, 1, 1, 1}, up[] = {0, 0, 1};
    const int32_t degrees[] = {1, 1};
    nurbs *g = NULL;
    int32_t result = -1;
    double at[2];
    CHECK_OK(nurbs_create_bezier(2, degrees, 2, corners, 0, 0, NULL, 0, &g));
    CHECK_FAILS(nurbs_fold_test(g, up, &result, NULL, NULL), NURBS_ERROR_DIRECTION, "in space");
    CHECK_OK(nurbs_fold_test(g, NULL, &result, at, NULL));
    CHECK_INT(result, NURBS_FOLD_NONE);
    CHECK(isnan(at[0])); /* J = -1 */
    nurbs_destroy(g);
}

/* Coordinates that overflow in the middle of the work. */
static void enormous(void) {
    const double points[] = {-1.7e308, 0, 0, 1.7e308, 1.7e308, 0};
    const int32_t degree = 2;
    nurbs *g = NULL;
    int64_t count;
    int32_t convexity;
    double bound;
    CHECK_OK(nurbs_create_bezier(1, &degree, 2, points, 0, 0, NULL, 0, &g));
    nurbs_status status = nurbs_curve_features(g, 0x3f, 0, NULL, NULL, NULL, &count, NULL);
    CHECK(status == NURBS_OK || status == NURBS_ERROR_NOT_REPRESENTABLE);
    status = nurbs_curve_convexity(g, &convexity);
    CHECK(status == NURBS_OK || status == NURBS_ERROR_NOT_REPRESENTABLE);
    status = nurbs_straightness(g, NULL, NULL, &bound);
    CHECK(status == NURBS_OK || status == NURBS_ERROR_NOT_REPRESENTABLE);
    nurbs_destroy(g);
}

int main(void) {
    features();
    cusp_of_lines();
    curvature_that_jumps();
    inflection_at_a_seam();
    convex_but_for_a_jump();
    straight_from_start_to_end();
    fold_between_poles();
    singular_between_pieces();
    periodic_contact();
    unclamped_contacts();
    cancelling_contacts();
    monotone_pieces();
    other_shapes();
    a_point();
    a_pole();
    refused_curves();
    refused();
    reference_that_does_not_suit();
    enormous();
    return check_summary("analysis");
}
