/* SPDX-License-Identifier: MIT */
/* nurbs_collocation() and nurbs_rational_collocation(). */
#include "batch.h"
#include "check.h"
#include "knot_args.h"
#include "shapes.h"

#include <stdint.h>

enum { room = 64 };

static double values[room];
static int64_t columns[room], rows[room], entries;

static void clear(void) {
    FILL(values);
    FILL(columns);
    FILL(rows);
    memset(&entries, 0x5a, sizeof entries);
}

static void check_clear(int line) {
    check_untouched(__FILE__, line, values, sizeof values);
    check_untouched(__FILE__, line, columns, sizeof columns);
    check_untouched(__FILE__, line, rows, sizeof rows);
    check_untouched(__FILE__, line, &entries, sizeof entries);
}

#define REFUSE(call, status, words)                                                                          \
    do {                                                                                                     \
        clear();                                                                                             \
        CHECK_FAILS(call, status, words);                                                                    \
        check_clear(__LINE__);                                                                               \
    } while (0)

static void check_int64s(int line, const int64_t *actual, const int64_t *expected, int n) {
    for (int i = 0; i < n; ++i) {
        check_integers(__FILE__, line, "an index", actual[i], expected[i]);
    }
}

/* Knots of a shape, with the other arguments free. */
static nurbs_status of_shape(SplineArgs a, const int32_t *orders, int64_t n, const double *params,
                             uint32_t flags) {
    return nurbs_collocation(a.axes, a.degrees, a.counts, a.knots, a.knot_count, orders, n, params, 0, 0,
                             room, values, columns, rows, &entries, flags);
}

/* (1 - t, t) on each of two spans; the derivative is (-1, 1). */
static void hat_functions(void) {
    static const double params[] = {0.25, 1, 2, 1.5};
    static const double functions[] = {0.75, 0.25, 1, 0, 0, 1, 0.5, 0.5};
    static const double slopes[] = {-1, 1, -1, 1, -1, 1, -1, 1};
    static const int64_t at[] = {0, 1, 2, 3, 2, 3, 2, 3}, starts[] = {0, 2, 4, 6, 8};
    static const int32_t first[] = {1}, third[] = {3};
    clear();
    CHECK_OK(of_shape(jump(), NULL, 4, params, 0));
    CHECK_DOUBLES(values, functions, 8);
    check_int64s(__LINE__, columns, at, 8);
    check_int64s(__LINE__, rows, starts, 5);
    CHECK_INT(entries, 8);
    check_untouched(__FILE__, __LINE__, values + 8, sizeof values - 8 * sizeof *values);
    check_untouched(__FILE__, __LINE__, columns + 8, sizeof columns - 8 * sizeof *columns);
    check_untouched(__FILE__, __LINE__, rows + 5, sizeof rows - 5 * sizeof *rows);
    CHECK_OK(of_shape(jump(), first, 4, params, 0));
    CHECK_DOUBLES(values, slopes, 8);
    CHECK_OK(of_shape(jump(), third, 4, params, 0));
    CHECK_DOUBLES(values, ((const double[]){0, 0, 0, 0, 0, 0, 0, 0}), 8);
    CHECK_OK(of_shape(jump(), NULL, 1, params + 1, NURBS_LEFT));
    CHECK_DOUBLES(values, ((const double[]){0, 1}), 2);
    check_int64s(__LINE__, columns, at, 2);
}

static void tensors(void) {
    static const double at[] = {0.25, 0.5, 0.5};
    static const int32_t mixed[] = {1, 0, 1};
    static const double volume[] = {0.1875, 0.1875, 0.1875, 0.1875, 0.0625, 0.0625, 0.0625, 0.0625};
    static const double twist[] = {0.5, -0.5, 0.5, -0.5, -0.5, 0.5, -0.5, 0.5};
    CHECK_OK(of_shape(cube(), NULL, 1, at, 0));
    CHECK_DOUBLES(values, volume, 8);
    CHECK_INT(rows[1], 8);
    for (int j = 0; j < 8; ++j) {
        CHECK_INT(columns[j], j);
    }
    CHECK_OK(of_shape(cube(), mixed, 1, at, 0));
    CHECK_DOUBLES(values, twist, 8);
    CHECK_OK(of_shape(trough(), NULL, 1, (const double[]){0.5, 2.5}, 0));
    CHECK_DOUBLES(values, ((const double[]){0.125, 0.125, 0.25, 0.25, 0.125, 0.125}), 6);
    check_int64s(__LINE__, columns, (const int64_t[]){2, 3, 6, 7, 10, 11}, 6);
}

/* Weights 1, 1, 2 at t = 1/2: (1/4, 1/2, 1/2) / (5/4); w' = 2 t = 1, and R' = (w N' - w' N w_i / w) / w. */
static void quadratic(void) {
    static const int32_t degree = 2, first[] = {1};
    static const double points[] = {1, 0, 1, 1, 0, 1}, weights[] = {1, 1, 2}, params[] = {0, 0.5, 1};
    static const double functions[] = {1, 0, 0, 0.2, 0.4, 0.4, 0, 0, 1};
    static const double slopes[] = {-0.96, -0.32, 1.28};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 2, points, 0, 0, weights, 0, &g));
    CHECK_OK(nurbs_rational_collocation(g, NULL, 3, params, 0, 0, 9, values, columns, rows, &entries, 0));
    CHECK_NEAR(values, functions, 9, 4 * 0x1p-52);
    CHECK_INT(entries, 9);
    CHECK_OK(nurbs_rational_collocation(g, first, 1, params + 1, 0, 0, 9, values, NULL, NULL, NULL, 0));
    CHECK_NEAR(values, slopes, 3, 8 * 0x1p-52);
    nurbs_destroy(g);
}

/* Rows without a value stay rows: the first columns, NaN. */
static void without_values(void) {
    static const double params[] = {NAN, 3, 0.5};
    CHECK_OK(of_shape(hill(), NULL, 3, params, NURBS_NAN | NURBS_CLAMP));
    CHECK_DOUBLES(values, ((const double[]){NAN, NAN, NAN, 0.5, 0.5, 0, 0.5, 0.5, 0}), 9);
    check_int64s(__LINE__, columns, (const int64_t[]){0, 1, 2, 1, 2, 3, 0, 1, 2}, 9);
    check_int64s(__LINE__, rows, (const int64_t[]){0, 3, 6, 9}, 4);
}

/* Every array may be left out; cap 0 asks for the size. */
static void parts(const nurbs *g) {
    static const double params[] = {0.25, 0.5, 0.5, 0.75};
    clear();
    CHECK_OK(nurbs_rational_collocation(g, NULL, 2, params, 0, 0, 0, values, columns, NULL, &entries, 0));
    CHECK_INT(entries, 8);
    CHECK_UNTOUCHED(values);
    CHECK_UNTOUCHED(columns);
    CHECK_OK(nurbs_rational_collocation(g, NULL, 2, params, 0, 0, 8, NULL, columns, NULL, NULL, 0));
    CHECK_INT(columns[7], 3);
    CHECK_OK(nurbs_rational_collocation(g, NULL, 2, params, 0, 0, 8, values, NULL, NULL, NULL, 0));
    CHECK_DOUBLE(values[4], 0.125);
    clear();
    CHECK_OK(nurbs_rational_collocation(g, NULL, 0, NULL, 0, 0, 0, NULL, NULL, rows, &entries, 0));
    CHECK_INT(entries, 0);
    CHECK_INT(rows[0], 0);
    check_untouched(__FILE__, __LINE__, rows + 1, sizeof rows - sizeof *rows);
    CHECK_OK(nurbs_rational_collocation(g, NULL, 0, NULL, 0, 0, 0, NULL, NULL, NULL, NULL, 0));
}

static const double good[] = {0.25, 0.5, 0.75, 0.125};
static const int32_t one_one[] = {1, 1};

/* What both functions refuse; the patch as a handle or as its knots. */
static int by_knots;

static nurbs_status call(const nurbs *g, const int32_t *orders, int64_t n, const double *params,
                         int64_t stride, int64_t component_stride, int64_t cap, double *v, int64_t *c,
                         int64_t *r, int64_t *e, uint32_t flags) {
    const SplineArgs a = patch();
    return by_knots ? nurbs_collocation(a.axes, a.degrees, a.counts, a.knots, a.knot_count, orders, n, params,
                                        stride, component_stride, cap, v, c, r, e, flags)
                    : nurbs_rational_collocation(g, orders, n, params, stride, component_stride, cap, v, c, r,
                                                 e, flags);
}

#define BAD(orders, n, params, stride, component_stride, cap, flags, status, words)                          \
    REFUSE(                                                                                                  \
        call(g, orders, n, params, stride, component_stride, cap, values, columns, rows, &entries, flags),   \
        status, words)

static void bad_arguments(const nurbs *g) {
    static const int32_t low[] = {0, -1}, high[] = {256, 0}, many[] = {128, 128}, wild[] = {INT32_MIN, 0};
    BAD(low, 2, good, 0, 0, room, 0, NURBS_ERROR_ORDER, "orders[1|-1");
    BAD(high, 2, good, 0, 0, room, 0, NURBS_ERROR_ORDER, "orders[0|256");
    BAD(many, 2, good, 0, 0, room, 0, NURBS_ERROR_ORDER, "orders|256|255");
    BAD(wild, 2, good, 0, 0, room, 0, NURBS_ERROR_ORDER, "orders[0");
    BAD(one_one, -1, good, 0, 0, room, 0, NURBS_ERROR_COUNT, "n|-1");
    BAD(one_one, INT64_MAX, good, 0, 0, room, 0, NURBS_ERROR_OVERFLOW, "");
    BAD(one_one, INT64_MAX / 8 + 1, good, 1, 0, 0, 0, NURBS_ERROR_STRIDE, "params");
    BAD(one_one, INT64_MAX / 16, good, 0, 0, 0, 0, NURBS_ERROR_OVERFLOW, "");
    BAD(one_one, 2, NULL, 0, 0, room, 0, NURBS_ERROR_NULL, "params");
    BAD(one_one, 2, good, -1, 0, room, 0, NURBS_ERROR_STRIDE, "params|-1");
    BAD(one_one, 2, good, 1, 0, room, 0, NURBS_ERROR_STRIDE, "params");
    BAD(one_one, 2, good, 0, -1, room, 0, NURBS_ERROR_STRIDE, "params|-1");
    BAD(one_one, 2, good, 0, INT64_MAX, room, 0, NURBS_ERROR_OVERFLOW, "params");
    BAD(one_one, 2, good, 0, 0, -1, 0, NURBS_ERROR_COUNT, "cap|-1");
    BAD(one_one, 2, good, 0, 0, 7, 0, NURBS_ERROR_SIZE, "cap|7|8");
    BAD(one_one, 2, good, 0, 0, room, 0x20u, NURBS_ERROR_FLAGS, "flags");
    BAD(one_one, 2, good, 0, 0, room, NURBS_ACCUMULATE, NURBS_ERROR_FLAGS, "flags");
    BAD(one_one, 2, good, 0, 0, room, NURBS_ON_AXIS(2, NURBS_LEFT), NURBS_ERROR_FLAGS, "flags");
    BAD(one_one, 2, edited(good, 4, 3, NAN), 0, 0, room, 0, NURBS_ERROR_PARAMETER_NOT_FINITE,
        "params[1][1]|nan");
    BAD(one_one, 2, edited(good, 4, 0, INFINITY), 0, 0, room, 0, NURBS_ERROR_PARAMETER_NOT_FINITE,
        "params[0][0]|inf");
    BAD(one_one, 2, edited(good, 4, 1, 1.5), 0, 0, room, 0, NURBS_ERROR_OUTSIDE_DOMAIN, "params[0][1]|1.5");
    BAD(one_one, 2, edited(good, 4, 2, -0.5), 0, 0, room, 0, NURBS_ERROR_OUTSIDE_DOMAIN, "params[1][0]|-0.5");
}

static void overlap(const nurbs *g) {
    double shared[32] = {0}, copy[32] = {0};
    int64_t *whole = (int64_t *)(void *)shared;
    const double *params = shared + 8;
    CHECK_FAILS(call(g, NULL, 2, params, 0, 0, 8, shared + 1, NULL, NULL, NULL, 0), NURBS_ERROR_OVERLAP,
                "values|params");
    CHECK_FAILS(call(g, NULL, 2, params, 0, 0, 8, NULL, whole + 11, NULL, NULL, 0), NURBS_ERROR_OVERLAP,
                "columns|params");
    CHECK_FAILS(call(g, NULL, 2, params, 0, 0, 0, NULL, NULL, whole + 6, NULL, 0), NURBS_ERROR_OVERLAP,
                "row_pointers|params");
    CHECK_FAILS(call(g, NULL, 2, params, 0, 0, 0, NULL, NULL, NULL, whole + 9, 0), NURBS_ERROR_OVERLAP,
                "entries|params");
    CHECK_FAILS(call(g, NULL, 2, good, 0, 0, 8, shared, whole + 7, NULL, NULL, 0), NURBS_ERROR_OVERLAP,
                "columns|values");
    CHECK_FAILS(call(g, NULL, 2, good, 0, 0, 8, NULL, NULL, whole, whole + 2, 0), NURBS_ERROR_OVERLAP,
                "entries|row_pointers");
    CHECK_FAILS(call(g, (const int32_t *)(void *)(shared + 1), 2, good, 0, 0, 8, shared, NULL, NULL, NULL, 0),
                NURBS_ERROR_OVERLAP, "values|orders");
    CHECK_BITS(shared, copy, sizeof copy);
    CHECK_OK(call(g, NULL, 2, params, 0, 0, 8, shared, whole + 12, whole + 20, whole + 23, 0));
    CHECK_BITS(params, copy, 4 * sizeof *copy);
}

static void strided_params(const nurbs *g) {
    static const double apart[] = {0.25, 0.75, -1, 0.5, 0.125};
    double packed[8];
    CHECK_OK(call(g, NULL, 2, good, 0, 0, 8, packed, NULL, NULL, NULL, 0));
    CHECK_OK(call(g, NULL, 2, apart, 1, 3, 8, values, NULL, NULL, NULL, 0));
    CHECK_BITS(values, packed, sizeof packed);
}

static nurbs_status on_knots(int32_t degree, int64_t count, const double *knots, int64_t knot_count) {
    clear();
    nurbs_status status = nurbs_collocation(1, &degree, &count, knots, knot_count, NULL, 1, good, 0, 0, room,
                                            values, columns, rows, &entries, 0);
    check_clear(__LINE__);
    return status;
}

static void bad_axes(void) {
    static const int64_t wide[] = {INT64_C(1) << 32, INT64_C(1) << 32};
    const SplineArgs a = patch();
#define BAD_AXES(axes, degrees, counts, knots, knot_count, status, words)                                    \
    REFUSE(nurbs_collocation(axes, degrees, counts, knots, knot_count, NULL, 2, good, 0, 0, room, values,    \
                             columns, rows, &entries, 0),                                                    \
           status, words)
    BAD_AXES(0, a.degrees, a.counts, a.knots, 8, NURBS_ERROR_AXES, "axes|0");
    BAD_AXES(4, a.degrees, a.counts, a.knots, 8, NURBS_ERROR_AXES, "axes|4");
    BAD_AXES(2, NULL, a.counts, a.knots, 8, NURBS_ERROR_NULL, "degrees");
    BAD_AXES(2, a.degrees, NULL, a.knots, 8, NURBS_ERROR_NULL, "counts");
    BAD_AXES(2, a.degrees, a.counts, NULL, 8, NURBS_ERROR_NULL, "knots");
    BAD_AXES(2, a.degrees, a.counts, a.knots, 7, NURBS_ERROR_SIZE, "knot_count|7|8");
    BAD_AXES(2, a.degrees, wide, a.knots, 8, NURBS_ERROR_SIZE, "knot_count");
    BAD_AXES(2, a.degrees, a.counts, edited(a.knots, 8, 6, -1), 8, NURBS_ERROR_KNOTS_DECREASING, "knots[6");
    REFUSE(nurbs_collocation(2, a.degrees, a.counts, a.knots, 8, NULL, 2, good, 0, 0, room,
                             (double *)(uintptr_t)a.knots, columns, rows, &entries, 0),
           NURBS_ERROR_OVERLAP, "values|knots");
}

int main(void) {
    nurbs *g = make(patch());
    hat_functions();
    tensors();
    quadratic();
    without_values();
    parts(g);
    for (by_knots = 0; by_knots < 2; ++by_knots) {
        bad_arguments(g);
        overlap(g);
        strided_params(g);
    }
    bad_axes();
    bad_knot_arguments(on_knots);
    CHECK_FAILS(on_knots(2, INT64_MAX, good_knots().knots, 9), NURBS_ERROR_OVERFLOW, "knots");
    CHECK_FAILS(on_knots(2, INT64_MAX / 16, good_knots().knots, 9), NURBS_ERROR_SIZE, "knot_count|9");
    CHECK_FAILS(on_knots(2, 3, good_knots().knots, INT64_MIN), NURBS_ERROR_SIZE, "knot_count");
    REFUSE(nurbs_rational_collocation(NULL, NULL, 2, good, 0, 0, room, values, columns, rows, &entries, 0),
           NURBS_ERROR_NULL, "g");
    nurbs_destroy(g);
    return check_summary("collocation");
}
