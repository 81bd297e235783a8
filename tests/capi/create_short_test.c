/* SPDX-License-Identifier: MIT */
/* nurbs_create_short(): knot vectors without their first and last knot. */
#include "check.h"

#include "shapes.h"

#include <stdint.h>

static nurbs_status create_short(const SplineArgs *a, nurbs **out) {
    return nurbs_create_short(a->axes, a->degrees, a->counts, a->knots, a->knot_count, a->dim, a->points,
                              a->point_stride, a->component_stride, a->weights, a->weight_stride, a->flags,
                              out);
}

/* The shapes of shapes.h without the outer knots. */
static SplineArgs short_arch(void) {
    static const double knots[] = {0, 0, 0, 1, 1, 1};
    SplineArgs a = arch();
    a.knots = knots;
    a.knot_count = 6;
    return a;
}

static SplineArgs short_trough(void) {
    static const double knots[] = {0, 0, 1, 1, 0, 1, 2, 3};
    SplineArgs a = trough();
    a.knots = knots;
    a.knot_count = 8;
    return a;
}

static SplineArgs short_loop(void) {
    static const double knots[] = {1, 2, 3, 4, 5, 6, 7};
    SplineArgs a = loop();
    a.knots = knots;
    a.knot_count = 7;
    return a;
}

static SplineArgs short_circle(void) {
    static const double knots[] = {0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1};
    SplineArgs a = circle();
    a.knots = knots;
    a.knot_count = 10;
    return a;
}

#define REFUSE_ARGS(args, status, words)                                                                     \
    do {                                                                                                     \
        nurbs *out_;                                                                                         \
        CHECK_NO_HANDLE(out_, create_short(&(args), &out_), status, words);                                  \
    } while (0)
#define REFUSE(shape, field, value, status, words)                                                           \
    do {                                                                                                     \
        SplineArgs args_ = shape();                                                                          \
        args_.field = (value);                                                                               \
        REFUSE_ARGS(args_, status, words);                                                                   \
    } while (0)
#define INTS(...) ((const int32_t[]){__VA_ARGS__})
#define COUNTS(...) ((const int64_t[]){__VA_ARGS__})

static void same_as(SplineArgs shorter, SplineArgs full) {
    int64_t offset = 0;
    nurbs *g = NULL;
    CHECK_OK(create_short(&shorter, &g));
    CHECK_POINTS(g, full.points);
    for (int32_t k = 0; k < full.axes; ++k) {
        CHECK_KNOTS(g, k, full.knots + offset);
        offset += full.counts[k] + full.degrees[k] + 1;
    }
    nurbs_destroy(g);
}

/* An unclamped end is repeated: it influences nothing inside the domain. A periodic one follows the period.
 */
static void unclamped_ends(void) {
    static const double knots[] = {1, 2, 3, 4, 5, 6}, full[] = {1, 1, 2, 3, 4, 5, 6, 6};
    static const double params[] = {2, 2.5, 3, 4, 5};
    double points[5], expected[5];
    SplineArgs a = hill();
    nurbs *g = NULL, *h = make(hill());
    a.knots = knots;
    a.knot_count = 6;
    CHECK_OK(create_short(&a, &g));
    CHECK_KNOTS(g, 0, full);
    CHECK_OK(nurbs_eval(g, 5, params, 0, 0, points, 0, 0, 0));
    CHECK_OK(nurbs_eval(h, 5, params, 0, 0, expected, 0, 0, 0));
    CHECK_NEAR(points, expected, 5, 2 * 4 * 0x1p-52 * 4);
    nurbs_destroy(g);
    nurbs_destroy(h);
}

static void good_inputs(void) {
    same_as(short_arch(), arch());
    same_as(short_trough(), trough());
    same_as(short_loop(), loop());
    same_as(short_circle(), circle());
}

static void null_arguments(void) {
    SplineArgs a = short_arch();
    REFUSE(short_arch, degrees, NULL, NURBS_ERROR_NULL, "degrees");
    REFUSE(short_arch, counts, NULL, NURBS_ERROR_NULL, "counts");
    REFUSE(short_arch, knots, NULL, NURBS_ERROR_NULL, "knots");
    REFUSE(short_arch, points, NULL, NURBS_ERROR_NULL, "points");
    CHECK_FAILS(create_short(&a, NULL), NURBS_ERROR_NULL, "out");
}

static void bad_sizes(void) {
    REFUSE(short_arch, axes, 0, NURBS_ERROR_AXES, "axes|0");
    REFUSE(short_arch, axes, 4, NURBS_ERROR_AXES, "axes|4");
    REFUSE(short_arch, degrees, INTS(0), NURBS_ERROR_DEGREE, "degrees[0|0");
    REFUSE(short_arch, degrees, INTS(-1), NURBS_ERROR_DEGREE, "degrees[0|-1");
    REFUSE(short_arch, degrees, INTS(32), NURBS_ERROR_DEGREE, "degrees[0|32");
    REFUSE(short_trough, degrees, INTS(2, 0), NURBS_ERROR_DEGREE, "degrees[1|0");
    REFUSE(short_arch, counts, COUNTS(0), NURBS_ERROR_COUNT, "counts[0|0");
    REFUSE(short_arch, counts, COUNTS(-4), NURBS_ERROR_COUNT, "counts[0|-4");
    REFUSE(short_arch, counts, COUNTS(3), NURBS_ERROR_TOO_FEW_POINTS, "counts[0|3|4");
    REFUSE(short_arch, counts, COUNTS(INT64_MAX), NURBS_ERROR_OVERFLOW, "");
    REFUSE(short_arch, counts, COUNTS(INT64_MAX / 2), NURBS_ERROR_OVERFLOW, "");
    REFUSE(short_arch, knot_count, 8, NURBS_ERROR_SIZE, "knot_count|8|6");
    REFUSE(short_arch, knot_count, 5, NURBS_ERROR_SIZE, "knot_count|5|6");
    REFUSE(short_arch, knot_count, -6, NURBS_ERROR_SIZE, "knot_count|-6");
    REFUSE(short_arch, dim, 0, NURBS_ERROR_DIMENSION, "dim|0");
    REFUSE(short_arch, point_stride, -2, NURBS_ERROR_STRIDE, "point|-2");
    REFUSE(short_arch, point_stride, 1, NURBS_ERROR_STRIDE, "point|1");
    REFUSE(short_arch, component_stride, -1, NURBS_ERROR_STRIDE, "point|-1");
    REFUSE(short_circle, weight_stride, -1, NURBS_ERROR_STRIDE, "weight|-1");
    REFUSE(short_arch, flags, 0x04u, NURBS_ERROR_FLAGS, "flags");
    REFUSE(short_arch, flags, NURBS_ON_AXIS(1, NURBS_PERIODIC), NURBS_ERROR_FLAGS, "flags");
}

#define BAD_KNOT(shape, count, index, value, status, words)                                                  \
    REFUSE(shape, knots, edited(shape().knots, count, index, value), status, words)

/* Messages count along the array that was given, not along the completed one. */
static void bad_values(void) {
    static const double six[] = {0, 0, 0, 1, 1, 1, 1, 1, 1};
    static const double many[18] = {0};
    SplineArgs a = short_arch();
    BAD_KNOT(short_arch, 6, 4, NAN, NURBS_ERROR_KNOT_NOT_FINITE, "knots[4|nan");
    BAD_KNOT(short_arch, 6, 0, -INFINITY, NURBS_ERROR_KNOT_NOT_FINITE, "knots[0|inf");
    BAD_KNOT(short_arch, 6, 2, -0.5, NURBS_ERROR_KNOTS_DECREASING, "knots[2|-0.5");
    BAD_KNOT(short_trough, 8, 6, 0.25, NURBS_ERROR_KNOTS_DECREASING, "knots[6|0.25");
    a.counts = COUNTS(7);
    a.knots = six;
    a.knot_count = 9;
    a.points = many;
    REFUSE_ARGS(a, NURBS_ERROR_END_MULTIPLICITY, "1");
    REFUSE(short_arch, knots, edited(short_arch().knots, 6, 3, 0), NURBS_ERROR_EMPTY_DOMAIN, "0");
    REFUSE(short_arch, points, edited(arch().points, 8, 7, NAN), NURBS_ERROR_POINT_NOT_FINITE,
           "points[3|nan");
    REFUSE(short_circle, weights, edited(circle().weights, 9, 2, NAN), NURBS_ERROR_WEIGHT_NOT_FINITE,
           "weights[2|nan");
    REFUSE(short_circle, weights, edited(circle().weights, 9, 2, -1), NURBS_ERROR_WEIGHT_NEGATIVE,
           "weights[2|-1");
    REFUSE(short_circle, weights, edited(circle().weights, 9, 2, 0), NURBS_ERROR_WEIGHTS_VANISH,
           "weights|(0.25)");
    REFUSE(short_loop, knots, edited(short_loop().knots, 7, 2, 3.25), NURBS_ERROR_PERIODIC_KNOTS, "knots");
    REFUSE(short_loop, points, edited(loop().points, 12, 8, 1.5), NURBS_ERROR_PERIODIC_POINTS, "points|1.5");
}

int main(void) {
    good_inputs();
    unclamped_ends();
    null_arguments();
    bad_sizes();
    bad_values();
    return check_summary("create_short");
}
