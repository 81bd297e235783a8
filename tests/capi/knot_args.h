/* SPDX-License-Identifier: MIT */
/* Knot vectors as arguments: what the functions on bare bases refuse, checked once for all of them. */
#ifndef NURBS_TESTS_CAPI_KNOT_ARGS_H
#define NURBS_TESTS_CAPI_KNOT_ARGS_H

#include "check.h"

#include <stdint.h>

typedef nurbs_status (*OnKnots)(int32_t degree, int64_t count, const double *knots, int64_t knot_count);

typedef struct KnotArgs {
    int32_t degree;
    int64_t count;
    const double *knots;
    int64_t knot_count;
} KnotArgs;

static inline KnotArgs good_knots(void) {
    static const double knots[] = {0, 0, 0, 1, 2, 2, 3, 3, 3};
    KnotArgs a = {2, 6, knots, 9};
    return a;
}

#define KNOTS_REFUSE(f, field, value, status, words)                                                         \
    do {                                                                                                     \
        KnotArgs a_ = good_knots();                                                                          \
        a_.field = (value);                                                                                  \
        CHECK_FAILS(f(a_.degree, a_.count, a_.knots, a_.knot_count), status, words);                         \
    } while (0)
#define KNOT_REFUSE(f, index, value, status, words)                                                          \
    KNOTS_REFUSE(f, knots, edited(good_knots().knots, 9, index, value), status, words)

static inline void bad_knot_arguments(OnKnots f) {
    static const double four_inside[] = {0, 0, 0, 1, 1, 1, 1, 2, 2, 2}, empty[] = {0, 1, 1, 2};
    static const double wide[] = {-1.7e308, -1.7e308, 1.7e308, 1.7e308};
    KNOTS_REFUSE(f, degree, -1, NURBS_ERROR_DEGREE, "degree|-1");
    KNOTS_REFUSE(f, degree, 32, NURBS_ERROR_DEGREE, "degree|32");
    KNOTS_REFUSE(f, degree, INT32_MAX, NURBS_ERROR_DEGREE, "degree|2147483647");
    KNOTS_REFUSE(f, count, 0, NURBS_ERROR_COUNT, "count|0");
    KNOTS_REFUSE(f, count, -6, NURBS_ERROR_COUNT, "count|-6");
    KNOTS_REFUSE(f, count, 2, NURBS_ERROR_TOO_FEW_POINTS, "count|2|3");
    KNOTS_REFUSE(f, count, 7, NURBS_ERROR_SIZE, "knot_count|9|10");
    KNOTS_REFUSE(f, knots, NULL, NURBS_ERROR_NULL, "knots");
    KNOTS_REFUSE(f, knot_count, 8, NURBS_ERROR_SIZE, "knot_count|8|9");
    KNOTS_REFUSE(f, knot_count, -1, NURBS_ERROR_SIZE, "knot_count|-1");
    KNOT_REFUSE(f, 4, NAN, NURBS_ERROR_KNOT_NOT_FINITE, "knots[4|nan");
    KNOT_REFUSE(f, 8, INFINITY, NURBS_ERROR_KNOT_NOT_FINITE, "knots[8|inf");
    KNOT_REFUSE(f, 4, 0.5, NURBS_ERROR_KNOTS_DECREASING, "knots[4|0.5");
    KNOT_REFUSE(f, 3, 0, NURBS_ERROR_END_MULTIPLICITY, "knots[3|knots[0|0|3");
    CHECK_FAILS(f(2, 7, four_inside, 10), NURBS_ERROR_MULTIPLICITY, "knots[6|knots[3|1|3");
    CHECK_FAILS(f(1, 2, empty, 4), NURBS_ERROR_EMPTY_DOMAIN, "1");
    CHECK_FAILS(f(1, 2, wide, 4), NURBS_ERROR_KNOT_NOT_FINITE, "knots");
}

/* A count that has no knot vector: named as a size or as an overflow. */
static inline void huge_counts(OnKnots f) {
    KnotArgs a = good_knots();
    nurbs_status status = f(a.degree, INT64_MAX, a.knots, a.knot_count);
    CHECK(status == NURBS_ERROR_OVERFLOW || status == NURBS_ERROR_SIZE);
    status = f(a.degree, INT64_MAX / 2, a.knots, a.knot_count);
    CHECK(status == NURBS_ERROR_OVERFLOW || status == NURBS_ERROR_SIZE);
    /* Totals whose difference to the degree would wrap around to the count. */
    CHECK_FAILS(f(a.degree, INT64_MAX, a.knots, INT64_MIN + a.degree), NURBS_ERROR_SIZE, "knot_count");
    CHECK_FAILS(f(a.degree, a.degree + 1, a.knots, INT64_MIN), NURBS_ERROR_SIZE, "knot_count");
    CHECK_FAILS(f(a.degree, INT64_MAX, a.knots, INT64_MAX), NURBS_ERROR_SIZE, "knot_count");
}

#endif
