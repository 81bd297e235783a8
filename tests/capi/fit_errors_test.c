/* SPDX-License-Identifier: MIT */
/* How sure fits are, and what factors of the penalty lead to. */
#include "fits.h"

/* Of the line through 0, 1, 2 the error is sqrt(1/3 + (t - 1)^2 / 2). */
static void a_line(void) {
    nurbs_statistics *s = statistics_of_line();
    FitArgs a = line();
    nurbs *g = fitted(&a);
    double errors[5];
    CHECK_OK(nurbs_fit_errors(s, g, 1, 0, 1, 4, VALUES(0, 0.5, 1, 2), 0, 0, 0, errors));
    CHECK_NEAR(errors, VALUES(sqrt(5 / 6.0), sqrt(11 / 24.0), sqrt(1 / 3.0), sqrt(5 / 6.0)), 4, 1e-15);
    CHECK_OK(nurbs_fit_errors_with(s, g, 1, 0, 2, 2, VALUES(0, 9, 1, 9), 2, 0, 0, errors, NULL));
    CHECK_NEAR(errors, VALUES(2 * sqrt(5 / 6.0), 2 * sqrt(1 / 3.0)), 2, 1e-15);
    CHECK_OK(nurbs_fit_errors(s, g, 1, 0, 1, 2, VALUES(-1, NAN), 0, 0, NURBS_CLAMP | NURBS_NAN, errors));
    CHECK_NEAR(errors, VALUES(sqrt(5 / 6.0)), 1, 1e-15);
    CHECK(isnan(errors[1]));
    CHECK_OK(nurbs_fit_errors(s, g, 1, 0, 0, 1, VALUES(1), 0, 0, 0, errors));
    CHECK_DOUBLE(errors[0], 0);
    CHECK_OK(nurbs_fit_errors(s, g, 1, 0, 1, 0, NULL, 0, 0, 0, NULL));
    /* A penalty for slopes without end leaves a constant. */
    CHECK_OK(nurbs_fit_errors(s, g, 1, 1e12, 1, 2, VALUES(0, 2), 0, 0, 0, errors));
    CHECK_NEAR(errors, VALUES(sqrt(1 / 3.0), sqrt(1 / 3.0)), 2, 1e-9);
    nurbs_destroy(g);
    nurbs_statistics_destroy(s);
}

/* lambda d^2, d = c_1 - c_0, beside (d - 1)^2 / 2 makes d = 1 / (1 + 2 lambda). */
static void criteria(void) {
    nurbs_statistics *s = statistics_of_line();
    FitArgs a = line();
    nurbs *g = fitted(&a);
    double values[8];
    CHECK_OK(nurbs_fit_criteria_with(s, g, 1, 2, VALUES(1, 0.25), values, NULL));
    for (int i = 0; i < 2; ++i) {
        const double lambda = i == 0 ? 1 : 0.25, d = 1 / (1 + 2 * lambda);
        const double squares = 1 / 6.0 + (1 - d) * (1 - d) / 2, freedom = 1 + d;
        const double reml = 2 * log(squares + lambda * d * d) + log(1.5 / d) - log(lambda);
        CHECK_NEAR(values + 4 * i,
                   VALUES(squares, freedom, 3 * squares / (3 - freedom) / (3 - freedom), reml), 4, 1e-14);
    }
    CHECK_OK(nurbs_fit_criteria(s, g, 1, 0, NULL, NULL));
    nurbs_destroy(g);
    nurbs_statistics_destroy(s);
}

/* What is smallest among them is what the criterion finds. */
static void the_best(void) {
    ManyData many = many_data(400);
    nurbs_data data = data_of(1, 1, many.n, many.params, many.values);
    nurbs_statistics *none = NULL, *s = NULL;
    double breaks[33], knots[39], found[12];
    const int64_t count = 35;
    for (int i = 0; i <= 32; ++i) {
        breaks[i] = knots[i + 3] = i / 32.0;
    }
    for (int i = 0; i < 3; ++i) {
        knots[i] = 0;
        knots[36 + i] = 1;
    }
    CHECK_OK(nurbs_statistics_create(1, DEGREES(3), COUNTS(33), breaks, 33, 1, 2, 1, &none));
    CHECK_OK(nurbs_statistics_add(none, &data, &s));
    for (int32_t rule = NURBS_SMOOTHING_GCV; rule <= NURBS_SMOOTHING_REML; ++rule) {
        const int column = rule == NURBS_SMOOTHING_GCV ? 2 : 3;
        nurbs_fit_options options = fit_defaults();
        nurbs_fit_report report = unwritten_report();
        nurbs *g = NULL;
        options.smoothing = rule;
        CHECK_OK(nurbs_fit(s, DEGREES(3), &count, knots, 39, 0, &options, &report, &g));
        CHECK_OK(nurbs_fit_criteria(s, g, 2, 3,
                                    VALUES(report.lambda, 1.2 * report.lambda, report.lambda / 1.2), found));
        CHECK(found[column] < found[4 + column] && found[column] < found[8 + column]);
        CHECK_NEAR(found, VALUES(report.squares, report.freedom), 2, 1e-9);
        nurbs_destroy(g);
    }
    nurbs_statistics_destroy(none);
    nurbs_statistics_destroy(s);
    free_many(many);
}

typedef struct ErrorArgs {
    const nurbs_statistics *statistics;
    const nurbs *g;
    int32_t order;
    double lambda, sigma;
    int64_t n;
    const double *params;
    int64_t stride;
    uint32_t flags;
} ErrorArgs;

static void check_refused(const char *file, int line, ErrorArgs a, nurbs_status status, const char *words) {
    double errors[4] = {7, 7, 7, 7};
    check_forget();
    check_refusal(file, line,
                  nurbs_fit_errors(a.statistics, a.g, a.order, a.lambda, a.sigma, a.n, a.params, a.stride, 0,
                                   a.flags, errors),
                  status, words);
    check_doubles(file, line, errors, VALUES(7, 7, 7, 7), 4, 0);
}
#define FAILS(change, status, words)                                                                         \
    do {                                                                                                     \
        ErrorArgs a = {s, g, 1, 1, 1, 2, VALUES(0, 1), 0, 0};                                                \
        change;                                                                                              \
        check_refused(__FILE__, __LINE__, a, status, words);                                                 \
    } while (0)
#define CRITERIA_FAIL(s, g, order, n, lambdas, values, status, words)                                        \
    CHECK_FAILS(nurbs_fit_criteria(s, g, order, n, lambdas, values), status, words)

static void refused(void) {
    nurbs_statistics *s = statistics_of_line(), *none = NULL;
    FitArgs line_args = line();
    nurbs *g = fitted(&line_args), *other = NULL, *surface = NULL;
    double values[4] = {7, 7, 7, 7};
    CHECK_OK(nurbs_statistics_create(1, DEGREES(1), COUNTS(2), VALUES(0, 2), 2, 1, 1, 1, &none));
    CHECK_OK(nurbs_create(1, DEGREES(1), COUNTS(2), VALUES(0, 0, 3, 3), 4, 1, VALUES(0, 1), 0, 0, NULL, 0, 0,
                          &other));
    CHECK_OK(nurbs_create(2, DEGREES(1, 1), COUNTS(2, 2), VALUES(0, 0, 1, 1, 0, 0, 1, 1), 8, 1,
                          VALUES(0, 1, 2, 3), 0, 0, NULL, 0, 0, &surface));
    FAILS(a.statistics = NULL, NURBS_ERROR_NULL, "statistics");
    FAILS(a.g = NULL, NURBS_ERROR_NULL, "g");
    FAILS(a.g = surface, NURBS_ERROR_AXES, "2 axes|1");
    FAILS(a.g = other, NURBS_ERROR_OUTSIDE_DOMAIN, "3");
    FAILS(a.order = 0, NURBS_ERROR_ORDER, "penalty_order = 0|1");
    FAILS(a.order = 2, NURBS_ERROR_ORDER, "penalty_order = 2|1");
    FAILS(a.lambda = -1, NURBS_ERROR_FACTOR, "lambda = -1");
    FAILS(a.lambda = NAN, NURBS_ERROR_FACTOR, "lambda = nan");
    FAILS(a.sigma = -1, NURBS_ERROR_FACTOR, "sigma = -1");
    FAILS(a.sigma = INFINITY, NURBS_ERROR_FACTOR, "sigma = inf");
    FAILS(a.n = -1, NURBS_ERROR_COUNT, "-1");
    FAILS(a.params = NULL, NURBS_ERROR_NULL, "params");
    FAILS(a.params = VALUES(0, 2.5), NURBS_ERROR_OUTSIDE_DOMAIN, "params[1]|2.5");
    FAILS(a.params = VALUES(NAN, 0), NURBS_ERROR_PARAMETER_NOT_FINITE, "params[0]|nan");
    FAILS(a.stride = -1, NURBS_ERROR_STRIDE, "params|-1");
    FAILS(a.flags = NURBS_EXTRAPOLATE, NURBS_ERROR_FLAGS, "extrapolate");
    FAILS((a.statistics = none, a.lambda = 0), NURBS_ERROR_RANK, "control point");
    CHECK_FAILS(nurbs_fit_errors(s, g, 1, 0, 1, 1, VALUES(0), 0, 0, 0, NULL), NURBS_ERROR_NULL, "errors");
    CHECK_FAILS(nurbs_fit_errors(s, g, 1, 0, 1, 2, values, 0, 0, 0, values + 1), NURBS_ERROR_OVERLAP,
                "errors|params");
    CRITERIA_FAIL(NULL, g, 1, 1, VALUES(1), values, NURBS_ERROR_NULL, "statistics");
    CRITERIA_FAIL(s, NULL, 1, 1, VALUES(1), values, NURBS_ERROR_NULL, "g");
    CRITERIA_FAIL(s, surface, 1, 1, VALUES(1), values, NURBS_ERROR_AXES, "2 axes|1");
    CRITERIA_FAIL(s, other, 1, 1, VALUES(1), values, NURBS_ERROR_OUTSIDE_DOMAIN, "3");
    CRITERIA_FAIL(s, g, 2, 1, VALUES(1), values, NURBS_ERROR_ORDER, "penalty_order = 2|1");
    CRITERIA_FAIL(s, g, 1, -1, VALUES(1), values, NURBS_ERROR_COUNT, "-1");
    CRITERIA_FAIL(s, g, 1, 1, NULL, values, NURBS_ERROR_NULL, "lambdas");
    CRITERIA_FAIL(s, g, 1, 1, VALUES(1), NULL, NURBS_ERROR_NULL, "values");
    CRITERIA_FAIL(s, g, 1, 2, VALUES(1, 0), values, NURBS_ERROR_FACTOR, "lambdas[1] = 0");
    CRITERIA_FAIL(s, g, 1, 1, VALUES(INFINITY), values, NURBS_ERROR_FACTOR, "lambdas[0] = inf");
    CRITERIA_FAIL(s, g, 1, 1, values, values, NURBS_ERROR_OVERLAP, "values|lambdas");
    CHECK_NEAR(values, VALUES(7, 7, 7, 7), 4, 0);
    nurbs_destroy(g);
    nurbs_destroy(other);
    nurbs_destroy(surface);
    nurbs_statistics_destroy(s);
    nurbs_statistics_destroy(none);
}

/* Calls that end early write nothing. */
static void watched(void) {
    nurbs_statistics *s = statistics_of_line();
    FitArgs a = line();
    nurbs *g = fitted(&a);
    double params[64], out[64];
    for (int i = 0; i < 64; ++i) {
        params[i] = i / 32.0;
        out[i] = 7;
    }
    nurbs_call_options call = watched_by(NULL, 1);
    CHECK_FAILS(nurbs_fit_errors_with(s, g, 1, 0, 1, 64, params, 0, 0, 0, out, &call), NURBS_ERROR_WORK,
                "work");
    CHECK_FAILS(nurbs_fit_criteria_with(s, g, 1, 1, VALUES(1), out, &call), NURBS_ERROR_WORK, "work");
    for (int i = 0; i < 64; ++i) {
        CHECK_DOUBLE(out[i], 7);
    }
    call.work = 0;
    call.struct_size = 1;
    CHECK_FAILS(nurbs_fit_criteria_with(s, g, 1, 1, VALUES(1), out, &call), NURBS_ERROR_OPTIONS, "call");
    nurbs_destroy(g);
    nurbs_statistics_destroy(s);
}

int main(void) {
    a_line();
    criteria();
    the_best();
    refused();
    watched();
    return check_summary("fit_errors");
}
