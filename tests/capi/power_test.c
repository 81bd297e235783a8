/* SPDX-License-Identifier: MIT */
/* nurbs_to_power() and nurbs_create_power(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

static double coefficients[128], breaks[16];
static int64_t pieces[3], count;

static void clear(void) {
    FILL(coefficients);
    FILL(breaks);
    FILL(pieces);
    memset(&count, 0x5a, sizeof count);
}

static nurbs_status to_power(const nurbs *g, int64_t cap) {
    return nurbs_to_power(g, cap, coefficients, breaks, pieces, &count);
}

static void known(SplineArgs a, int64_t size, const double *expected, const double *all_breaks, int64_t n) {
    nurbs *g = make(a);
    clear();
    CHECK_OK(to_power(g, size));
    CHECK_INT(count, size);
    CHECK_DOUBLES(coefficients, expected, size);
    CHECK_DOUBLES(breaks, all_breaks, n);
    check_untouched(__FILE__, __LINE__, coefficients + size,
                    sizeof coefficients - sizeof(double) * (size_t)size);
    check_untouched(__FILE__, __LINE__, breaks + n, sizeof breaks - sizeof(double) * (size_t)n);
    nurbs_destroy(g);
}

static void shapes(void) {
    known(arch(), 8, VALUES(0, 0, 3, 6, 3, -6, -2, 0), VALUES(0, 1), 2);
    known(hill(), 9, VALUES(1, 2, 0, 3, 2, -2, 3, -2, 0), VALUES(2, 3, 4, 5), 4);
    known(loop(), 24, VALUES(0, 1, -2, 0, 1, -1, -1, 0, 0, -2, 1, 1, 0, -1, 2, 0, -1, 1, 1, 0, 0, 2, -1, -1),
          VALUES(2, 3, 4, 5, 6), 5);
    known(jump(), 4, VALUES(0, 1, 5, 1), VALUES(0, 1, 2), 3);
    known(stairs(), 3, VALUES(10, 20, 30), VALUES(0, 1, 2, 3), 4);
    known(patch(), 12, VALUES(0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1), VALUES(0, 1, 0, 1), 4);
    known(trough(), 54,
          VALUES(0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, /* v in [0, 1] */
                 0, 1, 1, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, /* [1, 2] */
                 0, 2, 2, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0),
          VALUES(0, 1, 0, 1, 2, 3), 6);
    known(cube(), 32,
          VALUES(0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
                 1),
          VALUES(0, 1, 0, 1, 0, 1), 6);
}

static void parts(void) {
    nurbs *g = make(circle());
    clear();
    CHECK_OK(to_power(g, 0));
    CHECK_INT(count, 36);
    CHECK_INT(pieces[0], 4);
    CHECK_UNTOUCHED(coefficients);
    CHECK_UNTOUCHED(breaks);
    clear();
    CHECK_OK(nurbs_to_power(g, 36, NULL, breaks, NULL, NULL));
    CHECK_DOUBLES(breaks, VALUES(0, 0.25, 0.5, 0.75, 1), 5);
    CHECK_OK(nurbs_to_power(g, 99, coefficients, NULL, NULL, NULL));
    CHECK_DOUBLES(coefficients + 9, VALUES(0, 1, 1), 3); /* homogeneous */
    nurbs_destroy(g);
}

static void refused(const nurbs *g, nurbs_status status, int64_t cap, const char *words) {
    clear();
    CHECK_FAILS(to_power(g, cap), status, words);
    CHECK_UNTOUCHED(coefficients);
    CHECK_UNTOUCHED(breaks);
    CHECK_UNTOUCHED(pieces);
    check_untouched(__FILE__, __LINE__, &count, sizeof count);
}

static void refusals(void) {
    nurbs *g = make(arch());
    refused(NULL, NURBS_ERROR_NULL, 8, "g");
    refused(g, NURBS_ERROR_COUNT, -1, "cap = -1");
    refused(g, NURBS_ERROR_SIZE, 7, "cap = 7|8");
    clear();
    CHECK_FAILS(nurbs_to_power(g, 8, coefficients, coefficients + 7, pieces, &count), NURBS_ERROR_OVERLAP,
                "breaks|coefficients");
    CHECK_FAILS(nurbs_to_power(g, 8, coefficients, breaks, pieces, pieces), NURBS_ERROR_OVERLAP,
                "count|piece_counts");
    CHECK_UNTOUCHED(coefficients);
    nurbs_destroy(g);
    static const double steep[] = {0, 0, 1e-300, 1e-300}, far[] = {-1e10, 1e10};
    static const int32_t one = 1;
    static const int64_t two = 2;
    CHECK_OK(nurbs_create(1, &one, &two, steep, 4, 1, far, 0, 0, NULL, 0, 0, &g));
    refused(g, NURBS_ERROR_NOT_REPRESENTABLE, 2, "coefficients|value 1");
    nurbs_destroy(g);
}

/* Terms overflow on the way to coefficients that do not. */
static void large_points(void) {
    nurbs *g = NULL;
    const int32_t one = 1, two = 2;
    CHECK_OK(nurbs_create(1, &one, &(const int64_t){2}, VALUES(0, 0, 10, 10), 4, 1, VALUES(-1.7e308, 1.7e308),
                          0, 0, NULL, 0, 0, &g));
    CHECK_OK(to_power(g, 2));
    CHECK_DOUBLES(coefficients, VALUES(-1.7e308, 2 * (1.7e308 / 10)), 2);
    nurbs_destroy(g);
    CHECK_OK(nurbs_create(1, &two, &(const int64_t){3}, VALUES(0, 0, 0, 4, 4, 4), 6, 1,
                          VALUES(0, 0x1p1023, 0x1p1022), 0, 0, NULL, 0, 0, &g));
    CHECK_OK(to_power(g, 3));
    CHECK_DOUBLES(coefficients, VALUES(0, 0x1p1022, -0.75 * 0x1p1020), 3);
    nurbs_destroy(g);
}

static const int32_t degrees[] = {2, 1};
static const int64_t counts[] = {2, 1};
static const double ends[] = {0, 2, 3, -1, 3}, sums[] = {1, 0, 0, 1, 0, 0, 4, 0, 2, 0, 0, 0};

static nurbs_status from_power(uint32_t flags, nurbs **out) {
    return nurbs_create_power(2, degrees, counts, ends, 5, 1, sums, 0, 0, flags, out);
}

static void made(void) {
    nurbs *h = NULL;
    CHECK_OK(from_power(0, &h)); /* 1 + u v, and 4 + 2 u with v - (-1) and u - 2 */
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 2, 2, 2, 3, 3, 3));
    CHECK_KNOTS(h, 1, VALUES(-1, -1, 3, 3));
    CHECK_POINTS(h, VALUES(1, 1, 1, 5, 1, 9, 4, 4, 5, 5, 6, 6));
    nurbs_destroy(h);
    const double records[] = {2, 0, 3, 0, 1, 0, 0.5}; /* (2 + t) / (3 + t / 2), strided */
    CHECK_OK(
        nurbs_create_power(1, degrees + 1, counts + 1, ends, 2, 1, records, 4, 2, NURBS_HOMOGENEOUS, &h));
    CHECK_WEIGHTS(h, VALUES(3, 4));
    nurbs_destroy(h);
}

#define REFUSE(call, status, words) CHECK_NO_HANDLE(h, call, status, words)

static void not_made(void) {
    nurbs *h = NULL;
    static const int64_t none[] = {2, 0}, many[] = {INT64_MAX, 1};
    static const int32_t high[] = {2, 32};
    REFUSE(nurbs_create_power(0, degrees, counts, ends, 5, 1, sums, 0, 0, 0, &h), NURBS_ERROR_AXES, "axes");
    REFUSE(nurbs_create_power(2, NULL, counts, ends, 5, 1, sums, 0, 0, 0, &h), NURBS_ERROR_NULL, "degrees");
    REFUSE(nurbs_create_power(2, high, counts, ends, 5, 1, sums, 0, 0, 0, &h), NURBS_ERROR_DEGREE, "32");
    REFUSE(nurbs_create_power(2, degrees, NULL, ends, 5, 1, sums, 0, 0, 0, &h), NURBS_ERROR_NULL,
           "piece_counts");
    REFUSE(nurbs_create_power(2, degrees, none, ends, 5, 1, sums, 0, 0, 0, &h), NURBS_ERROR_COUNT,
           "piece_counts[1] = 0");
    REFUSE(nurbs_create_power(2, degrees, many, ends, 5, 1, sums, 0, 0, 0, &h), NURBS_ERROR_OVERFLOW,
           "exceed");
    REFUSE(nurbs_create_power(2, degrees, counts, ends, 4, 1, sums, 0, 0, 0, &h), NURBS_ERROR_SIZE,
           "break_count|4|5");
    REFUSE(nurbs_create_power(2, degrees, counts, NULL, 5, 1, sums, 0, 0, 0, &h), NURBS_ERROR_NULL, "breaks");
    REFUSE(nurbs_create_power(2, degrees, counts, ends, 5, 0, sums, 0, 0, 0, &h), NURBS_ERROR_DIMENSION, "0");
    REFUSE(nurbs_create_power(2, degrees, counts, ends, 5, 1, NULL, 0, 0, 0, &h), NURBS_ERROR_NULL,
           "coefficients");
    REFUSE(nurbs_create_power(2, degrees, counts, ends, 5, 1, sums, -1, 0, 0, &h), NURBS_ERROR_STRIDE,
           "coefficients");
    REFUSE(from_power(1, &h), NURBS_ERROR_FLAGS, "0x1|NURBS_HOMOGENEOUS");
    REFUSE(nurbs_create_power(2, degrees, counts, edited(ends, 5, 1, NAN), 5, 1, sums, 0, 0, 0, &h),
           NURBS_ERROR_KNOT_NOT_FINITE, "breaks[1] = nan");
    REFUSE(nurbs_create_power(2, degrees, counts, edited(ends, 5, 4, -1), 5, 1, sums, 0, 0, 0, &h),
           NURBS_ERROR_KNOTS_DECREASING, "breaks[4] = -1|breaks[3] = -1");
    REFUSE(nurbs_create_power(1, degrees + 1, counts + 1, VALUES(-1e308, 1e308), 2, 1, sums, 0, 0, 0, &h),
           NURBS_ERROR_KNOT_NOT_FINITE, "breaks[1]|overflows");
    REFUSE(nurbs_create_power(2, degrees, counts, ends, 5, 1, edited(sums, 12, 3, INFINITY), 0, 0, 0, &h),
           NURBS_ERROR_POINT_NOT_FINITE, "inf");
    REFUSE(
        nurbs_create_power(1, degrees + 1, counts + 1, VALUES(0, 1e10), 2, 1, VALUES(0, 1e300), 0, 0, 0, &h),
        NURBS_ERROR_NOT_REPRESENTABLE, "points|value 1");
    REFUSE(nurbs_create_power(1, degrees + 1, counts + 1, ends, 2, 1, VALUES(1, 0, 1, 0), 0, 0,
                              NURBS_HOMOGENEOUS, &h),
           NURBS_ERROR_WEIGHTS_VANISH, "weight");
    static const int32_t ones[] = {1, 1};
    static const int64_t side_by_side[] = {1, 2};
    REFUSE(nurbs_create_power(2, ones, side_by_side, VALUES(0, 1, 0, 1, 2), 5, 1,
                              VALUES(0, 0, NAN, 0, 0, 0, 0, 0), 0, 0, 0, &h),
           NURBS_ERROR_POINT_NOT_FINITE, "coefficients[2][0] = nan");
    CHECK_FAILS(from_power(0, NULL), NURBS_ERROR_NULL, "out");
}

int main(void) {
    shapes();
    parts();
    refusals();
    made();
    large_points();
    not_made();
    return check_summary("power");
}
