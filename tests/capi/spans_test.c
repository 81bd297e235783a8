/* SPDX-License-Identifier: MIT */
/* nurbs_find_spans(). */
#include "batch.h"
#include "check.h"
#include "knot_args.h"

static const double clamped[] = {0, 0, 0, 1, 2, 2, 3, 3, 3}; /* degree 2, count 6 */
static const double unclamped[] = {0, 1, 2, 3, 4, 5, 6, 7};  /* degree 2, count 5, domain [2, 5] */
static const double inside_jump[] = {0, 0, 1, 1, 2, 2};      /* degree 1, count 4 */
static const double steps[] = {0, 1, 2, 3};                  /* degree 0, count 3 */
static const double unit[] = {0, 0, 1, 1};                   /* degree 1, count 2 */

static void found(int32_t degree, int64_t count, const double *knots, int64_t n, const double *params,
                  uint32_t flags, const int64_t *expected) {
    int64_t spans[10];
    FILL(spans);
    CHECK_OK(nurbs_find_spans(degree, count, knots, count + degree + 1, n, params, 0, spans, flags));
    for (int64_t i = 0; i < n; ++i) {
        CHECK_INT(spans[i], expected[i]);
    }
    check_untouched(__FILE__, __LINE__, spans + n, sizeof spans - (size_t)n * sizeof *spans);
}

#define SPANS(...) ((const int64_t[]){__VA_ARGS__})

static void both_sides(void) {
    static const double at[] = {0, 0.5, 1, 1.5, 2, 2.5, 3}, inner[] = {2, 2.5, 3, 4, 5};
    found(2, 6, clamped, 7, at, 0, SPANS(2, 2, 3, 3, 5, 5, 5));
    found(2, 6, clamped, 7, at, NURBS_LEFT, SPANS(2, 2, 2, 3, 3, 5, 5));
    found(2, 5, unclamped, 5, inner, 0, SPANS(2, 2, 3, 4, 4));
    found(2, 5, unclamped, 5, inner, NURBS_LEFT, SPANS(2, 2, 2, 3, 4));
    found(1, 4, inside_jump, 5, at, 0, SPANS(1, 1, 3, 3, 3));
    found(1, 4, inside_jump, 5, at, NURBS_LEFT, SPANS(1, 1, 1, 3, 3));
    found(0, 3, steps, 7, at, 0, SPANS(0, 0, 1, 1, 2, 2, 2));
    found(0, 3, steps, 7, at, NURBS_LEFT, SPANS(0, 0, 0, 1, 1, 2, 2));
}

/* Below, above, at infinity and not a number. The period of `unclamped` is 3: 1.5 is 4.5, 5 is 2, 9.25
 * is 3.25. */
static void outside(void) {
    static const double at[] = {1.5, 5, 9.25, 2}, infinite[] = {-INFINITY, INFINITY, 3},
                        mixed[] = {NAN, 1, 6, 4};
    found(2, 5, unclamped, 4, at, NURBS_CLAMP, SPANS(2, 4, 4, 2));
    found(2, 5, unclamped, 3, infinite, NURBS_CLAMP, SPANS(2, 4, 3));
    found(2, 5, unclamped, 4, at, NURBS_EXTRAPOLATE, SPANS(2, 4, 4, 2));
    found(2, 5, unclamped, 4, at, NURBS_WRAP, SPANS(4, 2, 3, 2));
    found(2, 5, unclamped, 4, at, NURBS_WRAP | NURBS_LEFT, SPANS(4, 4, 3, 4));
    found(2, 5, unclamped, 4, mixed, NURBS_NAN, SPANS(-1, -1, -1, 4));
    found(2, 5, unclamped, 4, mixed, NURBS_NAN | NURBS_CLAMP, SPANS(-1, 2, 4, 4));
    found(2, 5, unclamped, 4, mixed, NURBS_NAN | NURBS_EXTRAPOLATE, SPANS(-1, 2, 4, 4));
    found(2, 5, unclamped, 4, mixed, NURBS_NAN | NURBS_WRAP, SPANS(-1, 4, 3, 4));
    found(2, 5, unclamped, 3, infinite, NURBS_NAN | NURBS_WRAP, SPANS(-1, -1, 3));
}

static void every_span_of_a_long_vector(void) {
    double knots[1004], params[1000];
    int64_t spans[1000];
    for (int i = 0; i < 1004; ++i) {
        knots[i] = (double)i * i;
    }
    for (int i = 3; i < 1000; ++i) {
        params[i - 3] = knots[i];
    }
    CHECK_OK(nurbs_find_spans(3, 1000, knots, 1004, 997, params, 0, spans, 0));
    for (int i = 0; i < 997; ++i) {
        CHECK_INT(spans[i], i + 3);
    }
    CHECK_OK(nurbs_find_spans(3, 1000, knots, 1004, 997, params, 0, spans, NURBS_LEFT));
    for (int i = 1; i < 997; ++i) {
        CHECK_INT(spans[i], i + 2);
    }
}

/* Spans are as wide as doubles, so that the common checks can watch the array as one. */
static nurbs_status as_batch(const nurbs *g, int64_t n, const double *params, int64_t stride, int64_t unused,
                             double *out, int64_t out_stride, int64_t out_unused, uint32_t flags) {
    (void)g, (void)unused, (void)out_stride, (void)out_unused;
    return nurbs_find_spans(1, 2, unit, 4, n, params, stride, (int64_t *)(void *)out, flags);
}

static nurbs_status on_knots(int32_t degree, int64_t count, const double *knots, int64_t knot_count) {
    static const double param = 0.5;
    int64_t spans[1];
    FILL(spans);
    nurbs_status status = nurbs_find_spans(degree, count, knots, knot_count, 1, &param, 0, spans, 0);
    CHECK_UNTOUCHED(spans);
    return status;
}

/* The output may not lie on the knots either. */
static void overlap_with_knots(void) {
    static const double param = 1.5;
    double knots[9];
    memcpy(knots, clamped, sizeof knots);
    CHECK_FAILS(nurbs_find_spans(2, 6, knots, 9, 1, &param, 0, (int64_t *)(void *)(knots + 8), 0),
                NURBS_ERROR_OVERLAP, "spans|knots");
    CHECK_BITS(knots, clamped, sizeof knots);
}

static void strided(void) {
    static const double params[] = {0.5, 99, 2.5, 99, 1};
    static const int64_t expected[] = {2, 5, 3};
    int64_t spans[3];
    CHECK_OK(nurbs_find_spans(2, 6, clamped, 9, 3, params, 2, spans, 0));
    CHECK_BITS(spans, expected, sizeof spans);
}

int main(void) {
    BatchCase c = {as_batch, NULL, 1, 1, "spans", "span", 0, 0, 1, 1};
    both_sides();
    outside();
    every_span_of_a_long_vector();
    strided();
    bad_knot_arguments(on_knots);
    huge_counts(on_knots);
    overlap_with_knots();
    batch_counts(&c);
    batch_param_strides(&c);
    batch_parameters(&c);
    batch_overlap(&c);
    bad_flags(&c);
    return check_summary("spans");
}
