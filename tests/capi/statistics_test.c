/* SPDX-License-Identifier: MIT */
/* Statistics of data: made, added, subtracted; and what nurbs_fit() asks of them. */
#include "shapes.h"
#include "some_statistics.h"

static void sizes(void) {
    nurbs_statistics *none = empty(), *all = sum_of(none, some_data());
    CHECK_SIZE(none, 0, 0, 0);
    CHECK_SIZE(all, 5, 2, 4.8);
    CHECK_OK(nurbs_statistics_size(all, NULL, NULL, NULL, NULL, NULL));
    CHECK_FAILS(nurbs_statistics_size(NULL, NULL, NULL, NULL, NULL, NULL), NURBS_ERROR_NULL, "statistics");
    nurbs_statistics_destroy(none);
    nurbs_statistics_destroy(all);
    nurbs_statistics_destroy(NULL);
}

/* In parts, in any order, or all at once: the same bytes. */
static void sums(void) {
    nurbs_statistics *none = empty(), *all = sum_of(none, some_data());
    nurbs_statistics *a = part(0, 2), *b = part(2, 3), *c = part(3, 6), *d = NULL, *nothing = NULL;
    nurbs_data rest = some_data();
    CHECK_OK(nurbs_statistics_merge(4, (const nurbs_statistics *[]){c, none, a, b}, NULL, &d));
    CHECK_SAME(d, all);
    CHECK_SIZE(d, 5, 2, 4.8);
    nurbs_statistics_destroy(d);
    rest.n = 4;
    rest.params += 2;
    rest.values += 4;
    rest.weights += 2;
    d = sum_of(a, rest);
    CHECK_SAME(d, all);
    nurbs_statistics_destroy(d);
    CHECK_OK(nurbs_statistics_merge(3, (const nurbs_statistics *[]){b, all, c}, DEGREES(-1, 1, -1), &d));
    CHECK_SAME(d, a);
    CHECK_OK(nurbs_statistics_merge(2, (const nurbs_statistics *[]){d, a}, DEGREES(1, -1), &nothing));
    CHECK_SAME(nothing, none);
    CHECK_SIZE(nothing, 0, 0, 0);
    nurbs_statistics *const made[] = {none, all, a, b, c, d, nothing};
    for (size_t i = 0; i < sizeof made / sizeof *made; ++i) {
        nurbs_statistics_destroy(made[i]);
    }
}

/* One handle several times; handles outlive those they were made from. */
static void clones(void) {
    nurbs_statistics *all = part(0, 6), *clone = NULL, *twice = NULL;
    const Bytes before = bytes_of(all);
    CHECK_OK(nurbs_statistics_clone(all, &clone));
    CHECK_OK(
        nurbs_statistics_merge(3, (const nurbs_statistics *[]){all, clone, all}, DEGREES(1, 1, 1), &twice));
    CHECK_SIZE(twice, 15, 2, 14.4);
    CHECK_SAME(clone, all);
    nurbs_statistics_destroy(all);
    const Bytes after = bytes_of(clone);
    CHECK_BITS(&before, &after, sizeof before);
    nurbs_statistics_destroy(clone);
    nurbs_statistics_destroy(twice);
    CHECK_NO_STATISTICS(clone, nurbs_statistics_clone(NULL, &clone), NURBS_ERROR_NULL, "statistics");
    all = empty();
    CHECK_FAILS(nurbs_statistics_clone(all, NULL), NURBS_ERROR_NULL, "out");
    nurbs_statistics_destroy(all);
}

/* Data that are left out leave nothing, wherever they are and whatever their values are. */
static void data_left_out(void) {
    nurbs_statistics *none = empty(), *some = part(0, 2);
    nurbs_data data =
        data_of(1, 2, 5, VALUES(0, NAN, 0.5, 7, 3), VALUES(1, 2, NAN, NAN, -8, 3, 1e30, 1, INFINITY, NAN));
    data.weights = VALUES(1, 1, 2, 1, 0);
    data.flags = NURBS_NAN;
    nurbs_statistics *all = sum_of(none, data);
    CHECK_SAME(all, some);
    nurbs_statistics_destroy(all);
    data.weights = VALUES(1, 0x1p-54, 2, 0x1p-60, 0x1p-56); /* of 2, which are none */
    data.values = VALUES(1, 2, NAN, NAN, -8, 3, NAN, NAN, NAN, NAN);
    all = sum_of(none, data);
    CHECK_SAME(all, some);
    nurbs_statistics_destroy(none);
    nurbs_statistics_destroy(some);
    nurbs_statistics_destroy(all);
}

/* Outside, at both ends, and at a break. */
static void places(void) {
    nurbs_statistics *none = empty(), *a = NULL, *b = NULL;
    const double *values = VALUES(1, 2, 3, 4);
    nurbs_data data = data_of(1, 2, 2, VALUES(-INFINITY, 9), values);
    data.flags = NURBS_CLAMP;
    a = sum_of(none, data);
    b = sum_of(none, data_of(1, 2, 2, VALUES(0, 4), values));
    CHECK_SAME(a, b);
    nurbs_statistics_destroy(a);
    data.params = VALUES(-3, 9);
    data.flags = NURBS_WRAP;
    a = sum_of(none, data);
    nurbs_statistics_destroy(b);
    b = sum_of(none, data_of(1, 2, 2, VALUES(1, 1), values));
    CHECK_SAME(a, b);
    nurbs_statistics_destroy(a);
    data.params = VALUES(4, 8); /* the end is the start */
    a = sum_of(none, data);
    nurbs_statistics_destroy(b);
    b = sum_of(none, data_of(1, 2, 2, VALUES(0, 0), values));
    CHECK_SAME(a, b);
    nurbs_statistics_destroy(a);
    data.params = VALUES(1, 1); /* seen from the left in the first cell, which has data */
    data.flags = NURBS_LEFT;
    a = sum_of(b, data);
    CHECK_SIZE(a, 4, 1, 4);
    nurbs_statistics_destroy(a);
    data.flags = 0;
    a = sum_of(b, data);
    CHECK_SIZE(a, 4, 2, 4);
    nurbs_statistics_destroy(a);
    nurbs_statistics_destroy(b);
    nurbs_statistics_destroy(none);
}

/* Columns of a table and packed arrays are the same data. */
static void layouts(void) {
    static const double table[3][4] = {{0, 1, 3, 1}, {0.5, 2, 1, 2}, {3, 0, 5, 0.5}};
    static const double columns[] = {1, 2, 0, 9, 3, 1, 5};
    nurbs_statistics *none = empty(), *a = NULL, *b = NULL;
    nurbs_data data = data_of(1, 2, 3, VALUES(0, 0.5, 3), VALUES(1, 3, 2, 1, 0, 5));
    data.weights = VALUES(1, 2, 0.5);
    a = sum_of(none, data);
    data = data_of(1, 2, 3, table[0], table[0] + 1);
    data.weights = table[0] + 3;
    data.param_stride = data.value_stride = data.weight_stride = 4;
    b = sum_of(none, data);
    CHECK_SAME(a, b);
    nurbs_statistics_destroy(b);
    data.values = columns;
    data.value_stride = 1;
    data.value_component_stride = 4;
    b = sum_of(none, data);
    CHECK_SAME(a, b);
    nurbs_statistics_destroy(a);
    nurbs_statistics_destroy(b);
    nurbs_statistics_destroy(none);
}

typedef struct CreateArgs {
    int32_t axes;
    const int32_t *degrees;
    const int64_t *break_counts;
    const double *breaks;
    int64_t break_total;
    int32_t dim;
    double value_scale, weight_scale;
} CreateArgs;

static nurbs_status create_statistics(const CreateArgs *a, nurbs_statistics **out) {
    return nurbs_statistics_create(a->axes, a->degrees, a->break_counts, a->breaks, a->break_total, a->dim,
                                   a->value_scale, a->weight_scale, out);
}

#define CREATE_FAILS(change, status, words)                                                                  \
    do {                                                                                                     \
        nurbs_statistics *s_;                                                                                \
        CreateArgs a = {2, DEGREES(3, 1), COUNTS(2, 3), VALUES(0, 1, 2, 4, 5), 5, 1, 1, 1};                  \
        change;                                                                                              \
        CHECK_NO_STATISTICS(s_, create_statistics(&a, &s_), status, words);                                  \
    } while (0)

static void refused_forms(void) {
    CREATE_FAILS(a.axes = 0, NURBS_ERROR_AXES, "axes = 0");
    CREATE_FAILS(a.axes = 4, NURBS_ERROR_AXES, "axes = 4");
    CREATE_FAILS(a.degrees = NULL, NURBS_ERROR_NULL, "degrees");
    CREATE_FAILS(a.break_counts = NULL, NURBS_ERROR_NULL, "break_counts");
    CREATE_FAILS(a.breaks = NULL, NURBS_ERROR_NULL, "breaks");
    CREATE_FAILS(a.degrees = DEGREES(3, 32), NURBS_ERROR_DEGREE, "degrees[1] = 32");
    CREATE_FAILS(a.degrees = DEGREES(-1, 3), NURBS_ERROR_DEGREE, "degrees[0] = -1");
    CREATE_FAILS(a.break_counts = COUNTS(4, 1), NURBS_ERROR_COUNT, "break_counts[1] = 1|2");
    CREATE_FAILS(a.break_counts = COUNTS(-3, 8), NURBS_ERROR_COUNT, "break_counts[0] = -3");
    CREATE_FAILS(a.break_total = 4, NURBS_ERROR_SIZE, "break_total = 4|5");
    CREATE_FAILS(a.dim = 0, NURBS_ERROR_DIMENSION, "dim = 0");
    CREATE_FAILS(a.dim = INT32_MAX, NURBS_ERROR_DIMENSION, "dim = 2147483647");
    CREATE_FAILS(a.breaks = VALUES(0, 1, 2, NAN, 5), NURBS_ERROR_KNOT_NOT_FINITE, "breaks[3]|nan");
    CREATE_FAILS(a.breaks = VALUES(0, INFINITY, 2, 4, 5), NURBS_ERROR_KNOT_NOT_FINITE, "breaks[1]|inf");
    CREATE_FAILS(a.breaks = VALUES(0, 1, 2, 4, 4), NURBS_ERROR_KNOTS_DECREASING,
                 "breaks[4] = 4|breaks[3] = 4");
    CREATE_FAILS(a.breaks = VALUES(1, 0, 2, 4, 5), NURBS_ERROR_KNOTS_DECREASING,
                 "breaks[1] = 0|breaks[0] = 1");
    CREATE_FAILS(a.breaks = VALUES(-1e308, 1e308, 2, 4, 5), NURBS_ERROR_KNOT_NOT_FINITE, "");
    CREATE_FAILS(a.value_scale = 0, NURBS_ERROR_FACTOR, "value_scale = 0");
    CREATE_FAILS(a.value_scale = -1, NURBS_ERROR_FACTOR, "value_scale = -1");
    CREATE_FAILS(a.value_scale = NAN, NURBS_ERROR_FACTOR, "value_scale|nan");
    CREATE_FAILS(a.weight_scale = INFINITY, NURBS_ERROR_FACTOR, "weight_scale|inf");
    CREATE_FAILS(a.weight_scale = -0.0, NURBS_ERROR_FACTOR, "weight_scale");
    CREATE_FAILS(a.break_counts = COUNTS(INT64_MAX, 2), NURBS_ERROR_OVERFLOW, "breaks");
    CREATE_FAILS(a.break_counts = COUNTS(1 << 28, 1 << 28), NURBS_ERROR_OVERFLOW, "cells");
    CHECK_FAILS(nurbs_statistics_create(1, DEGREES(1), COUNTS(2), VALUES(0, 1), 2, 1, 1, 1, NULL),
                NURBS_ERROR_NULL, "out");
}

static void check_add_fails(const char *file, int line, nurbs_data data, nurbs_status status,
                            const char *words) {
    nurbs_statistics *s = empty(), *out = NULL;
    const nurbs_data before = data;
    const Bytes bytes = bytes_of(s);
    out = (nurbs_statistics *)(void *)check_before;
    check_forget();
    check_refusal(file, line, nurbs_statistics_add(s, &data, &out), status, words);
    check_true(file, line, out == NULL, "out == NULL");
    const Bytes after = bytes_of(s);
    check_bits(file, line, &before, &data, sizeof data);
    check_bits(file, line, &bytes, &after, sizeof bytes);
    nurbs_statistics_destroy(s);
}

#define ADD_FAILS(change, status, words)                                                                     \
    do {                                                                                                     \
        nurbs_data data = data_of(1, 2, 3, VALUES(0, 1, 4), VALUES(1, 2, 3, 4, 5, 6));                       \
        change;                                                                                              \
        check_add_fails(__FILE__, __LINE__, data, status, words);                                            \
    } while (0)

static void refused_layouts(void) {
    ADD_FAILS(data.struct_size = 90, NURBS_ERROR_OPTIONS, "data|struct_size = 90");
    ADD_FAILS(data.reserved = 1, NURBS_ERROR_OPTIONS, "data|reserved = 1");
    ADD_FAILS(data.axes = 0, NURBS_ERROR_AXES, "axes = 0");
    ADD_FAILS(data.axes = 2, NURBS_ERROR_AXES, "axes = 2|1");
    ADD_FAILS(data.n = -2, NURBS_ERROR_COUNT, "n = -2");
    ADD_FAILS(data.dim = -1, NURBS_ERROR_DIMENSION, "dim = -1");
    ADD_FAILS(data.dim = 3, NURBS_ERROR_DIMENSION, "dim = 3|2");
    ADD_FAILS(data.params = NULL, NURBS_ERROR_NULL, "params");
    ADD_FAILS(data.values = NULL, NURBS_ERROR_NULL, "values");
    ADD_FAILS(data.param_stride = -1, NURBS_ERROR_STRIDE, "params|-1");
    ADD_FAILS((data.value_stride = 1, data.value_component_stride = 1), NURBS_ERROR_STRIDE, "values|overlap");
    ADD_FAILS((data.weights = data.params, data.weight_stride = -1), NURBS_ERROR_STRIDE, "weights|-1");
    ADD_FAILS(data.param_stride = INT64_MAX, NURBS_ERROR_OVERFLOW, "params");
    ADD_FAILS((data.weights = data.params, data.weight_stride = INT64_C(1) << 60), NURBS_ERROR_OVERFLOW,
              "weights");
    ADD_FAILS(data.flags = NURBS_EXTRAPOLATE, NURBS_ERROR_FLAGS, "flags = 0x4|extrapolate");
    ADD_FAILS(data.flags = NURBS_WRAP | NURBS_CLAMP, NURBS_ERROR_FLAGS, "exclude");
    ADD_FAILS(data.flags = 0x80, NURBS_ERROR_FLAGS, "0x80|axis 0");
    ADD_FAILS(data.flags = NURBS_ON_AXIS(1, NURBS_NAN), NURBS_ERROR_FLAGS, "0x1000|1 axes");
    ADD_FAILS(data.flags = NURBS_NAN_POINTS, NURBS_ERROR_FLAGS, "0x1000000");
}

static void refused_numbers(void) {
    ADD_FAILS(data.params = VALUES(0, -INFINITY, 4), NURBS_ERROR_PARAMETER_NOT_FINITE, "params[1]|-inf");
    ADD_FAILS(data.params = VALUES(0, 1, 4.5), NURBS_ERROR_OUTSIDE_DOMAIN, "params[2]|4.5|[0, 4]");
    ADD_FAILS(data.values = VALUES(1, 2, 3, NAN, 5, 6), NURBS_ERROR_POINT_NOT_FINITE, "values[1][1]|nan");
    ADD_FAILS(data.values = VALUES(INFINITY, 2, 3, 4, 5, 6), NURBS_ERROR_POINT_NOT_FINITE,
              "values[0][0]|inf");
    ADD_FAILS(data.values = VALUES(1, 2, 3, 4, -8.5, 6), NURBS_ERROR_SCALE, "values[2][0] = -8.5|8");
    ADD_FAILS(data.weights = VALUES(1, INFINITY, 1), NURBS_ERROR_WEIGHT_NOT_FINITE, "weights[1]|inf");
    ADD_FAILS(data.weights = VALUES(1, 1, NAN), NURBS_ERROR_WEIGHT_NOT_FINITE, "weights[2]|nan");
    ADD_FAILS(data.weights = VALUES(-1, 1, 1), NURBS_ERROR_WEIGHT_NEGATIVE, "weights[0] = -1");
    ADD_FAILS(data.weights = VALUES(1, 2.5, 1), NURBS_ERROR_SCALE, "weights[1] = 2.5|2");
}

/* Nothing but the values 0 and 1 is refused where the scale is as large as it can be. */
static void extreme_scales(void) {
    nurbs_statistics *largest = NULL, *smallest = NULL, *s = NULL;
    nurbs_data data = data_of(1, 1, 2, VALUES(0, 1), VALUES(1.7e308, INFINITY));
    CHECK_OK(nurbs_statistics_create(1, DEGREES(1), COUNTS(2), VALUES(0, 1), 2, 1, 1.7e308, 1, &largest));
    CHECK_NO_STATISTICS(s, nurbs_statistics_add(largest, &data, &s), NURBS_ERROR_POINT_NOT_FINITE,
                        "values[1][0]|inf");
    CHECK_OK(
        nurbs_statistics_create(1, DEGREES(1), COUNTS(2), VALUES(0, 1), 2, 1, 5e-324, 5e-324, &smallest));
    data.values = VALUES(5e-324, -5e-324);
    data.weights = VALUES(5e-324, 5e-324);
    s = sum_of(smallest, data);
    double weight = -1;
    nurbs *g = NULL;
    CHECK_OK(nurbs_statistics_size(s, NULL, NULL, NULL, NULL, &weight));
    CHECK_DOUBLE(weight, 1e-323);
    CHECK_OK(nurbs_fit(s, DEGREES(1), COUNTS(2), VALUES(0, 0, 1, 1), 4, 0, NULL, NULL, &g));
    CHECK_POINTS(g, VALUES(5e-324, -5e-324));
    nurbs_destroy(g);
    nurbs_statistics_destroy(s);
    data.values = VALUES(1e-323, 0);
    CHECK_NO_STATISTICS(s, nurbs_statistics_add(smallest, &data, &s), NURBS_ERROR_SCALE, "values[0][0]");
    nurbs_statistics_destroy(largest);
    nurbs_statistics_destroy(smallest);
}

static void refused_handles(void) {
    const nurbs_data data = some_data();
    nurbs_statistics *s = empty(), *out = NULL;
    CHECK_NO_STATISTICS(out, nurbs_statistics_add(NULL, &data, &out), NURBS_ERROR_NULL, "statistics");
    CHECK_NO_STATISTICS(out, nurbs_statistics_add(s, NULL, &out), NURBS_ERROR_NULL, "data");
    CHECK_FAILS(nurbs_statistics_add(s, &data, NULL), NURBS_ERROR_NULL, "out");
    nurbs_statistics_destroy(s);
}

static void refused_sums(void) {
    nurbs_statistics *const a = part(0, 3), *const b = part(1, 4);
    nurbs_statistics *other = NULL, *out = NULL;
    const nurbs_statistics *const two[] = {a, b};
    CHECK_NO_STATISTICS(out, nurbs_statistics_merge(0, two, NULL, &out), NURBS_ERROR_COUNT, "count = 0|1");
    CHECK_NO_STATISTICS(out, nurbs_statistics_merge(-1, two, NULL, &out), NURBS_ERROR_COUNT, "count = -1");
    CHECK_NO_STATISTICS(out, nurbs_statistics_merge(2, NULL, NULL, &out), NURBS_ERROR_NULL, "parts");
    CHECK_NO_STATISTICS(out, nurbs_statistics_merge(2, (const nurbs_statistics *[]){a, NULL}, NULL, &out),
                        NURBS_ERROR_NULL, "parts[1]");
    CHECK_NO_STATISTICS(out, nurbs_statistics_merge(2, two, DEGREES(1, 2), &out), NURBS_ERROR_RULE,
                        "signs[1] = 2");
    CHECK_NO_STATISTICS(out, nurbs_statistics_merge(2, two, DEGREES(0, 1), &out), NURBS_ERROR_RULE,
                        "signs[0] = 0");
    CHECK_FAILS(nurbs_statistics_merge(2, two, NULL, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_STATISTICS(out, nurbs_statistics_merge(2, two, DEGREES(1, -1), &out), NURBS_ERROR_COUNT,
                        "subtracted|cell 2");
    CHECK_NO_STATISTICS(out, nurbs_statistics_merge(1, two, DEGREES(-1), &out), NURBS_ERROR_COUNT,
                        "subtracted|cell 0");
    other = part(1, 2);
    CHECK_NO_STATISTICS(
        out, nurbs_statistics_merge(2, (const nurbs_statistics *[]){other, b}, DEGREES(1, -1), &out),
        NURBS_ERROR_COUNT, "subtracted");
    nurbs_statistics_destroy(a);
    nurbs_statistics_destroy(b);
    nurbs_statistics_destroy(other);
}

/* Parts that differ from the first one in one thing. */
static void incompatible_parts(void) {
    const double *breaks = VALUES(0, 1, 2, 4);
    const CreateArgs others[] = {{1, DEGREES(2), COUNTS(4), breaks, 4, 2, 8, 2},
                                 {1, DEGREES(3), COUNTS(3), VALUES(0, 1, 4), 3, 2, 8, 2},
                                 {1, DEGREES(3), COUNTS(4), VALUES(0, 1, 3, 4), 4, 2, 8, 2},
                                 {1, DEGREES(3), COUNTS(4), breaks, 4, 1, 8, 2},
                                 {1, DEGREES(3), COUNTS(4), breaks, 4, 2, 16, 2},
                                 {1, DEGREES(3), COUNTS(4), breaks, 4, 2, 8, 1},
                                 {1, DEGREES(3), COUNTS(4), breaks, 4, 2, 5, 1.5}};
    nurbs_statistics *const a = part(0, 3), *b = NULL, *out = NULL;
    for (size_t i = 0; i < sizeof others / sizeof *others; ++i) {
        CHECK_OK(create_statistics(&others[i], &b));
        const nurbs_statistics *const parts[] = {a, a, b};
        if (i == 6) { /* scales are rounded up */
            CHECK_OK(nurbs_statistics_merge(3, parts, NULL, &out));
            nurbs_statistics_destroy(out);
        } else {
            CHECK_NO_STATISTICS(out, nurbs_statistics_merge(3, parts, NULL, &out), NURBS_ERROR_INCOMPATIBLE,
                                "parts[2]|differ");
        }
        nurbs_statistics_destroy(b);
    }
    nurbs_statistics_destroy(a);
}

/* Of statistics of degree 3 over [0, 1, 2, 4]: other degrees and knots. */
static void fits(void) {
    nurbs_statistics *none = empty(), *s = NULL;
    double params[20], values[40];
    nurbs *g = NULL;
    for (int i = 0; i < 20; ++i) {
        params[i] = i / 19.0 * 4;
        values[2 * i] = params[i];
        values[2 * i + 1] = 1 - params[i] / 2;
    }
    s = sum_of(none, data_of(1, 2, 20, params, values));
    CHECK_OK(nurbs_fit(s, DEGREES(1), COUNTS(3), VALUES(0, 0, 2, 4, 4), 5, 0, NULL, NULL, &g));
    CHECK_POINTS_NEAR(g, VALUES(0, 1, 2, 0, 4, -1), 1e-14);
    nurbs_destroy(g);
    CHECK_OK(nurbs_fit(s, DEGREES(2), COUNTS(4), VALUES(0, 0, 0, 1, 4, 4, 4), 7, 0, NULL, NULL, &g));
    CHECK_POINTS_NEAR(g, VALUES(0, 1, 0.5, 0.75, 2.5, -0.25, 4, -1), 1e-14);
    nurbs_destroy(g);
    CHECK_OK(nurbs_fit(s, DEGREES(0), COUNTS(1), VALUES(0, 4), 2, 0, NULL, NULL, &g));
    CHECK_POINTS_NEAR(g, VALUES(2, 0), 1e-14);
    nurbs_destroy(g);
    CHECK_OK(nurbs_fit(s, DEGREES(2), COUNTS(3), VALUES(-2, -1, 0, 4, 5, 7), 6, 0, NULL, NULL, &g));
    double ends[4];
    CHECK_OK(nurbs_eval(g, 2, VALUES(0, 4), 0, 0, ends, 0, 0, 0));
    CHECK_NEAR(ends, VALUES(0, 1, 4, -1), 4, 1e-13);
    nurbs_destroy(g);
    nurbs_statistics_destroy(none);
    nurbs_statistics_destroy(s);
}

static void refused_fits(void) {
    nurbs_statistics *s = part(0, 6);
    nurbs *g = NULL;
    CHECK_NO_HANDLE(g, nurbs_fit(NULL, DEGREES(1), COUNTS(2), VALUES(0, 0, 4, 4), 4, 0, NULL, NULL, &g),
                    NURBS_ERROR_NULL, "statistics");
    CHECK_NO_HANDLE(
        g, nurbs_fit(s, DEGREES(4), COUNTS(5), VALUES(0, 0, 0, 0, 0, 4, 4, 4, 4, 4), 10, 0, NULL, NULL, &g),
        NURBS_ERROR_DEGREE, "degrees[0] = 4|3");
    CHECK_NO_HANDLE(g, nurbs_fit(s, DEGREES(1), COUNTS(3), VALUES(0, 0, 3, 4, 4), 5, 0, NULL, NULL, &g),
                    NURBS_ERROR_NOT_A_KNOT, "axis 0|knot 2|3");
    CHECK_NO_HANDLE(g, nurbs_fit(s, DEGREES(1), COUNTS(2), VALUES(0, 0, 2, 2), 4, 0, NULL, NULL, &g),
                    NURBS_ERROR_OUTSIDE_DOMAIN, "axis 0|[0, 2]|[0, 4]");
    CHECK_NO_HANDLE(g, nurbs_fit(s, DEGREES(1), COUNTS(2), VALUES(-1, -1, 4, 4), 4, 0, NULL, NULL, &g),
                    NURBS_ERROR_OUTSIDE_DOMAIN, "axis 0|[-1, 4]|[0, 4]");
    CHECK_NO_HANDLE(g, nurbs_fit(s, DEGREES(0), COUNTS(3), VALUES(0, 1, 2, 4), 4, 0, NULL, NULL, &g),
                    NURBS_ERROR_RANK, "control point 1|[1, 2]"); /* a cell without data */
    nurbs_statistics_destroy(s);
}

static void watched_sums(void) {
    const ManyData many = many_data(200000);
    FitWatcher w = {0, 0, 0, 0};
    nurbs_call_options call = watched_by(&w, 0);
    nurbs_statistics *none = NULL, *plain = NULL, *s = NULL;
    const nurbs_data data = data_of(1, 1, many.n, many.params, many.values);
    CHECK_OK(nurbs_statistics_create(1, DEGREES(15), COUNTS(2), VALUES(0, 1), 2, 1, 2, 1, &none));
    CHECK_OK(nurbs_statistics_add(none, &data, &plain));
    CHECK_OK(nurbs_statistics_add_with(none, &data, &call, &s));
    CHECK_SAME(plain, s);
    CHECK(w.calls > 0 && w.wrong == 0);
    nurbs_statistics_destroy(s);
    CHECK_OK(nurbs_statistics_add_with(none, &data, NULL, &s));
    CHECK_SAME(plain, s);
    nurbs_statistics_destroy(s);
    w.answer = -3;
    w.calls = 0;
    w.last = 0;
    CHECK_NO_STATISTICS(s, nurbs_statistics_add_with(none, &data, &call, &s), NURBS_ERROR_CANCELLED,
                        "progress|-3");
    CHECK_INT(w.calls, 1);
    call = watched_by(NULL, 1000);
    CHECK_NO_STATISTICS(s, nurbs_statistics_add_with(none, &data, &call, &s), NURBS_ERROR_WORK,
                        "work = 1000");
    call.work = -1;
    CHECK_NO_STATISTICS(s, nurbs_statistics_add_with(none, &data, &call, &s), NURBS_ERROR_OPTIONS,
                        "call|work = -1");
    call.struct_size = 31;
    CHECK_NO_STATISTICS(s, nurbs_statistics_add_with(none, &data, &call, &s), NURBS_ERROR_OPTIONS,
                        "call|struct_size = 31");
    CHECK_NO_STATISTICS(s, nurbs_statistics_add_with(NULL, &data, NULL, &s), NURBS_ERROR_NULL, "statistics");
    nurbs_statistics_destroy(none);
    nurbs_statistics_destroy(plain);
    free_many(many);
}

int main(void) {
    sizes();
    sums();
    clones();
    data_left_out();
    places();
    layouts();
    refused_forms();
    refused_layouts();
    refused_numbers();
    extreme_scales();
    refused_handles();
    refused_sums();
    incompatible_parts();
    fits();
    refused_fits();
    watched_sums();
    return check_summary("statistics");
}
