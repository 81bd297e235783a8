/* SPDX-License-Identifier: MIT */
/* nurbs_create_multiplicities(): distinct knots with how often each occurs. */
#include "check.h"

#include "shapes.h"

#include <stdint.h>

typedef struct Args {
    SplineArgs s; /* knots and knot_count are not used */
    const int64_t *distinct_counts;
    const double *distinct_knots;
    const int32_t *multiplicities;
} Args;

static nurbs_status create_multiplicities(const Args *a, nurbs **out) {
    return nurbs_create_multiplicities(a->s.axes, a->s.degrees, a->s.counts, a->distinct_counts,
                                       a->distinct_knots, a->multiplicities, a->s.dim, a->s.points,
                                       a->s.point_stride, a->s.component_stride, a->s.weights,
                                       a->s.weight_stride, a->s.flags, out);
}

static Args distinct_circle(void) {
    static const int64_t counts[] = {5};
    static const double knots[] = {0, 0.25, 0.5, 0.75, 1};
    static const int32_t multiplicities[] = {3, 2, 2, 2, 3};
    Args a = {circle(), counts, knots, multiplicities};
    return a;
}

static Args distinct_trough(void) {
    static const int64_t counts[] = {2, 4};
    static const double knots[] = {0, 1, 0, 1, 2, 3};
    static const int32_t multiplicities[] = {3, 3, 2, 1, 1, 2};
    Args a = {trough(), counts, knots, multiplicities};
    return a;
}

static Args distinct_loop(void) {
    static const int64_t counts[] = {9};
    static const int32_t multiplicities[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
    Args a = {loop(), counts, loop().knots, multiplicities};
    return a;
}

static Args distinct_jump(void) {
    static const int64_t counts[] = {3};
    static const double knots[] = {0, 1, 2};
    static const int32_t multiplicities[] = {2, 2, 2};
    Args a = {jump(), counts, knots, multiplicities};
    return a;
}

#define REFUSE(shape, field, value, status, words)                                                           \
    do {                                                                                                     \
        Args args_ = shape();                                                                                \
        nurbs *out_;                                                                                         \
        args_.field = (value);                                                                               \
        CHECK_NO_HANDLE(out_, create_multiplicities(&args_, &out_), status, words);                          \
    } while (0)
#define INTS(...) ((const int32_t[]){__VA_ARGS__})
#define COUNTS(...) ((const int64_t[]){__VA_ARGS__})

static void stores(Args a) {
    int64_t offset = 0;
    nurbs *g = NULL;
    CHECK_OK(create_multiplicities(&a, &g));
    CHECK_POINTS(g, a.s.points);
    if (a.s.weights != NULL) {
        CHECK_WEIGHTS(g, a.s.weights);
    }
    for (int32_t k = 0; k < a.s.axes; ++k) {
        CHECK_KNOTS(g, k, a.s.knots + offset);
        offset += a.s.counts[k] + a.s.degrees[k] + 1;
    }
    nurbs_destroy(g);
}

static void null_arguments(void) {
    Args a = distinct_circle();
    REFUSE(distinct_circle, s.degrees, NULL, NURBS_ERROR_NULL, "degrees");
    REFUSE(distinct_circle, s.counts, NULL, NURBS_ERROR_NULL, "counts");
    REFUSE(distinct_circle, distinct_counts, NULL, NURBS_ERROR_NULL, "distinct_counts");
    REFUSE(distinct_circle, distinct_knots, NULL, NURBS_ERROR_NULL, "distinct_knots");
    REFUSE(distinct_circle, multiplicities, NULL, NURBS_ERROR_NULL, "multiplicities");
    REFUSE(distinct_circle, s.points, NULL, NURBS_ERROR_NULL, "points");
    CHECK_FAILS(create_multiplicities(&a, NULL), NURBS_ERROR_NULL, "out");
}

static void bad_sizes(void) {
    REFUSE(distinct_circle, s.axes, 0, NURBS_ERROR_AXES, "axes|0");
    REFUSE(distinct_circle, s.axes, 4, NURBS_ERROR_AXES, "axes|4");
    REFUSE(distinct_circle, s.degrees, INTS(-1), NURBS_ERROR_DEGREE, "degrees[0|-1");
    REFUSE(distinct_circle, s.degrees, INTS(32), NURBS_ERROR_DEGREE, "degrees[0|32");
    REFUSE(distinct_circle, s.counts, COUNTS(0), NURBS_ERROR_COUNT, "counts[0|0");
    REFUSE(distinct_circle, s.counts, COUNTS(-9), NURBS_ERROR_COUNT, "counts[0|-9");
    REFUSE(distinct_circle, s.counts, COUNTS(2), NURBS_ERROR_TOO_FEW_POINTS, "counts[0|2|3");
    REFUSE(distinct_circle, s.counts, COUNTS(INT64_MAX), NURBS_ERROR_OVERFLOW, "");
    REFUSE(distinct_circle, s.counts, COUNTS(8), NURBS_ERROR_SIZE, "multiplicities|12|11");
    REFUSE(distinct_circle, distinct_counts, COUNTS(0), NURBS_ERROR_COUNT, "distinct_counts[0|0");
    REFUSE(distinct_circle, distinct_counts, COUNTS(-1), NURBS_ERROR_COUNT, "distinct_counts[0|-1");
    REFUSE(distinct_circle, distinct_counts, COUNTS(4), NURBS_ERROR_SIZE, "multiplicities|9|12");
    REFUSE(distinct_trough, distinct_counts, COUNTS(2, -1), NURBS_ERROR_COUNT, "distinct_counts[1|-1");
    REFUSE(distinct_circle, s.dim, 0, NURBS_ERROR_DIMENSION, "dim|0");
    REFUSE(distinct_circle, s.point_stride, -1, NURBS_ERROR_STRIDE, "point|-1");
    REFUSE(distinct_circle, s.point_stride, 1, NURBS_ERROR_STRIDE, "point|1");
    REFUSE(distinct_circle, s.component_stride, -1, NURBS_ERROR_STRIDE, "point|-1");
    REFUSE(distinct_circle, s.weight_stride, -1, NURBS_ERROR_STRIDE, "weight|-1");
    REFUSE(distinct_circle, s.flags, 0x08u, NURBS_ERROR_FLAGS, "flags");
    REFUSE(distinct_circle, s.flags, NURBS_ON_AXIS(1, NURBS_PERIODIC), NURBS_ERROR_FLAGS, "flags");
}

/* No more distinct knots than knots in all are ever read. */
static void huge_distinct_counts(void) {
    nurbs *out;
    Args a = distinct_circle();
    a.distinct_counts = COUNTS(INT64_MAX);
    out = check_poison();
    check_forget();
    nurbs_status status = create_multiplicities(&a, &out);
    CHECK(status == NURBS_ERROR_OVERFLOW || status == NURBS_ERROR_SIZE);
    CHECK(out == NULL);
}

static void bad_multiplicities(void) {
    REFUSE(distinct_circle, multiplicities, INTS(3, 2, 0, 4, 3), NURBS_ERROR_COUNT, "multiplicities[2|0");
    REFUSE(distinct_circle, multiplicities, INTS(3, 2, -2, 6, 3), NURBS_ERROR_COUNT, "multiplicities[2|-2");
    REFUSE(distinct_trough, multiplicities, INTS(3, 3, 2, 2, 0, 2), NURBS_ERROR_COUNT, "multiplicities[4|0");
    REFUSE(distinct_circle, multiplicities, INTS(3, 2, 2, 2, 2), NURBS_ERROR_SIZE, "multiplicities|11|12");
    REFUSE(distinct_circle, multiplicities, INTS(3, INT32_MAX, INT32_MAX, 2, 3), NURBS_ERROR_MULTIPLICITY,
           "multiplicities[1|2147483647|3");
    REFUSE(distinct_circle, multiplicities, INTS(4, 2, 2, 2, 2), NURBS_ERROR_END_MULTIPLICITY, "4|3");
    REFUSE(distinct_circle, multiplicities, INTS(2, 2, 2, 2, 4), NURBS_ERROR_END_MULTIPLICITY, "4|3");
    REFUSE(distinct_circle, multiplicities, INTS(3, 1, 1, 4, 3), NURBS_ERROR_MULTIPLICITY,
           "multiplicities[3|4|3");
}

#define BAD_KNOT(shape, count, index, value, status, words)                                                  \
    REFUSE(shape, distinct_knots, edited(shape().distinct_knots, count, index, value), status, words)

/* Messages count along the array that was given, not along the expanded vector. */
static void bad_values(void) {
    BAD_KNOT(distinct_circle, 5, 3, NAN, NURBS_ERROR_KNOT_NOT_FINITE, "knots[3|nan");
    BAD_KNOT(distinct_circle, 5, 0, -INFINITY, NURBS_ERROR_KNOT_NOT_FINITE, "knots[0|inf");
    BAD_KNOT(distinct_circle, 5, 2, 0.125, NURBS_ERROR_KNOTS_DECREASING, "knots[2|0.125");
    BAD_KNOT(distinct_circle, 5, 2, 0.25, NURBS_ERROR_KNOTS_DECREASING, "knots[2|0.25");
    BAD_KNOT(distinct_trough, 6, 4, 1, NURBS_ERROR_KNOTS_DECREASING, "knots[4|1");
    REFUSE(distinct_circle, s.points, edited(circle().points, 18, 3, NAN), NURBS_ERROR_POINT_NOT_FINITE,
           "points[1|nan");
    REFUSE(distinct_circle, s.weights, edited(circle().weights, 9, 8, NAN), NURBS_ERROR_WEIGHT_NOT_FINITE,
           "weights[8|nan");
    REFUSE(distinct_circle, s.weights, edited(circle().weights, 9, 8, -2), NURBS_ERROR_WEIGHT_NEGATIVE,
           "weights[8|-2");
    REFUSE(distinct_circle, s.weights, edited(circle().weights, 9, 8, 0), NURBS_ERROR_WEIGHTS_VANISH,
           "weights|(1)");
    BAD_KNOT(distinct_loop, 9, 3, 3.25, NURBS_ERROR_PERIODIC_KNOTS, "knots");
    REFUSE(distinct_loop, s.points, edited(loop().points, 12, 11, 0.5), NURBS_ERROR_PERIODIC_POINTS,
           "points|0.5");
}

int main(void) {
    stores(distinct_circle());
    stores(distinct_trough());
    stores(distinct_loop());
    stores(distinct_jump());
    null_arguments();
    bad_sizes();
    huge_distinct_counts();
    bad_multiplicities();
    bad_values();
    return check_summary("create_multiplicities");
}
