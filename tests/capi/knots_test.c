/* SPDX-License-Identifier: MIT */
/* The generators of knot vectors. */
#include "check.h"

#include <float.h>

#include <stdint.h>

/* Outputs are longer than any vector asked for, so that a write past the end is seen. */
static double out[32];

#define KNOTS_OK(call, n, ...)                                                                               \
    do {                                                                                                     \
        static const double expected_[] = {__VA_ARGS__};                                                     \
        FILL(out);                                                                                           \
        CHECK_OK(call);                                                                                      \
        CHECK_DOUBLES(out, expected_, n);                                                                    \
        check_untouched(__FILE__, __LINE__, out + (n), sizeof out - (n) * sizeof *out);                      \
    } while (0)
#define KNOTS_FAIL(call, status, words)                                                                      \
    do {                                                                                                     \
        FILL(out);                                                                                           \
        CHECK_FAILS(call, status, words);                                                                    \
        CHECK_UNTOUCHED(out);                                                                                \
    } while (0)

static void uniform(void) {
    KNOTS_OK(nurbs_knots_uniform(2, 5, 2, 5, 8, out), 8, 0, 1, 2, 3, 4, 5, 6, 7);
    KNOTS_OK(nurbs_knots_uniform(3, 4, 0, 1, 8, out), 8, -3, -2, -1, 0, 1, 2, 3, 4);
    KNOTS_OK(nurbs_knots_uniform(0, 2, -1, 1, 3, out), 3, -1, 0, 1);
    KNOTS_OK(nurbs_knots_uniform(1, 3, 0, 0.5, 5, out), 5, -0.25, 0, 0.25, 0.5, 0.75);
}

static void open_uniform(void) {
    KNOTS_OK(nurbs_knots_open_uniform(2, 5, 2, 5, 8, out), 8, 2, 2, 2, 3, 4, 5, 5, 5);
    KNOTS_OK(nurbs_knots_open_uniform(3, 4, 0, 1, 8, out), 8, 0, 0, 0, 0, 1, 1, 1, 1);
    KNOTS_OK(nurbs_knots_open_uniform(0, 4, 0, 1, 5, out), 5, 0, 0.25, 0.5, 0.75, 1);
    KNOTS_OK(nurbs_knots_open_uniform(1, 3, -2, 2, 5, out), 5, -2, -2, 0, 2, 2);
}

/* The domain's ends are the numbers given, whatever the step rounds to. */
static void ends_are_exact(void) {
    double knots[17];
    CHECK_OK(nurbs_knots_uniform(3, 13, 0.1, 0.7, 17, knots));
    CHECK_DOUBLE(knots[3], 0.1);
    CHECK_DOUBLE(knots[13], 0.7);
    CHECK_OK(nurbs_knots_open_uniform(3, 13, 0.1, 0.7, 17, knots));
    CHECK_DOUBLE(knots[0], 0.1);
    CHECK_DOUBLE(knots[16], 0.7);
    for (int i = 1; i < 17; ++i) {
        CHECK(knots[i - 1] <= knots[i]);
    }
}

typedef nurbs_status (*Between)(int32_t, int64_t, double, double, int64_t, double *);

static void between_refuses(Between f) {
    KNOTS_FAIL(f(2, 5, 0, 1, 8, NULL), NURBS_ERROR_NULL, "knots");
    KNOTS_FAIL(f(-1, 5, 0, 1, 8, out), NURBS_ERROR_DEGREE, "degree|-1");
    KNOTS_FAIL(f(32, 50, 0, 1, 83, out), NURBS_ERROR_DEGREE, "degree|32");
    KNOTS_FAIL(f(2, 0, 0, 1, 3, out), NURBS_ERROR_COUNT, "count|0");
    KNOTS_FAIL(f(2, -5, 0, 1, 8, out), NURBS_ERROR_COUNT, "count|-5");
    KNOTS_FAIL(f(2, 2, 0, 1, 5, out), NURBS_ERROR_TOO_FEW_POINTS, "count|2|3");
    KNOTS_FAIL(f(2, 5, 0, 1, 7, out), NURBS_ERROR_SIZE, "knot_count|7|8");
    KNOTS_FAIL(f(2, 5, 0, 1, 9, out), NURBS_ERROR_SIZE, "knot_count|9|8");
    KNOTS_FAIL(f(2, 5, 0, 1, -1, out), NURBS_ERROR_SIZE, "knot_count|-1");
    KNOTS_FAIL(f(2, INT64_MAX / 2, 0, 1, 8, out), NURBS_ERROR_SIZE, "knot_count|8");
    KNOTS_FAIL(f(2, 5, NAN, 1, 8, out), NURBS_ERROR_KNOT_NOT_FINITE, "a|nan");
    KNOTS_FAIL(f(2, 5, 0, NAN, 8, out), NURBS_ERROR_KNOT_NOT_FINITE, "b|nan");
    KNOTS_FAIL(f(2, 5, -INFINITY, 1, 8, out), NURBS_ERROR_KNOT_NOT_FINITE, "a|-inf");
    KNOTS_FAIL(f(2, 5, 0, INFINITY, 8, out), NURBS_ERROR_KNOT_NOT_FINITE, "b|inf");
    KNOTS_FAIL(f(2, 5, 1, 1, 8, out), NURBS_ERROR_EMPTY_DOMAIN, "1");
    KNOTS_FAIL(f(2, 5, 1, 0.5, 8, out), NURBS_ERROR_EMPTY_DOMAIN, "1|0.5");
    KNOTS_FAIL(f(2, 5, 1, 1 + DBL_EPSILON, 8, out), NURBS_ERROR_NOT_REPRESENTABLE, "3 spans");
}

/* INT64_MAX + degree + 1 is no count of knots; either the count or the total is named. */
static void between_huge(Between f) {
    FILL(out);
    nurbs_status status = f(2, INT64_MAX, 0, 1, 8, out);
    CHECK(status == NURBS_ERROR_SIZE || status == NURBS_ERROR_OVERFLOW);
    CHECK_UNTOUCHED(out);
}

static void outer_knots_overflow(void) {
    KNOTS_FAIL(nurbs_knots_uniform(3, 4, -1e308, 0.5e308, 8, out), NURBS_ERROR_NOT_REPRESENTABLE, "knots");
}

static void bezier(void) {
    static const double breaks[] = {-1, 0.5, 4};
    KNOTS_OK(nurbs_knots_bezier(2, 2, breaks, 8, out), 8, -1, -1, -1, 0.5, 0.5, 4, 4, 4);
    KNOTS_OK(nurbs_knots_bezier(1, 2, breaks, 5, out), 5, -1, -1, 0.5, 4, 4);
    KNOTS_OK(nurbs_knots_bezier(0, 2, breaks, 3, out), 3, -1, 0.5, 4);
    KNOTS_OK(nurbs_knots_bezier(3, 1, NULL, 8, out), 8, 0, 0, 0, 0, 1, 1, 1, 1);
    KNOTS_OK(nurbs_knots_bezier(1, 4, NULL, 7, out), 7, 0, 0, 0.25, 0.5, 0.75, 1, 1);
}

static void bezier_refuses(void) {
    static const double breaks[] = {0, 1, 2};
    KNOTS_FAIL(nurbs_knots_bezier(2, 2, breaks, 8, NULL), NURBS_ERROR_NULL, "knots");
    KNOTS_FAIL(nurbs_knots_bezier(-1, 2, breaks, 8, out), NURBS_ERROR_DEGREE, "degree|-1");
    KNOTS_FAIL(nurbs_knots_bezier(32, 2, breaks, 98, out), NURBS_ERROR_DEGREE, "degree|32");
    KNOTS_FAIL(nurbs_knots_bezier(2, 0, breaks, 3, out), NURBS_ERROR_COUNT, "pieces|0");
    KNOTS_FAIL(nurbs_knots_bezier(2, -1, breaks, 8, out), NURBS_ERROR_COUNT, "pieces|-1");
    KNOTS_FAIL(nurbs_knots_bezier(2, 2, breaks, 7, out), NURBS_ERROR_SIZE, "knot_count|7|8");
    KNOTS_FAIL(nurbs_knots_bezier(2, 2, edited(breaks, 3, 1, NAN), 8, out), NURBS_ERROR_KNOT_NOT_FINITE,
               "breaks[1|nan");
    KNOTS_FAIL(nurbs_knots_bezier(2, 2, edited(breaks, 3, 2, INFINITY), 8, out), NURBS_ERROR_KNOT_NOT_FINITE,
               "breaks[2|inf");
    KNOTS_FAIL(nurbs_knots_bezier(2, 2, edited(breaks, 3, 1, 0), 8, out), NURBS_ERROR_KNOTS_DECREASING,
               "breaks[1] = 0, expected more than breaks[0] = 0");
    KNOTS_FAIL(nurbs_knots_bezier(2, 2, edited(breaks, 3, 2, 0.5), 8, out), NURBS_ERROR_KNOTS_DECREASING,
               "breaks[2] = 0.5, expected more than breaks[1] = 1");
}

static void huge_pieces(void) {
    FILL(out);
    nurbs_status status = nurbs_knots_bezier(2, INT64_MAX / 2 + 1, NULL, 8, out);
    CHECK(status == NURBS_ERROR_SIZE || status == NURBS_ERROR_OVERFLOW);
    status = nurbs_knots_bezier(31, INT64_MAX, NULL, 8, out);
    CHECK(status == NURBS_ERROR_SIZE || status == NURBS_ERROR_OVERFLOW);
    CHECK_UNTOUCHED(out);
}

static void averaged(void) {
    static const double params[] = {0, 1, 3, 5, 8};
    KNOTS_OK(nurbs_knots_averaged(2, 5, params, 8, out), 8, 0, 0, 0, 2, 4, 8, 8, 8);
    KNOTS_OK(nurbs_knots_averaged(1, 5, params, 7, out), 7, 0, 0, 1, 3, 5, 8, 8);
    KNOTS_OK(nurbs_knots_averaged(3, 5, params, 9, out), 9, 0, 0, 0, 0, 3, 8, 8, 8, 8);
    KNOTS_OK(nurbs_knots_averaged(0, 5, params, 6, out), 6, 0, 0.5, 2, 4, 6.5, 8);
}

static void averaged_refuses(void) {
    static const double params[] = {0, 1, 3, 5, 8}, constant[] = {1, 1, 1};
    static const double repeated[] = {0, 1, 1, 1, 1, 1, 2}, at_start[] = {0, 0, 0, 1};
    KNOTS_FAIL(nurbs_knots_averaged(2, 5, params, 8, NULL), NURBS_ERROR_NULL, "knots");
    KNOTS_FAIL(nurbs_knots_averaged(2, 5, NULL, 8, out), NURBS_ERROR_NULL, "params");
    KNOTS_FAIL(nurbs_knots_averaged(-2, 5, params, 8, out), NURBS_ERROR_DEGREE, "degree|-2");
    KNOTS_FAIL(nurbs_knots_averaged(32, 5, params, 8, out), NURBS_ERROR_DEGREE, "degree|32");
    KNOTS_FAIL(nurbs_knots_averaged(2, 0, params, 3, out), NURBS_ERROR_COUNT, "count|0");
    KNOTS_FAIL(nurbs_knots_averaged(2, -1, params, 3, out), NURBS_ERROR_COUNT, "count|-1");
    KNOTS_FAIL(nurbs_knots_averaged(2, 2, params, 5, out), NURBS_ERROR_TOO_FEW_POINTS, "count|2|3");
    KNOTS_FAIL(nurbs_knots_averaged(2, 5, params, 9, out), NURBS_ERROR_SIZE, "knot_count|9|8");
    KNOTS_FAIL(nurbs_knots_averaged(2, 5, edited(params, 5, 3, NAN), 8, out),
               NURBS_ERROR_PARAMETER_NOT_FINITE, "params[3|nan");
    KNOTS_FAIL(nurbs_knots_averaged(2, 5, edited(params, 5, 4, INFINITY), 8, out),
               NURBS_ERROR_PARAMETER_NOT_FINITE, "params[4|inf");
    KNOTS_FAIL(nurbs_knots_averaged(2, 5, edited(params, 5, 2, 0.5), 8, out), NURBS_ERROR_KNOTS_DECREASING,
               "params[2|0.5");
    KNOTS_FAIL(nurbs_knots_averaged(2, 3, constant, 6, out), NURBS_ERROR_EMPTY_DOMAIN, "1");
    KNOTS_FAIL(nurbs_knots_averaged(1, 7, repeated, 9, out), NURBS_ERROR_MULTIPLICITY, "1");
    KNOTS_FAIL(nurbs_knots_averaged(1, 4, at_start, 6, out), NURBS_ERROR_END_MULTIPLICITY, "0");
}

static void periodic(void) {
    static const double breaks[] = {0, 1, 3, 4};
    static const int32_t multiplicities[] = {2, 1, 1, 2}, twice_inside[] = {1, 2, 1, 1};
    KNOTS_OK(nurbs_knots_periodic(2, 4, breaks, NULL, 8, out), 8, -3, -1, 0, 1, 3, 4, 5, 7);
    KNOTS_OK(nurbs_knots_periodic(0, 4, breaks, NULL, 4, out), 4, 0, 1, 3, 4);
    KNOTS_OK(nurbs_knots_periodic(1, 4, breaks, twice_inside, 7, out), 7, -1, 0, 1, 1, 3, 4, 5);
    FILL(out);
    CHECK_OK(nurbs_knots_periodic(2, 4, breaks, multiplicities, 9, out));
    CHECK_DOUBLE(out[2], 0);
    CHECK_DOUBLE(out[6], 4);
    for (int i = 0; i + 4 < 9; ++i) {
        CHECK_DOUBLE(out[i + 4], out[i] + 4);
    }
    check_untouched(__FILE__, __LINE__, out + 9, sizeof out - 9 * sizeof *out);
}

/* A period shorter than the degree goes round several times. */
static void short_period(void) {
    static const double breaks[] = {0, 1};
    KNOTS_OK(nurbs_knots_periodic(3, 2, breaks, NULL, 8, out), 8, -3, -2, -1, 0, 1, 2, 3, 4);
}

static void periodic_refuses(void) {
    static const double breaks[] = {0, 1, 3, 4}, wide[] = {-1.5e308, 0, 1, 1.5e308}, far[] = {0, 1, 1.5e308};
    static const int32_t zero[] = {1, 0, 1, 1}, high[] = {1, 1, 4, 1}, unequal[] = {1, 1, 1, 2};
    static const int32_t twice[] = {1, 2, 1, 1};
    KNOTS_FAIL(nurbs_knots_periodic(2, 4, breaks, NULL, 8, NULL), NURBS_ERROR_NULL, "knots");
    KNOTS_FAIL(nurbs_knots_periodic(2, 4, NULL, NULL, 8, out), NURBS_ERROR_NULL, "breaks");
    KNOTS_FAIL(nurbs_knots_periodic(-1, 4, breaks, NULL, 8, out), NURBS_ERROR_DEGREE, "degree|-1");
    KNOTS_FAIL(nurbs_knots_periodic(32, 4, breaks, NULL, 8, out), NURBS_ERROR_DEGREE, "degree|32");
    KNOTS_FAIL(nurbs_knots_periodic(2, 1, breaks, NULL, 5, out), NURBS_ERROR_COUNT, "n|1");
    KNOTS_FAIL(nurbs_knots_periodic(2, 0, breaks, NULL, 5, out), NURBS_ERROR_COUNT, "n|0");
    KNOTS_FAIL(nurbs_knots_periodic(2, -4, breaks, NULL, 8, out), NURBS_ERROR_COUNT, "n|-4");
    KNOTS_FAIL(nurbs_knots_periodic(2, 4, breaks, NULL, 7, out), NURBS_ERROR_SIZE, "knot_count|7|8");
    KNOTS_FAIL(nurbs_knots_periodic(2, 4, edited(breaks, 4, 1, NAN), NULL, 8, out),
               NURBS_ERROR_KNOT_NOT_FINITE, "breaks[1|nan");
    KNOTS_FAIL(nurbs_knots_periodic(2, 4, edited(breaks, 4, 3, INFINITY), NULL, 8, out),
               NURBS_ERROR_KNOT_NOT_FINITE, "breaks[3|inf");
    KNOTS_FAIL(nurbs_knots_periodic(2, 4, edited(breaks, 4, 2, 1), NULL, 8, out),
               NURBS_ERROR_KNOTS_DECREASING, "breaks[2|1");
    KNOTS_FAIL(nurbs_knots_periodic(2, 4, edited(breaks, 4, 2, 0.5), NULL, 8, out),
               NURBS_ERROR_KNOTS_DECREASING, "breaks[2|0.5");
    KNOTS_FAIL(nurbs_knots_periodic(2, 4, breaks, high, 11, out), NURBS_ERROR_MULTIPLICITY,
               "multiplicities[2|4");
    KNOTS_FAIL(nurbs_knots_periodic(0, 4, breaks, twice, 5, out), NURBS_ERROR_MULTIPLICITY,
               "multiplicities[1|2");
    KNOTS_FAIL(nurbs_knots_periodic(2, 4, breaks, unequal, 8, out), NURBS_ERROR_PERIODIC_KNOTS,
               "multiplicities|2|1");
    KNOTS_FAIL(nurbs_knots_periodic(2, 3, far, NULL, 7, out), NURBS_ERROR_NOT_REPRESENTABLE, "");
    FILL(out);
    check_forget();
    nurbs_status status = nurbs_knots_periodic(2, 4, breaks, zero, 7, out);
    CHECK(status == NURBS_ERROR_MULTIPLICITY || status == NURBS_ERROR_COUNT);
    status = nurbs_knots_periodic(2, 4, wide, NULL, 8, out);
    CHECK(status == NURBS_ERROR_NOT_REPRESENTABLE || status == NURBS_ERROR_KNOT_NOT_FINITE);
    status = nurbs_knots_periodic(2, INT64_MAX, breaks, NULL, 8, out);
    CHECK(status == NURBS_ERROR_OVERFLOW || status == NURBS_ERROR_SIZE);
    CHECK_UNTOUCHED(out);
}

/* Lengths that no array has. */
static void endless(void) {
    static const double breaks[] = {0, 1, 2};
    for (int shift = 60; shift <= 63; ++shift) {
        const int64_t n = shift == 63 ? INT64_MAX : (int64_t)1 << shift;
        KNOTS_FAIL(nurbs_knots_uniform(2, 5, 0, 1, n, out), NURBS_ERROR_OVERFLOW, "knots");
        KNOTS_FAIL(nurbs_knots_open_uniform(2, 5, 0, 1, n, out), NURBS_ERROR_OVERFLOW, "knots");
        KNOTS_FAIL(nurbs_knots_bezier(2, n, breaks, n, out), NURBS_ERROR_OVERFLOW, "knots");
        KNOTS_FAIL(nurbs_knots_averaged(2, n - 3, breaks, n, out), NURBS_ERROR_OVERFLOW, "knots");
        KNOTS_FAIL(nurbs_knots_periodic(0, n, breaks, NULL, n, out), NURBS_ERROR_OVERFLOW, "knots");
    }
}

/* Inputs and outputs in one array. */
static void overlaps(void) {
    static const double start[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
    double shared[12];
    memcpy(shared, start, sizeof shared);
    CHECK_FAILS(nurbs_knots_bezier(2, 2, shared, 8, shared), NURBS_ERROR_OVERLAP, "knots|breaks");
    CHECK_FAILS(nurbs_knots_bezier(2, 2, shared + 7, 8, shared), NURBS_ERROR_OVERLAP, "knots|breaks");
    CHECK_FAILS(nurbs_knots_averaged(2, 5, shared + 3, 8, shared), NURBS_ERROR_OVERLAP, "knots|params");
    CHECK_FAILS(nurbs_knots_periodic(2, 4, shared, NULL, 8, shared + 3), NURBS_ERROR_OVERLAP, "knots|breaks");
    CHECK_BITS(shared, start, sizeof shared);
    CHECK_OK(nurbs_knots_bezier(2, 2, shared + 8, 8, shared));
    CHECK_DOUBLE(shared[7], 10);
}

int main(void) {
    endless();
    uniform();
    open_uniform();
    ends_are_exact();
    between_refuses(nurbs_knots_uniform);
    between_refuses(nurbs_knots_open_uniform);
    between_huge(nurbs_knots_uniform);
    between_huge(nurbs_knots_open_uniform);
    outer_knots_overflow();
    bezier();
    bezier_refuses();
    huge_pieces();
    averaged();
    averaged_refuses();
    periodic();
    short_period();
    periodic_refuses();
    overlaps();
    return check_summary("knots");
}
