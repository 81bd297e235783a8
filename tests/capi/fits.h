/* SPDX-License-Identifier: MIT */
/* Arguments of fits, so that a test can change one field at a time. */
#ifndef NURBS_TESTS_CAPI_FITS_H
#define NURBS_TESTS_CAPI_FITS_H

#include "check.h"
#include "shapes.h"

#define VALUES(...) ((const double[]){__VA_ARGS__})
#define COUNTS(...) ((const int64_t[]){__VA_ARGS__})
#define DEGREES(...) ((const int32_t[]){__VA_ARGS__})

static inline nurbs_data data_of(int32_t axes, int32_t dim, int64_t n, const double *params,
                                 const double *values) {
    nurbs_data data;
    CHECK_OK(nurbs_data_init(&data, sizeof data));
    data.axes = axes;
    data.dim = dim;
    data.n = n;
    data.params = params;
    data.values = values;
    return data;
}

static inline nurbs_fit_options fit_defaults(void) {
    nurbs_fit_options options;
    CHECK_OK(nurbs_fit_options_init(&options, sizeof options));
    return options;
}

static inline nurbs_fit_report unwritten_report(void) {
    nurbs_fit_report report;
    memset(&report, 0x5a, sizeof report);
    report.struct_size = sizeof report;
    return report;
}

/* What nurbs_fit_points() and nurbs_fit() take. */
typedef struct FitArgs {
    nurbs_data data;
    int without_data; /* NULL in its place */
    const int32_t *degrees;
    const int64_t *counts;
    const double *knots;
    int64_t knot_count;
    uint32_t flags;
    nurbs_fit_options options;
    nurbs_fit_report report;
} FitArgs;

/* Of statistics, or of the data if they are NULL. */
static inline nurbs_status fit_of(FitArgs *a, const nurbs_statistics *statistics,
                                  const nurbs_call_options *call, nurbs **out) {
    return statistics != NULL
               ? nurbs_fit_with(statistics, a->degrees, a->counts, a->knots, a->knot_count, a->flags,
                                &a->options, &a->report, call, out)
               : nurbs_fit_points_with(a->without_data ? NULL : &a->data, a->degrees, a->counts, a->knots,
                                       a->knot_count, a->flags, &a->options, &a->report, call, out);
}

/* The call fails, writes nothing, and changes none of its arguments. */
static inline void check_fit_fails(const char *file, int line, FitArgs a, const nurbs_statistics *statistics,
                                   nurbs_status status, const char *words) {
    FitArgs before;
    nurbs *out = check_poison();
    memcpy(&before, &a, sizeof a);
    check_forget();
    check_refusal(file, line, fit_of(&a, statistics, NULL, &out), status, words);
    check_true(file, line, out == NULL, "out == NULL");
    check_true(file, line, memcmp(&before, &a, sizeof a) == 0, "the arguments are what they were");
}

/* A fit that works. */
static inline nurbs *fitted(FitArgs *a) {
    nurbs *out = NULL;
    CHECK_OK(fit_of(a, NULL, NULL, &out));
    return out;
}

/* The line closest to 0, 1, 1 at 0, 1, 2: it misses them by -1/6, 1/3, -1/6. */
static inline FitArgs line(void) {
    static const double params[] = {0, 1, 2}, values[] = {0, 1, 1}, knots[] = {0, 0, 2, 2};
    static const int32_t degree = 1;
    static const int64_t count = 2;
    FitArgs a;
    memset(&a, 0, sizeof a);
    a.data = data_of(1, 1, 3, params, values);
    a.degrees = &degree;
    a.counts = &count;
    a.knots = knots;
    a.knot_count = 4;
    a.options = fit_defaults();
    a.report = unwritten_report();
    return a;
}

static inline nurbs_statistics *statistics_of_line(void) {
    const FitArgs a = line();
    nurbs_statistics *none = NULL, *all = NULL;
    CHECK_OK(nurbs_statistics_create(1, a.degrees, COUNTS(2), VALUES(0, 2), 2, 1, 1, 1, &none));
    CHECK_OK(nurbs_statistics_add(none, &a.data, &all));
    nurbs_statistics_destroy(none);
    return all;
}

/* What nurbs_fit_tolerance() takes. */
typedef struct ToleranceArgs {
    nurbs_data data;
    int without_data; /* NULL in its place */
    const int32_t *degrees;
    const double *domain;
    double tolerance;
    int64_t max_count;
    uint32_t flags;
    nurbs_fit_options options;
    nurbs_fit_report report;
} ToleranceArgs;

static inline nurbs_status tolerance_fit(ToleranceArgs *a, const nurbs_call_options *call, nurbs **out) {
    return nurbs_fit_tolerance_with(a->without_data ? NULL : &a->data, a->degrees, a->domain, a->tolerance,
                                    a->max_count, a->flags, &a->options, &a->report, call, out);
}

/* With cubics. */
static inline ToleranceArgs tolerance_args(nurbs_data data, double tolerance) {
    static const int32_t cubic[] = {3, 3, 3};
    ToleranceArgs a;
    memset(&a, 0, sizeof a);
    a.data = data;
    a.degrees = cubic;
    a.tolerance = tolerance;
    a.options = fit_defaults();
    a.report = unwritten_report();
    return a;
}

/* As CHECK_NO_HANDLE, for statistics. */
#define CHECK_NO_STATISTICS(out, call, status, words)                                                        \
    do {                                                                                                     \
        (out) = (nurbs_statistics *)(void *)check_before;                                                    \
        CHECK_FAILS(call, status, words);                                                                    \
        check_true(__FILE__, __LINE__, (out) == NULL, #out " == NULL");                                      \
    } while (0)

/* Whoever watches a call, and may end it. */
typedef struct FitWatcher {
    int calls, wrong;
    int32_t answer;
    double last;
} FitWatcher;

static inline int32_t watch_fit(double done, void *user) {
    FitWatcher *w = (FitWatcher *)user;
    w->wrong += !(done >= w->last && done >= 0 && done <= 1);
    w->last = done;
    ++w->calls;
    return w->answer;
}

static inline nurbs_call_options watched_by(FitWatcher *w, int64_t work) {
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.work = work;
    call.progress = w == NULL ? NULL : watch_fit;
    call.user = w;
    return call;
}

/* Enough data to take a while: a wave with a little noise, at parameters from 0 to 1. */
typedef struct ManyData {
    int64_t n;
    double *params, *values;
} ManyData;

static inline ManyData many_data(int64_t n) {
    ManyData many = {n, (double *)malloc((size_t)n * sizeof(double)),
                     (double *)malloc((size_t)n * sizeof(double))};
    for (int64_t i = 0; i < n; ++i) {
        many.params[i] = (double)i / (double)(n - 1);
        many.values[i] = sin(40 * many.params[i]) + 1e-3 * (double)(i * 7919 % 1000) / 1000;
    }
    return many;
}

static inline void free_many(ManyData many) {
    free(many.params);
    free(many.values);
}

#endif
