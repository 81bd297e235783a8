/* SPDX-License-Identifier: MIT */
/* nurbs_extend(), nurbs_unclamp(), nurbs_make_periodic() and nurbs_detect_periodic(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

/* Homogeneous records (w x, w), stored as such. */
static void check_records(int line, const nurbs *g, const double *expected) {
    double values[6] = {0};
    int64_t count = 0;
    int32_t homogeneous = 0;
    CHECK_OK(nurbs_is_homogeneous(g, &homogeneous));
    CHECK(homogeneous == 1);
    CHECK_OK(nurbs_point_count(g, &count));
    CHECK_OK(nurbs_homogeneous_points(g, count, values, 0, 0));
    check_bits(__FILE__, line, values, expected, 2 * (size_t)count * sizeof *values);
}
#define CHECK_RECORDS(g, expected) check_records(__LINE__, g, expected)

/* The parabola t^2 over [0, 1]. */
static nurbs *parabola(void) {
    static const int32_t degree = 2;
    static const double points[] = {0, 0, 1};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 1, points, 0, 0, NULL, 0, &g));
    return g;
}

static void extended(void) {
    nurbs *g = parabola(), *h = NULL;
    CHECK_OK(nurbs_extend(g, 0, NURBS_END, 1, 2, &h)); /* t^2 over [0, 2] */
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 2, 2, 2));
    CHECK_POINTS(h, VALUES(0, 0, 4));
    nurbs_destroy(h);
    CHECK_OK(nurbs_extend(g, 0, NURBS_END, 1, 1, &h)); /* 2 t - 1 behind 1 */
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 1, 2, 2, 2));
    CHECK_POINTS(h, VALUES(0, 0, 2, 3));
    nurbs_destroy(h);
    CHECK_OK(nurbs_extend(g, 0, NURBS_END, 1, 0, &h)); /* 1 behind 1 */
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 1, 1, 2, 2, 2));
    CHECK_POINTS(h, VALUES(0, 0, 1, 1, 1));
    nurbs_destroy(h);
    CHECK_OK(nurbs_extend(g, 0, NURBS_START, 2, NURBS_MAX_ORDER, &h)); /* t^2 over [-2, 1] */
    CHECK_KNOTS(h, 0, VALUES(-2, -2, -2, 1, 1, 1));
    CHECK_POINTS(h, VALUES(4, -2, 1));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_extend(g, 0, NURBS_END, 0, 1, &h), NURBS_ERROR_EMPTY_DOMAIN, "amount = 0");
    CHECK_NO_HANDLE(h, nurbs_extend(g, 0, NURBS_END, 1e-17, 1, &h), NURBS_ERROR_EMPTY_DOMAIN,
                    "amount = 1e-17");
    CHECK_NO_HANDLE(h, nurbs_extend(g, 0, NURBS_END, -1, 1, &h), NURBS_ERROR_EMPTY_DOMAIN, "amount = -1");
    CHECK_NO_HANDLE(h, nurbs_extend(g, 0, NURBS_END, NAN, 1, &h), NURBS_ERROR_PARAMETER_NOT_FINITE, "nan");
    CHECK_NO_HANDLE(h, nurbs_extend(g, 0, NURBS_END, 1, -1, &h), NURBS_ERROR_ORDER, "order = -1");
    CHECK_NO_HANDLE(h, nurbs_extend(g, 0, 2, 1, 1, &h), NURBS_ERROR_END, "end = 2");
    CHECK_NO_HANDLE(h, nurbs_extend(g, 1, NURBS_END, 1, 1, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_extend(NULL, 0, NURBS_END, 1, 1, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_extend(g, 0, NURBS_END, 1, 1, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
    g = make(loop());
    CHECK_NO_HANDLE(h, nurbs_extend(g, 0, NURBS_END, 1, 1, &h), NURBS_ERROR_PERIODIC, "axis 0");
    nurbs_destroy(g);
}

/* The weight 1 - t of a hyperbola reaches 0. */
static void weights(void) {
    static const int32_t degree = 1;
    static const double points[] = {0, 1}, falling[] = {1, 0.5};
    nurbs *g = NULL, *h = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 1, points, 0, 0, falling, 0, &g));
    CHECK_OK(nurbs_extend(g, 0, NURBS_END, 0.5, 1, &h));
    CHECK_WEIGHTS(h, VALUES(1, 0.25));
    CHECK_POINTS(h, VALUES(0, 3));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_extend(g, 0, NURBS_END, 2, 1, &h), NURBS_ERROR_WEIGHT_NEGATIVE,
                    "weights[1]|-0.5|nurbs_to_homogeneous");
    CHECK_NO_HANDLE(h, nurbs_extend(g, 0, NURBS_END, 1, 1, &h), NURBS_ERROR_WEIGHTS_VANISH,
                    "weights[1]|infinity|nurbs_to_homogeneous");
    nurbs *lifted = NULL, *longer = NULL;
    CHECK_OK(nurbs_to_homogeneous(g, &lifted));
    CHECK_OK(nurbs_extend(lifted, 0, NURBS_END, 2, 1, &longer));
    CHECK_OK(nurbs_from_homogeneous(longer, &h));
    CHECK_RECORDS(h, VALUES(0, 1, 1.5, -0.5));
    nurbs_destroy(h);
    nurbs_destroy(longer);
    nurbs_destroy(lifted);
    nurbs_destroy(g);
}

/* Weights of parabolas over [0, 1]: the polar form of 1/2, 2, 2 at (-1, 0) is 2 * 1/2 - 2. */
static void unclamped_homogeneous(void) {
    static const int32_t degree = 2;
    static const double points[] = {0, 1, 2}, rising[] = {0.5, 2, 2}, falling[] = {2, 2, 0.5},
                        even[] = {1, 2, 2};
    const uint32_t start = NURBS_FORM_CLAMPED_START, end = NURBS_FORM_CLAMPED_END;
    nurbs *g = NULL, *h = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 1, points, 0, 0, rising, 0, &g));
    CHECK_NO_HANDLE(h, nurbs_unclamp(g, 0, start, &h), NURBS_ERROR_WEIGHT_NEGATIVE,
                    "weights[0]|-1|NURBS_HOMOGENEOUS");
    CHECK_OK(nurbs_unclamp(g, 0, start | NURBS_HOMOGENEOUS, &h));
    CHECK_RECORDS(h, VALUES(-2, -1, 2, 2, 4, 2));
    nurbs_destroy(h);
    CHECK_OK(nurbs_unclamp(g, 0, NURBS_HOMOGENEOUS, &h)); /* no end: the form alone */
    CHECK_RECORDS(h, VALUES(0, 0.5, 2, 2, 4, 2));
    nurbs_destroy(h);
    nurbs_destroy(g);
    CHECK_OK(nurbs_create_bezier(1, &degree, 1, points, 0, 0, falling, 0, &g));
    CHECK_NO_HANDLE(h, nurbs_unclamp(g, 0, end, &h), NURBS_ERROR_WEIGHT_NEGATIVE,
                    "weights[2]|-1|NURBS_HOMOGENEOUS");
    CHECK_NO_HANDLE(h, nurbs_unclamp(g, 0, NURBS_HOMOGENEOUS | 4, &h), NURBS_ERROR_FLAGS,
                    "0x20000004|NURBS_HOMOGENEOUS");
    nurbs_destroy(g);
    CHECK_OK(nurbs_create_bezier(1, &degree, 1, points, 0, 0, even, 0, &g));
    CHECK_NO_HANDLE(h, nurbs_unclamp(g, 0, start, &h), NURBS_ERROR_WEIGHTS_VANISH,
                    "weights[0]|infinity|NURBS_HOMOGENEOUS");
    CHECK_OK(nurbs_unclamp(g, 0, start | NURBS_HOMOGENEOUS, &h));
    CHECK_RECORDS(h, VALUES(-2, 0, 2, 2, 4, 2));
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = parabola();
    CHECK_OK(nurbs_unclamp(g, 0, end | NURBS_HOMOGENEOUS, &h)); /* has no weights, and gets none */
    CHECK_POINTS(h, VALUES(0, 0, 2));
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void unclamped(void) {
    nurbs *g = parabola(), *h = NULL;
    CHECK_OK(nurbs_unclamp(g, 0, NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END, &h));
    CHECK_KNOTS(h, 0, VALUES(-2, -1, 0, 1, 2, 3));
    CHECK_POINTS(h, VALUES(0, 0, 2)); /* products of neighbouring knots */
    nurbs_destroy(h);
    CHECK_OK(nurbs_unclamp(g, 0, NURBS_FORM_CLAMPED_END, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 1, 2, 3));
    CHECK_POINTS(h, VALUES(0, 0, 2));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_unclamp(g, 0, 4, &h), NURBS_ERROR_FLAGS, "flags = 0x4");
    CHECK_NO_HANDLE(h, nurbs_unclamp(g, -1, 0, &h), NURBS_ERROR_AXIS, "axis = -1");
    CHECK_NO_HANDLE(h, nurbs_unclamp(NULL, 0, 0, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_unclamp(g, 0, 0, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
    g = make(loop());
    CHECK_OK(nurbs_unclamp(g, 0, 3, &h));
    CHECK_KNOTS(h, 0, loop().knots);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void periodic(void) {
    nurbs *g = make(loop()), *c = NULL, *h = NULL;
    double deviation = -1;
    int32_t order = -7, found = -1;
    CHECK_OK(nurbs_clamp_ends(g, 0, NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END, &c));
    CHECK_OK(nurbs_detect_periodic(c, 0, &found));
    CHECK_INT(found, 0);
    CHECK_OK(nurbs_make_periodic(c, 0, 1e-12, &deviation, &order, &h));
    CHECK_INT(order, 1);
    CHECK(deviation >= 0 && deviation <= 1e-13);
    CHECK_KNOTS(h, 0, loop().knots);
    CHECK_POINTS(h, loop().points);
    CHECK_OK(nurbs_detect_periodic(h, 0, &found));
    CHECK_INT(found, 1);
    nurbs_destroy(h);
    nurbs_destroy(c);
    CHECK_OK(nurbs_clamp_ends(g, 0, 0, &c)); /* opened: it repeats still */
    CHECK_OK(nurbs_detect_periodic(c, 0, &found));
    CHECK_INT(found, 1);
    CHECK_OK(nurbs_make_periodic(c, 0, 0, &deviation, &order, &h));
    CHECK_DOUBLE(deviation, 0);
    CHECK_INT(order, 1);
    nurbs_destroy(h);
    nurbs_destroy(c);
    nurbs_destroy(g);
    g = make(circle());
    CHECK_OK(nurbs_make_periodic(g, 0, 1e-9, NULL, &order, &h)); /* knots of the circle are double: C^0 */
    CHECK_INT(order, 0);
    nurbs_destroy(h);
    CHECK_OK(nurbs_make_periodic(g, 0, 0, &deviation, &order, &h)); /* its ends are the same point */
    CHECK_DOUBLE(deviation, 0);
    CHECK_INT(order, 0);
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = make(arch());
    CHECK_NO_HANDLE(h, nurbs_make_periodic(g, 0, 0.5, &deviation, &order, &h), NURBS_ERROR_GAP, "axis 0|0.5");
    CHECK_NO_HANDLE(h, nurbs_make_periodic(g, 0, -1, NULL, NULL, &h), NURBS_ERROR_TOLERANCE,
                    "tolerance = -1");
    CHECK_NO_HANDLE(h, nurbs_make_periodic(g, 1, 0, NULL, NULL, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_make_periodic(NULL, 0, 0, NULL, NULL, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_make_periodic(g, 0, 0, NULL, NULL, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_detect_periodic(g, 0, NULL), NURBS_ERROR_NULL, "periodic");
    CHECK_FAILS(nurbs_detect_periodic(g, 1, &found), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_FAILS(nurbs_detect_periodic(NULL, 0, &found), NURBS_ERROR_NULL, "g");
    nurbs_destroy(g);
}

/* Knots that leave the range of doubles, or that are one a period away. */
static void far_and_near_knots(void) {
    static const int32_t degree = 2;
    static const int64_t count = 4;
    static const double far_apart[] = {0, 0, 0, 1e308, 1.5e308, 1.5e308, 1.5e308};
    static const double near[] = {0, 0, 0, 1e-17, 1, 1, 1}, points[] = {0, 0, 1, 3};
    nurbs *g = NULL, *h = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, far_apart, 7, 1, points, 0, 0, NULL, 0, 0, &g));
    CHECK_NO_HANDLE(h, nurbs_extend(g, 0, NURBS_END, 1e308, 1, &h), NURBS_ERROR_NOT_REPRESENTABLE,
                    "axis 0|amount = 1e+308");
    CHECK_NO_HANDLE(h, nurbs_unclamp(g, 0, NURBS_FORM_CLAMPED_START, &h), NURBS_ERROR_NOT_REPRESENTABLE,
                    "knots");
    nurbs_destroy(g);
    CHECK_OK(nurbs_create(1, &degree, &count, near, 7, 1, points, 0, 0, NULL, 0, 0, &g));
    CHECK_NO_HANDLE(h, nurbs_unclamp(g, 0, NURBS_FORM_CLAMPED_END, &h), NURBS_ERROR_KNOTS_MERGE,
                    "knots 0 and 1e-17 of axis 0|1");
    nurbs_destroy(g);
}

int main(void) {
    extended();
    weights();
    unclamped();
    unclamped_homogeneous();
    periodic();
    far_and_near_knots();
    return check_summary("continuation");
}
