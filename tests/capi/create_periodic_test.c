/* SPDX-License-Identifier: MIT */
/* Periodic axes from what they do not repeat, and that back; short knot vectors back. */
#include "shapes.h"

#include <math.h>

static nurbs_status create_periodic(const SplineArgs *a, nurbs **out) {
    return nurbs_create_periodic(a->axes, a->degrees, a->counts, a->knots, a->knot_count, a->dim, a->points,
                                 a->point_stride, a->component_stride, a->weights, a->weight_stride, a->flags,
                                 out);
}

/* The loop of shapes.h without what it repeats. */
static SplineArgs open_loop(void) {
    static const int64_t counts[] = {4};
    static const double knots[] = {2, 3, 4, 5, 6};
    SplineArgs a = loop();
    a.counts = counts;
    a.knots = knots;
    a.knot_count = 5;
    return a;
}

/* A rational tube of degrees 2 and 1, periodic around, and clamped along. */
static SplineArgs tube(void) {
    static const int32_t degrees[] = {2, 1};
    static const int64_t counts[] = {3, 2};
    static const double knots[] = {0, 1, 1.5, 4, 0, 0, 1, 1};
    static const double points[] = {1, 0, 0, 1, 0, 5, 0, 1, 0, 0, 1, 5, -1, 0, 0, -1, 0, 5};
    static const double weights[] = {1, 2, 3, 4, 5, 6};
    SplineArgs a = {2, degrees, counts, knots, 8, 3, points, 0, 0, weights, 0, NURBS_PERIODIC};
    return a;
}

#define REFUSE_ARGS(args, status, words)                                                                     \
    do {                                                                                                     \
        nurbs *out_;                                                                                         \
        CHECK_NO_HANDLE(out_, create_periodic(&(args), &out_), status, words);                               \
    } while (0)
#define REFUSE(shape, field, value, status, words)                                                           \
    do {                                                                                                     \
        SplineArgs args_ = shape();                                                                          \
        args_.field = (value);                                                                               \
        REFUSE_ARGS(args_, status, words);                                                                   \
    } while (0)
#define INTS(...) ((const int32_t[]){__VA_ARGS__})
#define COUNTS(...) ((const int64_t[]){__VA_ARGS__})
#define VALUES(...) ((const double[]){__VA_ARGS__})

static nurbs *made(SplineArgs a) {
    nurbs *g = NULL;
    CHECK_OK(create_periodic(&a, &g));
    return g;
}

static void full_form(void) {
    nurbs *g = made(open_loop());
    int32_t form = 0;
    CHECK_KNOTS(g, 0, loop().knots);
    CHECK_POINTS(g, loop().points);
    CHECK_OK(nurbs_knot_form(g, 0, &form));
    CHECK_INT(form, NURBS_FORM_PERIODIC);
    nurbs_destroy(g);
}

/* Rows 0 and 1 are repeated behind row 2; the other axis is as it was given. */
static void one_axis_of_two(void) {
    static const double around[] = {-3, -2.5, 0, 1, 1.5, 4, 5, 5.5};
    static const double points[] = {1,  0, 0, 1, 0, 5, 0, 1, 0, 0, 1, 5, -1, 0, 0,
                                    -1, 0, 5, 1, 0, 0, 1, 0, 5, 0, 1, 0, 0,  1, 5};
    static const double weights[] = {1, 2, 3, 4, 5, 6, 1, 2, 3, 4};
    nurbs *g = made(tube());
    CHECK_KNOTS(g, 0, around);
    CHECK_KNOTS(g, 1, tube().knots + 4);
    CHECK_POINTS(g, points);
    CHECK_WEIGHTS(g, weights);
    nurbs_destroy(g);
}

/* Without a periodic axis it is nurbs_create(). */
static void no_periodic_axis(void) {
    nurbs *g = made(trough()), *h = made(circle());
    CHECK_KNOTS(g, 1, trough().knots + 6);
    CHECK_POINTS(g, trough().points);
    CHECK_WEIGHTS(h, circle().weights);
    nurbs_destroy(g);
    nurbs_destroy(h);
}

/* One point is a constant of any degree; two points repeat twice and a half in degree 5. */
static void fewer_points_than_degrees(void) {
    static const double constant[] = {7, 7, 7, 7}, knots[] = {-3, -2, -1, 0, 1, 2, 3, 4};
    static const double turns[] = {1, 2, 1, 2, 1, 2, 1};
    static const double two[] = {-5, -4.5, -3, -2.5, -1, -0.5, 1, 1.5, 3, 3.5, 5, 5.5, 7};
    SplineArgs a = open_loop();
    a.degrees = INTS(3);
    a.counts = COUNTS(1);
    a.knots = VALUES(0, 1);
    a.knot_count = 2;
    a.dim = 1;
    a.points = VALUES(7);
    nurbs *g = made(a);
    CHECK_KNOTS(g, 0, knots);
    CHECK_POINTS(g, constant);
    nurbs_destroy(g);
    a.degrees = INTS(5);
    a.counts = COUNTS(2);
    a.knots = VALUES(-0.5, 1, 1.5);
    a.knot_count = 3;
    a.points = VALUES(1, 2);
    g = made(a);
    CHECK_KNOTS(g, 0, two);
    CHECK_POINTS(g, turns);
    nurbs_destroy(g);
}

/* Strides skip what lies between points and weights. */
static void strides(void) {
    static const double spaced[] = {1, 9, 1, 9, -1, 9, 1, 9, -1, 9, -1, 9, 1, 9, -1, 9};
    static const double weights[] = {1, 8, 2, 8, 3, 8, 4, 8}, all[] = {1, 2, 3, 4, 1, 2};
    SplineArgs a = open_loop();
    a.points = spaced;
    a.point_stride = 4;
    a.component_stride = 2;
    a.weights = weights;
    a.weight_stride = 2;
    nurbs *g = made(a);
    CHECK_POINTS(g, loop().points);
    CHECK_WEIGHTS(g, all);
    nurbs_destroy(g);
}

/* A seam knot of full multiplicity, however its copies are shared between start and end: the same period. */
static void seams(void) {
    static const double first[] = {-1, 0, 0, 0, 1, 1, 1, 2}, last[] = {-1, -1, -1, 0, 0, 0, 1, 1};
    SplineArgs a = open_loop();
    a.counts = COUNTS(3);
    a.knot_count = 4;
    a.knots = VALUES(0, 0, 1, 1);
    a.dim = 1;
    a.points = VALUES(1, 2, 3);
    nurbs *g = made(a);
    CHECK_KNOTS(g, 0, first);
    nurbs_destroy(g);
    a.knots = VALUES(-1, 0, 0, 0);
    g = made(a);
    CHECK_KNOTS(g, 0, last);
    nurbs_destroy(g);
}

static void null_arguments(void) {
    SplineArgs a = open_loop();
    REFUSE(open_loop, degrees, NULL, NURBS_ERROR_NULL, "degrees");
    REFUSE(open_loop, counts, NULL, NURBS_ERROR_NULL, "counts");
    REFUSE(open_loop, knots, NULL, NURBS_ERROR_NULL, "knots");
    REFUSE(open_loop, points, NULL, NURBS_ERROR_NULL, "points");
    CHECK_FAILS(create_periodic(&a, NULL), NURBS_ERROR_NULL, "out");
}

static void bad_sizes(void) {
    REFUSE(open_loop, axes, 0, NURBS_ERROR_AXES, "axes|0");
    REFUSE(open_loop, axes, 4, NURBS_ERROR_AXES, "axes|4");
    REFUSE(open_loop, degrees, INTS(-1), NURBS_ERROR_DEGREE, "degrees[0|-1");
    REFUSE(open_loop, degrees, INTS(32), NURBS_ERROR_DEGREE, "degrees[0|32");
    REFUSE(tube, degrees, INTS(2, 32), NURBS_ERROR_DEGREE, "degrees[1|32");
    REFUSE(open_loop, counts, COUNTS(0), NURBS_ERROR_COUNT, "counts[0|0");
    REFUSE(open_loop, counts, COUNTS(-4), NURBS_ERROR_COUNT, "counts[0|-4");
    REFUSE(tube, counts, COUNTS(3, 1), NURBS_ERROR_TOO_FEW_POINTS, "counts[1|1");
    REFUSE(open_loop, counts, COUNTS(INT64_MAX), NURBS_ERROR_OVERFLOW, "");
    REFUSE(open_loop, counts, COUNTS(INT64_MAX / 16), NURBS_ERROR_OVERFLOW, "");
    REFUSE(tube, counts, COUNTS(INT64_C(1) << 40, INT64_C(1) << 40), NURBS_ERROR_OVERFLOW, "points");
    REFUSE(open_loop, knot_count, 9, NURBS_ERROR_SIZE, "knot_count|9|5");
    REFUSE(open_loop, knot_count, -5, NURBS_ERROR_SIZE, "knot_count|-5");
    REFUSE(tube, knot_count, 7, NURBS_ERROR_SIZE, "knot_count|7|8");
    REFUSE(open_loop, dim, 0, NURBS_ERROR_DIMENSION, "dim|0");
    REFUSE(open_loop, dim, INT32_MAX, NURBS_ERROR_DIMENSION, "dim|2147483647");
    REFUSE(open_loop, point_stride, -2, NURBS_ERROR_STRIDE, "point|-2");
    REFUSE(open_loop, point_stride, 1, NURBS_ERROR_STRIDE, "point|1");
    REFUSE(open_loop, component_stride, -1, NURBS_ERROR_STRIDE, "point|-1");
    REFUSE(tube, weight_stride, -1, NURBS_ERROR_STRIDE, "weight|-1");
    REFUSE(open_loop, flags, 0x04u, NURBS_ERROR_FLAGS, "flags");
    REFUSE(open_loop, flags, NURBS_ON_AXIS(1, NURBS_PERIODIC), NURBS_ERROR_FLAGS, "flags");
}

#define BAD_KNOT(shape, index, value, status, words)                                                         \
    REFUSE(shape, knots, edited(shape().knots, shape().knot_count, index, value), status, words)
#define BAD_POINT(shape, count, index, value, status, words)                                                 \
    REFUSE(shape, points, edited(shape().points, count, index, value), status, words)
#define BAD_WEIGHT(index, value, status, words)                                                              \
    REFUSE(tube, weights, edited(tube().weights, 6, index, value), status, words)

/* Messages count along the arrays that were given, not along the wrapped ones. */
static void bad_values(void) {
    BAD_KNOT(open_loop, 4, NAN, NURBS_ERROR_KNOT_NOT_FINITE, "knots[4|nan");
    BAD_KNOT(open_loop, 0, -INFINITY, NURBS_ERROR_KNOT_NOT_FINITE, "knots[0|inf");
    BAD_KNOT(open_loop, 2, 2.5, NURBS_ERROR_KNOTS_DECREASING, "knots[2|2.5|knots[1");
    BAD_KNOT(tube, 6, -1, NURBS_ERROR_KNOTS_DECREASING, "knots[6|-1|axis 1");
    REFUSE(open_loop, knots, VALUES(3, 3, 3, 3, 3), NURBS_ERROR_EMPTY_DOMAIN, "knots[0]|knots[4]|axis 0");
    REFUSE(open_loop, knots, VALUES(2, 3, 3, 3, 3), NURBS_ERROR_MULTIPLICITY, "knots[4]|knots[1]|degree 2");
    BAD_POINT(open_loop, 8, 7, NAN, NURBS_ERROR_POINT_NOT_FINITE, "points[3][1]|nan");
    BAD_POINT(tube, 18, 15, INFINITY, NURBS_ERROR_POINT_NOT_FINITE, "points[5][0]|inf");
    BAD_WEIGHT(5, NAN, NURBS_ERROR_WEIGHT_NOT_FINITE, "weights[5|nan");
    BAD_WEIGHT(4, -1, NURBS_ERROR_WEIGHT_NEGATIVE, "weights[4|-1");
    REFUSE(tube, weights, VALUES(0, 1, 0, 1, 0, 1), NURBS_ERROR_WEIGHTS_VANISH, "weights|(0, 0)");
    SplineArgs a = tube();
    a.points = edited(tube().points, 18, 12, 1e300);
    a.weights = VALUES(1, 1, 1, 1, 1e300, 1);
    REFUSE_ARGS(a, NURBS_ERROR_NOT_REPRESENTABLE, "weights[4] * points[4][0]");
    REFUSE(open_loop, knots, VALUES(-8e307, -7e307, 0, 1, 8e307), NURBS_ERROR_NOT_REPRESENTABLE, "knots");
}

/* So many copies of one knot at the seam would be too many. */
static void knots_of_the_seam(void) {
    REFUSE(open_loop, knots, VALUES(2, 2, 2, 6, 6), NURBS_ERROR_MULTIPLICITY,
           "knots[0]|knots[4]|4 times|3 equal");
    /* distinct at the start, equal a period later, where doubles are wider apart */
    REFUSE(open_loop, knots, VALUES(0, 1e-20, 2e-20, 1, 1), NURBS_ERROR_NOT_REPRESENTABLE, "near 1");
}

static void given_back(void) {
    static const double points[] = {1, 0, 0, 1, 0, 5, 0, 1, 0, 0, 1, 5, -1, 0, 0, -1, 0, 5};
    nurbs *g = made(tube());
    int64_t count = -1;
    double values[24], weights[8];
    CHECK_OK(nurbs_unwrapped_count(g, 0, &count));
    CHECK_INT(count, 3);
    CHECK_OK(nurbs_unwrapped_count(g, 1, &count));
    CHECK_INT(count, 2);
    CHECK_OK(nurbs_unwrapped_knots(g, 0, 24, values, &count));
    CHECK_INT(count, 4);
    CHECK_BITS(values, tube().knots, 4 * sizeof *values);
    CHECK_OK(nurbs_unwrapped_knots(g, 1, 4, values, NULL));
    CHECK_BITS(values, tube().knots + 4, 4 * sizeof *values);
    FILL(values);
    FILL(weights);
    CHECK_OK(nurbs_unwrapped_points(g, 6, values, weights, &count));
    CHECK_INT(count, 6);
    CHECK_BITS(values, points, sizeof points);
    CHECK_BITS(weights, tube().weights, 6 * sizeof *weights);
    check_untouched(__FILE__, __LINE__, (unsigned char *)(values + 18), 6 * sizeof *values);
    check_untouched(__FILE__, __LINE__, (unsigned char *)(weights + 6), 2 * sizeof *weights);
    CHECK_OK(nurbs_unwrapped_points(g, 0, NULL, NULL, &count));
    CHECK_OK(nurbs_unwrapped_points(g, 6, NULL, NULL, NULL));
    CHECK_OK(nurbs_unwrapped_points(g, 6, NULL, weights, NULL));
    CHECK_OK(nurbs_short_knots(g, 0, 6, values, &count));
    CHECK_INT(count, 6);
    CHECK_BITS(values, VALUES(-2.5, 0, 1, 1.5, 4, 5), 6 * sizeof *values);
    nurbs_destroy(g);
}

static void refused_getters(void) {
    nurbs *g = made(tube()), *flat = make(stairs());
    int64_t count = -7;
    double values[32];
    FILL(values);
    CHECK_FAILS(nurbs_unwrapped_count(NULL, 0, &count), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_unwrapped_count(g, 2, &count), NURBS_ERROR_AXIS, "axis = 2");
    CHECK_FAILS(nurbs_unwrapped_count(g, 0, NULL), NURBS_ERROR_NULL, "count");
    CHECK_FAILS(nurbs_unwrapped_knots(NULL, 0, 32, values, &count), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_unwrapped_knots(g, -1, 32, values, &count), NURBS_ERROR_AXIS, "axis = -1");
    CHECK_FAILS(nurbs_unwrapped_knots(g, 0, -1, values, &count), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_unwrapped_knots(g, 0, 3, values, &count), NURBS_ERROR_SIZE, "cap = 3|4");
    CHECK_FAILS(nurbs_unwrapped_knots(g, 0, 32, values, (int64_t *)(void *)values), NURBS_ERROR_OVERLAP,
                "count");
    CHECK_FAILS(nurbs_unwrapped_points(NULL, 32, values, NULL, &count), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_unwrapped_points(g, -1, values, NULL, &count), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_unwrapped_points(g, 5, values, NULL, &count), NURBS_ERROR_SIZE, "cap = 5|6");
    CHECK_FAILS(nurbs_unwrapped_points(g, 6, values, values + 17, &count), NURBS_ERROR_OVERLAP, "weights");
    CHECK_FAILS(nurbs_short_knots(NULL, 0, 32, values, &count), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_short_knots(g, 2, 32, values, &count), NURBS_ERROR_AXIS, "axis = 2");
    CHECK_FAILS(nurbs_short_knots(g, 0, 5, values, &count), NURBS_ERROR_SIZE, "cap = 5|6");
    CHECK_FAILS(nurbs_short_knots(g, 0, -1, values, &count), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_short_knots(flat, 0, 32, values, &count), NURBS_ERROR_DEGREE, "axis 0|degree 0");
    CHECK_INT(count, -7);
    CHECK_UNTOUCHED(values);
    nurbs_destroy(g);
    nurbs_destroy(flat);
}

int main(void) {
    full_form();
    one_axis_of_two();
    no_periodic_axis();
    fewer_points_than_degrees();
    strides();
    seams();
    null_arguments();
    bad_sizes();
    bad_values();
    knots_of_the_seam();
    given_back();
    refused_getters();
    return check_summary("create_periodic");
}
