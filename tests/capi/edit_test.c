/* SPDX-License-Identifier: MIT */
/* The group "edit": weights and control points changed so that a point goes where it is wanted, and inverse
 * knot insertion. */
#include "check.h"
#include "shapes.h"

#define VALUES(...) ((const double[]){__VA_ARGS__})
#define INDICES(...) ((const int64_t[]){__VA_ARGS__})

static double weight_of(const nurbs *g, int64_t i) {
    double weights[64];
    int64_t count = 0;
    CHECK_OK(nurbs_point_count(g, &count));
    CHECK_OK(nurbs_weights(g, count, weights, 0));
    return weights[i];
}

/* The middle of the arch is (2, 3/2), without point 1 it is (13/5, 6/5). */
static void pull_weight(void) {
    nurbs *g = make(arch()), *h = NULL;
    double weight = 0, at[2];
    const double to[] = {-1, 0.5}; /* from the middle to control point 1 */
    const double reach = sqrt(1.25), d = reach / 2;
    CHECK_OK(nurbs_pull_weight(g, 1, VALUES(0.5), d, &weight, &h));
    /* R = 3/8: w* = 1 + d / (R d) = 1 + 8/3 */
    CHECK(fabs(weight - 11.0 / 3) < 1e-14 && weight_of(h, 1) == weight && weight_of(h, 2) == 1);
    CHECK_OK(nurbs_eval(h, 1, VALUES(0.5), 0, 0, at, 0, 0, 0));
    CHECK(fabs(at[0] - (2 + to[0] / 2)) < 1e-15 && fabs(at[1] - (1.5 + to[1] / 2)) < 1e-15);
    nurbs_destroy(h);
    CHECK_OK(nurbs_pull_weight(g, 1, VALUES(0.5), 0, NULL, &h));
    CHECK(weight_of(h, 1) == 1);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_pull_weight(g, 1, VALUES(0.5), 1.2, &weight, &h), NURBS_ERROR_LENGTH,
                    "distance = 1.2|less than 1.118");
    CHECK_NO_HANDLE(h, nurbs_pull_weight(g, 1, VALUES(0.5), NAN, &weight, &h), NURBS_ERROR_LENGTH,
                    "distance = nan");
    CHECK_NO_HANDLE(h, nurbs_pull_weight(g, 1, VALUES(0.5), -1, &weight, &h), NURBS_ERROR_WEIGHT_SIGN,
                    "distance = -1|more than -0.670");
    CHECK_NO_HANDLE(h, nurbs_pull_weight(g, 1, VALUES(0), 1, &weight, &h), NURBS_ERROR_INFLUENCE,
                    "control point 1 has no influence at (0), where 0 act");
    CHECK_NO_HANDLE(h, nurbs_pull_weight(g, 0, VALUES(0), 1, &weight, &h), NURBS_ERROR_LENGTH, "less than 0");
    CHECK_NO_HANDLE(h, nurbs_pull_weight(g, 4, VALUES(0.5), 1, &weight, &h), NURBS_ERROR_INDEX,
                    "index = 4, expected 0 to 3");
    CHECK_NO_HANDLE(h, nurbs_pull_weight(g, -1, VALUES(0.5), 1, &weight, &h), NURBS_ERROR_INDEX,
                    "index = -1");
    CHECK_NO_HANDLE(h, nurbs_pull_weight(g, 1, VALUES(2), 1, &weight, &h), NURBS_ERROR_OUTSIDE_DOMAIN,
                    "params[0] = 2");
    CHECK_NO_HANDLE(h, nurbs_pull_weight(g, 1, VALUES(NAN), 1, &weight, &h), NURBS_ERROR_PARAMETER_NOT_FINITE,
                    "params[0]");
    CHECK_NO_HANDLE(h, nurbs_pull_weight(g, 1, NULL, 1, &weight, &h), NURBS_ERROR_NULL, "params is NULL");
    CHECK_NO_HANDLE(h, nurbs_pull_weight(NULL, 1, VALUES(0.5), 1, &weight, &h), NURBS_ERROR_NULL,
                    "g is NULL");
    CHECK_FAILS(nurbs_pull_weight(g, 1, VALUES(0.5), 1, &weight, NULL), NURBS_ERROR_NULL, "out is NULL");
    CHECK(fabs(weight - 11.0 / 3) < 1e-14); /* as it was */
    nurbs_destroy(g);
}

/* Two neighbours pull the curve to the leg between them: (2, 2) is its middle. */
static void pull_weights(void) {
    nurbs *g = make(arch()), *h = NULL;
    double factor = 0, at[2];
    CHECK_OK(nurbs_pull_weights(g, 2, INDICES(1, 2), VALUES(0.5), 0.25, &factor, &h));
    CHECK(fabs(factor - (1 + 0.25 / (0.75 * 0.25))) < 1e-14); /* R = 3/4, |Q S| = 1/2 */
    CHECK(weight_of(h, 1) == factor && weight_of(h, 2) == factor && weight_of(h, 3) == 1);
    CHECK_OK(nurbs_eval(h, 1, VALUES(0.5), 0, 0, at, 0, 0, 0));
    CHECK(fabs(at[0] - 2) < 1e-15 && fabs(at[1] - 1.75) < 1e-15);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_pull_weights(g, 0, INDICES(1, 2), VALUES(0.5), 0.1, &factor, &h),
                    NURBS_ERROR_COUNT, "count = 0");
    CHECK_NO_HANDLE(h, nurbs_pull_weights(g, 2, INDICES(1, 9), VALUES(0.5), 0.1, &factor, &h),
                    NURBS_ERROR_INDEX, "indices[1] = 9, expected 0 to 3");
    CHECK_NO_HANDLE(h, nurbs_pull_weights(g, 3, INDICES(1, 2, 1), VALUES(0.5), 0.1, &factor, &h),
                    NURBS_ERROR_INDEX, "indices[2] = 1 is the same control point as indices[0]");
    CHECK_NO_HANDLE(h, nurbs_pull_weights(g, 2, NULL, VALUES(0.5), 0.1, &factor, &h), NURBS_ERROR_NULL,
                    "indices is NULL");
    CHECK_NO_HANDLE(h, nurbs_pull_weights(g, INT64_MAX, INDICES(1, 2), VALUES(0.5), 0.1, &factor, &h),
                    NURBS_ERROR_OVERFLOW, "indices");
    CHECK_NO_HANDLE(h, nurbs_pull_weights(g, 2, INDICES(1, 2), VALUES(1), 0.1, &factor, &h),
                    NURBS_ERROR_INFLUENCE, "indices|(1), where 3 act");
    nurbs_destroy(g);
    g = make(loop()); /* points 4 and 5 are copies of 0 and 1 */
    CHECK_NO_HANDLE(h, nurbs_pull_weights(g, 2, INDICES(1, 5), VALUES(2.5), 0.1, &factor, &h),
                    NURBS_ERROR_INDEX, "indices[1] = 5 is the same");
    CHECK_OK(nurbs_pull_weight(g, 5, VALUES(2.5), 0.1, &factor, &h));
    CHECK(factor > 1 && weight_of(h, 1) == factor && weight_of(h, 5) == factor && weight_of(h, 0) == 1);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void set_weights(void) {
    nurbs *g = make(arch()), *h = NULL;
    CHECK_OK(nurbs_set_weights(g, 2, INDICES(2, 1), VALUES(0, 3), &h));
    CHECK_WEIGHTS(h, VALUES(1, 3, 0, 1));
    CHECK_POINTS(h, arch().points);
    nurbs_destroy(h);
    CHECK_OK(nurbs_set_weights(g, 0, NULL, NULL, &h));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_set_weights(g, -1, INDICES(2), VALUES(1), &h), NURBS_ERROR_COUNT, "count = -1");
    CHECK_NO_HANDLE(h, nurbs_set_weights(g, 1, INDICES(4), VALUES(1), &h), NURBS_ERROR_INDEX,
                    "indices[0] = 4");
    CHECK_NO_HANDLE(h, nurbs_set_weights(g, 1, INDICES(1), VALUES(-1), &h), NURBS_ERROR_WEIGHT_NEGATIVE,
                    "weights[0] = -1");
    CHECK_NO_HANDLE(h, nurbs_set_weights(g, 1, INDICES(1), VALUES(INFINITY), &h),
                    NURBS_ERROR_WEIGHT_NOT_FINITE, "weights[0] = inf");
    CHECK_NO_HANDLE(h, nurbs_set_weights(g, 1, INDICES(0), VALUES(0), &h), NURBS_ERROR_WEIGHTS_VANISH,
                    "parameter (0)");
    CHECK_NO_HANDLE(h, nurbs_set_weights(g, 1, INDICES(1), VALUES(1.7e308), &h),
                    NURBS_ERROR_NOT_REPRESENTABLE, "overflows");
    CHECK_NO_HANDLE(h, nurbs_set_weights(g, 1, INDICES(1), NULL, &h), NURBS_ERROR_NULL, "weights is NULL");
    nurbs_destroy(g);
}

/* A half circle with its middle control point at infinity. */
static nurbs *half_circle(void) {
    static const int32_t degree = 2;
    static const int64_t count = 3;
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, VALUES(0, 0, 0, 1, 1, 1), 6, 2,
                                      VALUES(1, 0, 1, 0, 1, 0, -1, 0, 1), 0, 0, 0, &g));
    return g;
}

static void infinite_points(void) {
    nurbs *g = half_circle(), *h = NULL;
    double at[2], weight = 0;
    CHECK_NO_HANDLE(h, nurbs_set_weights(g, 1, INDICES(0), VALUES(2), &h), NURBS_ERROR_POINT_NOT_FINITE,
                    "control point 1 is at infinity");
    CHECK_NO_HANDLE(h, nurbs_pull_weight(g, 1, VALUES(0.5), 0.1, &weight, &h), NURBS_ERROR_INFLUENCE,
                    "control point 1|where 0, 2 act");
    CHECK_NO_HANDLE(h, nurbs_weight_through(g, 1, VALUES(0.5), VALUES(0, 1), 1, &weight, &h),
                    NURBS_ERROR_POINT_NOT_FINITE, "control point 1 is at infinity");
    CHECK_FAILS(nurbs_weight_points(g, 1, VALUES(0.5), at, NULL, NULL), NURBS_ERROR_POINT_NOT_FINITE,
                "control point 1 is at infinity");
    CHECK_NO_HANDLE(h, nurbs_insert_on_leg(g, 0, 0, 0.5, NULL, &h), NURBS_ERROR_POINT_NOT_FINITE,
                    "control point 1 is at infinity");
    CHECK_NO_HANDLE(h, nurbs_insert_at_point(g, 0, VALUES(1, 0), INFINITY, NULL, NULL, NULL, &h),
                    NURBS_ERROR_OFF_POLYGON, "no leg");
    /* Weight 1 of point 0 pulls (0, 1) towards (1, 0). */
    CHECK_OK(nurbs_pull_weight(g, 0, VALUES(0.5), sqrt(2) / 2, &weight, &h));
    CHECK_OK(nurbs_eval(h, 1, VALUES(0.5), 0, 0, at, 0, 0, 0));
    CHECK(fabs(at[0] - 0.5) < 1e-15 && fabs(at[1] - 0.5) < 1e-15);
    nurbs_destroy(h);
    CHECK_OK(nurbs_pull_point(g, 0, VALUES(0.5), VALUES(0, 5), 1, &weight, &h)); /* R = 1/2 */
    CHECK_OK(nurbs_eval(h, 1, VALUES(0.5), 0, 0, at, 0, 0, 0));
    CHECK(at[0] == 0 && at[1] == 2 && weight == 2);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void weight_points(void) {
    nurbs *g = make(circle()), *h = NULL;
    double zero[2], one[2], present[2], weight = 0;
    CHECK_OK(nurbs_weight_points(g, 1, VALUES(0.125), zero, one, present)); /* the shoulder of a quarter */
    CHECK_NEAR(zero, VALUES(0.5, 0.5), 2, 1e-15);
    CHECK_NEAR(one, VALUES(0.75, 0.75), 2, 1e-15);
    CHECK_NEAR(present, VALUES(HALF_ROOT, HALF_ROOT), 2, 1e-15);
    CHECK_OK(nurbs_weight_cross_ratio(2, VALUES(1, 1), zero, one, present, &weight));
    CHECK(fabs(weight - HALF_ROOT) < 1e-14);
    CHECK_OK(nurbs_weight_points(g, 0, VALUES(0), zero, one, NULL));
    CHECK(isnan(zero[0]) && isnan(zero[1]) && one[0] == 1 && one[1] == 0);
    FILL(zero);
    CHECK_FAILS(nurbs_weight_points(g, 9, VALUES(0.125), zero, one, present), NURBS_ERROR_INDEX, "index = 9");
    CHECK_FAILS(nurbs_weight_points(g, 1, VALUES(-1), zero, one, present), NURBS_ERROR_OUTSIDE_DOMAIN,
                "params[0]");
    CHECK_FAILS(nurbs_weight_points(g, 1, VALUES(INFINITY), zero, one, present),
                NURBS_ERROR_PARAMETER_NOT_FINITE, "params[0]");
    CHECK_FAILS(nurbs_weight_points(g, 1, VALUES(0.5), zero, zero + 1, NULL), NURBS_ERROR_OVERLAP, "at_");
    CHECK_FAILS(nurbs_weight_points(NULL, 1, VALUES(0.5), zero, NULL, NULL), NURBS_ERROR_NULL, "g is NULL");
    CHECK_UNTOUCHED(zero);
    nurbs_destroy(g);
    (void)h;
}

static void cross_ratio(void) {
    double weight = -1;
    CHECK_OK(nurbs_weight_cross_ratio(1, VALUES(0), VALUES(4), VALUES(2), VALUES(1), &weight));
    CHECK(weight == 3); /* (2 / 2) / (1 / 3) */
    CHECK_OK(nurbs_weight_cross_ratio(1, VALUES(0), VALUES(4), VALUES(2), VALUES(4), &weight));
    CHECK(weight == 0);
    CHECK_OK(nurbs_weight_cross_ratio(1, VALUES(0), VALUES(4), VALUES(2), VALUES(0), &weight));
    CHECK(weight == INFINITY);
    CHECK_OK(nurbs_weight_cross_ratio(2, VALUES(0, 0), VALUES(1e308, 1e308), VALUES(5e307, 5e307),
                                      VALUES(2.5e307, 2.5e307), &weight));
    CHECK(fabs(weight - 3) < 1e-14);
    weight = -1;
    CHECK_FAILS(nurbs_weight_cross_ratio(1, VALUES(2), VALUES(2), VALUES(2), VALUES(1), &weight),
                NURBS_ERROR_COLLINEAR, "control_point and at_zero");
    CHECK_FAILS(nurbs_weight_cross_ratio(1, VALUES(2), VALUES(4), VALUES(2), VALUES(1), &weight),
                NURBS_ERROR_COLLINEAR, "at_one is control_point");
    CHECK_FAILS(nurbs_weight_cross_ratio(1, VALUES(2), VALUES(4), VALUES(4), VALUES(1), &weight),
                NURBS_ERROR_COLLINEAR, "at_one is at_zero");
    CHECK_FAILS(nurbs_weight_cross_ratio(0, VALUES(2), VALUES(4), VALUES(4), VALUES(1), &weight),
                NURBS_ERROR_DIMENSION, "dim = 0");
    CHECK_FAILS(nurbs_weight_cross_ratio(1, VALUES(2), VALUES(4), VALUES(NAN), VALUES(1), &weight),
                NURBS_ERROR_POINT_NOT_FINITE, "at_one[0]");
    CHECK_FAILS(nurbs_weight_cross_ratio(1, VALUES(2), NULL, VALUES(3), VALUES(1), &weight), NURBS_ERROR_NULL,
                "at_zero is NULL");
    CHECK_FAILS(nurbs_weight_cross_ratio(1, VALUES(2), VALUES(4), VALUES(3), VALUES(1), NULL),
                NURBS_ERROR_NULL, "weight is NULL");
    CHECK_FAILS(nurbs_weight_cross_ratio(1, &weight, VALUES(4), VALUES(3), VALUES(1), &weight),
                NURBS_ERROR_OVERLAP, "weight");
    CHECK(weight == -1);
}

static void weight_through(void) {
    nurbs *g = make(circle()), *h = NULL;
    double weight = 0, at[2];
    CHECK_OK(nurbs_weight_through(g, 1, VALUES(0.125), VALUES(0.75, 0.75), 0.001, &weight, &h));
    CHECK(fabs(weight - 1) < 1e-14 && weight_of(h, 1) == weight);
    nurbs_destroy(h);
    CHECK_OK(nurbs_weight_through(g, 1, VALUES(0.125), VALUES(0.8, 0.7), 0.1, &weight,
                                  &h)); /* to its projection */
    CHECK_OK(nurbs_eval(h, 1, VALUES(0.125), 0, 0, at, 0, 0, 0));
    CHECK_NEAR(at, VALUES(0.75, 0.75), 2, 1e-15);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_weight_through(g, 1, VALUES(0.125), VALUES(0.8, 0.7), 0.01, &weight, &h),
                    NURBS_ERROR_GAP, "target: distance 0.0707");
    CHECK_NO_HANDLE(h, nurbs_weight_through(g, 1, VALUES(0.125), VALUES(0.25, 0.25), 1, &weight, &h),
                    NURBS_ERROR_WEIGHT_SIGN, "control point 1 would be -");
    CHECK_NO_HANDLE(h, nurbs_weight_through(g, 1, VALUES(0.125), VALUES(2, 2), 1, &weight, &h),
                    NURBS_ERROR_WEIGHT_SIGN, "would be -");
    CHECK_NO_HANDLE(h, nurbs_weight_through(g, 1, VALUES(0.125), VALUES(1, 1), 1, &weight, &h),
                    NURBS_ERROR_NOT_REPRESENTABLE, "overflows");
    CHECK_NO_HANDLE(h, nurbs_weight_through(g, 3, VALUES(0.125), VALUES(1, 1), 1, &weight, &h),
                    NURBS_ERROR_INFLUENCE, "control point 3|where 0, 1, 2 act");
    CHECK_NO_HANDLE(h, nurbs_weight_through(g, 1, VALUES(0.125), VALUES(1, 1), -1, &weight, &h),
                    NURBS_ERROR_TOLERANCE, "tolerance = -1");
    CHECK_NO_HANDLE(h, nurbs_weight_through(g, 1, VALUES(0.125), VALUES(1, NAN), 1, &weight, &h),
                    NURBS_ERROR_POINT_NOT_FINITE, "target[1]");
    CHECK_NO_HANDLE(h, nurbs_weight_through(g, 1, VALUES(0.125), NULL, 1, &weight, &h), NURBS_ERROR_NULL,
                    "target is NULL");
    nurbs_destroy(g);
}

static void pull_point(void) {
    nurbs *g = make(trough()), *h = NULL;
    double moved = 0, at[3];
    CHECK_OK(nurbs_pull_point(g, 5, VALUES(0.5, 1), VALUES(0, 0, -8), 0.25, &moved, &h)); /* R = 1/2 */
    CHECK(moved == 0.5);
    CHECK_OK(nurbs_eval(h, 1, VALUES(0.5, 1), 0, 0, at, 0, 0, 0));
    CHECK_DOUBLES(at, VALUES(0.5, 1, 1), 3);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_pull_point(g, 5, VALUES(0.5, 2), VALUES(0, 0, 1), 1, &moved, &h),
                    NURBS_ERROR_INFLUENCE, "control point 5|(0.5, 2), where 2, 6, 10 act");
    CHECK_NO_HANDLE(h, nurbs_pull_point(g, 5, VALUES(0.5, 1), VALUES(0, 0, 0), 1, &moved, &h),
                    NURBS_ERROR_DIRECTION, "direction is zero");
    CHECK_NO_HANDLE(h, nurbs_pull_point(g, 5, VALUES(0.5, 1), VALUES(0, NAN, 0), 1, &moved, &h),
                    NURBS_ERROR_DIRECTION, "direction[1]");
    CHECK_NO_HANDLE(h, nurbs_pull_point(g, 5, VALUES(0.5, 1), VALUES(0, 0, 1), INFINITY, &moved, &h),
                    NURBS_ERROR_LENGTH, "distance = inf");
    CHECK_NO_HANDLE(h, nurbs_pull_point(g, 5, VALUES(0.5, 1), VALUES(0, 0, 1), 1.7e308, &moved, &h),
                    NURBS_ERROR_NOT_REPRESENTABLE, "control points");
    CHECK_NO_HANDLE(h, nurbs_pull_point(g, 12, VALUES(0.5, 1), VALUES(0, 0, 1), 1, &moved, &h),
                    NURBS_ERROR_INDEX, "index = 12");
    CHECK_NO_HANDLE(h, nurbs_pull_point(g, 5, VALUES(0.5, 9), VALUES(0, 0, 1), 1, &moved, &h),
                    NURBS_ERROR_OUTSIDE_DOMAIN, "params[0]");
    CHECK_NO_HANDLE(h, nurbs_pull_point(g, 5, VALUES(0.5, 1), NULL, 1, &moved, &h), NURBS_ERROR_NULL,
                    "direction is NULL");
    CHECK(moved == 0.5);
    nurbs_destroy(g);
}

static void most_influential(void) {
    nurbs *g = make(arch());
    int64_t indices[3];
    double influences[3];
    FILL(indices);
    FILL(influences);
    CHECK_FAILS(nurbs_most_influential(g, 3, VALUES(0, 0.5, 2), 0, 0, indices, influences),
                NURBS_ERROR_OUTSIDE_DOMAIN, "params[2] = 2");
    CHECK_FAILS(nurbs_most_influential(g, 3, VALUES(0, NAN, 2), 0, 0, indices, influences),
                NURBS_ERROR_PARAMETER_NOT_FINITE, "params[1]");
    CHECK_FAILS(nurbs_most_influential(g, -1, VALUES(0), 0, 0, indices, influences), NURBS_ERROR_COUNT,
                "n = -1");
    CHECK_FAILS(nurbs_most_influential(g, 3, VALUES(0, 1, 1), -1, 0, indices, influences), NURBS_ERROR_STRIDE,
                "params");
    CHECK_FAILS(nurbs_most_influential(g, INT64_MAX, VALUES(0), 0, 0, indices, influences),
                NURBS_ERROR_OVERFLOW, "params");
    CHECK_FAILS(nurbs_most_influential(g, 3, influences, 0, 0, NULL, influences), NURBS_ERROR_OVERLAP,
                "influences|params");
    CHECK_FAILS(nurbs_most_influential(NULL, 3, VALUES(0, 0, 0), 0, 0, indices, influences), NURBS_ERROR_NULL,
                "g is NULL");
    CHECK_UNTOUCHED(indices);
    CHECK_UNTOUCHED(influences);
    CHECK_OK(nurbs_most_influential(g, 3, VALUES(0, 0.5, 1), 0, 0, indices, influences));
    CHECK(indices[0] == 0 && indices[1] == 1 && indices[2] == 3);
    CHECK_DOUBLES(influences, VALUES(1, 0.375, 1), 3);
    CHECK_OK(nurbs_most_influential(g, 1, VALUES(0.5), 0, 0, NULL, NULL));
    nurbs_destroy(g);
    g = make(loop());
    CHECK_OK(nurbs_most_influential(g, 1, VALUES(5.5), 0, 0, indices, influences));
    CHECK(indices[0] == 0 && influences[0] == 0.75); /* copy 4 of it */
    CHECK_OK(nurbs_most_influential(g, 1, VALUES(5), 0, 0, indices, influences));
    CHECK(indices[0] == 0 && influences[0] == 0.5); /* copy 4 of it, as much as 3 */
    nurbs_destroy(g);
}

/* Records (w x, w y, w) of a curve over [0, 1], with signs of the weights that Cartesian points do not
 * have. */
static nurbs *signed_weights(double first, double middle, double last) {
    const int32_t degree = 2;
    const int64_t count = 3;
    const double knots[] = {0, 0, 0, 1, 1, 1};
    const double records[] = {0, 0, first, middle, middle, middle, 2 * last, 0, last};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 6, 2, records, 0, 0, 0, &g));
    return g;
}

/* A weight below 0 stays below 0: the middle point is (1, w / (1 + w)), from (1, -1/7) to (1, -1/5). */
static void negative_weights(void) {
    nurbs *g = signed_weights(1, -0.125, 1), *h = NULL;
    const int64_t all[] = {0, 1, 2};
    double at[2], weight = 0;
    CHECK_OK(nurbs_pull_weight(g, 1, VALUES(0.5), -2.0 / 35, &weight, &h));
    CHECK(fabs(weight + 1.0 / 6) < 1e-15 && weight_of(h, 1) == weight);
    CHECK_OK(nurbs_eval(h, 1, VALUES(0.5), 0, 0, at, 0, 0, 0));
    CHECK_NEAR(at, VALUES(1, -0.2), 2, 1e-15);
    nurbs_destroy(h);
    CHECK_OK(nurbs_pull_weights(g, 1, all + 1, VALUES(0.5), 0, &weight, &h));
    CHECK(weight == 1 && weight_of(h, 1) == -0.125);
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = signed_weights(1, 1, -0.125);
    CHECK_NO_HANDLE(h, nurbs_insert_on_leg(g, 0, 1, 0.5, &weight, &h), NURBS_ERROR_WEIGHT_SIGN,
                    "control point 1 to 2 are 1 and -0.125");
    nurbs_destroy(g);
}

/* Homogeneous records move by their weights times what the points do. */
static void homogeneous_points(void) {
    nurbs *g = signed_weights(1, 4, 1), *h = NULL;
    double moved = 0, at[2], before[2];
    CHECK_OK(nurbs_eval(g, 1, VALUES(0.5), 0, 0, before, 0, 0, 0)); /* R = 4 / 5 */
    CHECK_OK(nurbs_pull_point(g, 1, VALUES(0.5), VALUES(0, 1), 0.2, &moved, &h));
    CHECK(fabs(moved - 0.25) < 1e-15);
    CHECK_OK(nurbs_eval(h, 1, VALUES(0.5), 0, 0, at, 0, 0, 0));
    CHECK_NEAR(at, VALUES(before[0], before[1] + 0.2), 2, 1e-15);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

/* One factor of all weights, however large, is one of the weights that are found. */
static void enormous_weights(void) {
    const double sizes[] = {0x1p+1000, 0x1p-1000};
    const int32_t degree = 2;
    for (int i = 0; i < 2; ++i) {
        const double weights[] = {sizes[i], 0.5 * sizes[i], sizes[i]};
        double weight = 0, zero[2], one[2], here[2];
        nurbs *g = NULL, *h = NULL;
        CHECK_OK(nurbs_create_bezier(1, &degree, 2, VALUES(0, 0, 1, 1, 2, 0), 0, 0, weights, 0, &g));
        /* the middle is (1, w / (1 + w)), w the quotient of the weights */
        CHECK_OK(nurbs_weight_through(g, 1, VALUES(0.5), VALUES(1, 0.5), 1e-9, &weight, &h));
        CHECK(fabs(weight / sizes[i] - 1) < 1e-14);
        nurbs_destroy(h);
        CHECK_OK(nurbs_weight_points(g, 1, VALUES(0.5), zero, one, here));
        CHECK_NEAR(zero, VALUES(1, 0), 2, 1e-15);
        CHECK_NEAR(here, VALUES(1, 1.0 / 3), 2, 1e-15);
        CHECK_NEAR(one, VALUES(1, i == 0 ? 0 : 1), 2, 1e-15); /* 1 beside the others is nothing, or all */
        nurbs_destroy(g);
    }
}

static void insert_on_leg(void) {
    nurbs *g = make(arch()), *h = NULL;
    double knot = -1;
    CHECK_OK(nurbs_insert_on_leg(g, 0, 1, 0.25, &knot, &h));
    CHECK(knot == 0.25);
    CHECK_POINTS(h, VALUES(0, 0, 0.25, 0.5, 1.5, 2, 3.25, 1.5, 4, 0));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_insert_on_leg(g, 0, 3, 0.5, &knot, &h), NURBS_ERROR_INDEX,
                    "index = 3 is the last");
    CHECK_NO_HANDLE(h, nurbs_insert_on_leg(g, 0, 4, 0.5, &knot, &h), NURBS_ERROR_INDEX, "index = 4");
    CHECK_NO_HANDLE(h, nurbs_insert_on_leg(g, 0, 1, 1.5, &knot, &h), NURBS_ERROR_FACTOR, "ratio = 1.5");
    CHECK_NO_HANDLE(h, nurbs_insert_on_leg(g, 0, 1, NAN, &knot, &h), NURBS_ERROR_FACTOR, "ratio = nan");
    CHECK_NO_HANDLE(h, nurbs_insert_on_leg(g, 0, 0, 0, &knot, &h), NURBS_ERROR_MULTIPLICITY,
                    "knot = 0 occurs 4 times");
    CHECK_NO_HANDLE(h, nurbs_insert_on_leg(g, 1, 0, 0, &knot, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_insert_on_leg(NULL, 0, 0, 0, &knot, &h), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_insert_on_leg(g, 0, 0, 0.5, &knot, NULL), NURBS_ERROR_NULL, "out is NULL");
    nurbs_destroy(g);
    g = make(stairs());
    CHECK_NO_HANDLE(h, nurbs_insert_on_leg(g, 0, 0, 0.5, &knot, &h), NURBS_ERROR_DEGREE,
                    "degree 0 of axis 0");
    nurbs_destroy(g);
    g = make(hill()); /* knots 1 to 3 belong to the first leg: the knot is outside the domain [2, 5] */
    CHECK_OK(nurbs_insert_on_leg(g, 0, 0, 0.25, &knot, &h));
    CHECK(knot == 1.5);
    CHECK_KNOTS(h, 0, VALUES(1, 1.5, 2, 3, 4, 5, 6, 7));
    CHECK_POINTS(h, VALUES(0.5, 2, 4, 2, 0));
    nurbs_destroy(h);
    CHECK_OK(nurbs_insert_on_leg(g, 0, 3, 0.75, &knot, &h));
    CHECK(knot == 5.5);
    CHECK_KNOTS(h, 0, VALUES(0, 1, 2, 3, 4, 5, 5.5, 6));
    CHECK_POINTS(h, VALUES(0, 2, 4, 2, 0.5));
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = make(trough()); /* along axis 1, in the second row: w = 1 */
    CHECK_OK(nurbs_insert_on_leg(g, 1, 5, 0.5, &knot, &h));
    CHECK(knot == 1.5);
    int64_t count = 0;
    double points[64];
    CHECK_OK(nurbs_point_count(h, &count));
    CHECK(count == 15);
    CHECK_OK(nurbs_points(h, 15, points, 0, 0));
    CHECK_DOUBLES(points + 3 * 7, VALUES(0.5, 1.5, 1.5), 3);
    nurbs_destroy(h);
    CHECK_OK(nurbs_set_weights(g, 1, INDICES(5), VALUES(0), &h));
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g, nurbs_insert_on_leg(h, 1, 5, 0.5, &knot, &g), NURBS_ERROR_WEIGHT_SIGN,
                    "control point 5 to 6 are 0 and 1");
    nurbs_destroy(h);
}

static void insert_at_point(void) {
    nurbs *g = make(arch()), *h = NULL;
    double knot = -1, ratio = -1;
    int64_t index = -1;
    CHECK_OK(nurbs_insert_at_point(g, 0, VALUES(1.5, 2.125), 0.125, &index, &ratio, &knot, &h));
    CHECK(index == 1 && ratio == 0.25 && knot == 0.25);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_insert_at_point(g, 0, VALUES(1.5, 2.25), 0.125, &index, &ratio, &knot, &h),
                    NURBS_ERROR_OFF_POLYGON, "distance 0.25|control point 1 along axis 0|tolerance = 0.125");
    CHECK_NO_HANDLE(h, nurbs_insert_at_point(g, 0, VALUES(0, 0), 1, &index, &ratio, &knot, &h),
                    NURBS_ERROR_MULTIPLICITY, "knot = 0");
    CHECK_NO_HANDLE(h, nurbs_insert_at_point(g, 0, VALUES(0, 0), -1, &index, &ratio, &knot, &h),
                    NURBS_ERROR_TOLERANCE, "tolerance = -1");
    CHECK_NO_HANDLE(h, nurbs_insert_at_point(g, 0, VALUES(0, INFINITY), 1, &index, &ratio, &knot, &h),
                    NURBS_ERROR_POINT_NOT_FINITE, "point[1]");
    CHECK_NO_HANDLE(h, nurbs_insert_at_point(g, 0, NULL, 1, &index, &ratio, &knot, &h), NURBS_ERROR_NULL,
                    "point is NULL");
    CHECK_NO_HANDLE(h, nurbs_insert_at_point(g, 2, VALUES(0, 0), 1, &index, &ratio, &knot, &h),
                    NURBS_ERROR_AXIS, "axis = 2");
    nurbs_destroy(g);
    g = make(stairs());
    CHECK_NO_HANDLE(h, nurbs_insert_at_point(g, 0, VALUES(0), 1, &index, &ratio, &knot, &h),
                    NURBS_ERROR_DEGREE, "degree 0");
    nurbs_destroy(g);
    CHECK(index == 1 && ratio == 0.25);
    g = make(hill());
    CHECK_OK(nurbs_insert_at_point(g, 0, VALUES(2), 0, &index, &ratio, &knot, &h));
    CHECK(index == 0 && ratio == 1 && knot == 3); /* the first of four legs */
    nurbs_destroy(h);
    nurbs_destroy(g);
}

int main(void) {
    pull_weight();
    pull_weights();
    set_weights();
    infinite_points();
    weight_points();
    cross_ratio();
    weight_through();
    pull_point();
    most_influential();
    negative_weights();
    homogeneous_points();
    enormous_weights();
    insert_on_leg();
    insert_at_point();
    return check_summary("edit");
}
