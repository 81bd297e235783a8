/* SPDX-License-Identifier: MIT */
/* Fits that are smooth, keep conditions, or are one of several. */
#include "fits.h"

/* A cubic over two spans, of 16 data. */
static FitArgs cubic(void) {
    static double params[16], values[16];
    static const double knots[] = {0, 0, 0, 0, 0.5, 1, 1, 1, 1};
    static const int32_t degree = 3;
    static const int64_t count = 5;
    FitArgs a = line();
    for (int i = 0; i < 16; ++i) {
        params[i] = i / 15.0;
        values[i] = sin(5 * params[i]) + 0.125 * (i % 3);
    }
    a.data = data_of(1, 1, 16, params, values);
    a.degrees = &degree;
    a.counts = &count;
    a.knots = knots;
    a.knot_count = 9;
    return a;
}

#define NEAR(actual, expected) CHECK_NEAR(&(actual), VALUES(expected), 1, 1e-14)

/* lambda (c_1 - c_0)^2 with lambda 1/2 halves the slope of the line. */
static void a_penalty(void) {
    FitArgs a = line();
    a.options.smoothing = NURBS_SMOOTHING_LAMBDA;
    a.options.penalty_order = 1;
    a.options.lambda = 0.5;
    nurbs *g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(5 / 12.0, 11 / 12.0), 1e-15);
    CHECK_DOUBLE(a.report.lambda, 0.5);
    NEAR(a.report.freedom, 1.5);
    NEAR(a.report.squares, 1 / 6.0 + 1 / 8.0);
    NEAR(a.report.sigma, sqrt((1 / 6.0 + 1 / 8.0) / 1.5));
    nurbs_destroy(g);
}

/* What is found by a criterion is the fit with the lambda that is told. */
static void criteria(void) {
    for (int32_t rule = NURBS_SMOOTHING_GCV; rule <= NURBS_SMOOTHING_DISCREPANCY; ++rule) {
        FitArgs a = cubic();
        double points[5];
        a.options.smoothing = rule;
        a.options.target = 0.25;
        nurbs *g = fitted(&a);
        CHECK_OK(nurbs_points(g, 5, points, 0, 0));
        CHECK(a.report.lambda > 0 && a.report.freedom > 2 && a.report.freedom < 5);
        CHECK_INT(a.report.bits, 0);
        nurbs_destroy(g);
        a.options.smoothing = NURBS_SMOOTHING_LAMBDA;
        a.options.lambda = a.report.lambda;
        g = fitted(&a);
        CHECK_POINTS_NEAR(g, points, 1e-12);
        nurbs_destroy(g);
    }
}

static void targets(void) {
    FitArgs a = line();
    a.options.smoothing = NURBS_SMOOTHING_DISCREPANCY;
    a.options.penalty_order = 1;
    a.options.target = 0.2;
    nurbs_destroy(fitted(&a));
    CHECK(a.report.squares <= 0.2 && a.report.squares >= 0.2 * (1 - 1e-6));
    CHECK_INT(a.report.bits, 0);
    a.options.target = 0.125; /* below what the line misses */
    nurbs_destroy(fitted(&a));
    CHECK_INT(a.report.bits, NURBS_FIT_TARGET_MISSED);
    CHECK(a.report.squares > 0.125 && a.report.squares < 0.17);
    a.options.target = 100;
    nurbs_destroy(fitted(&a));
    CHECK_INT(a.report.bits, 0);
    CHECK_NEAR(&a.report.squares, VALUES(2 / 3.0), 1, 1e-3);
}

/* Values, slopes and second derivatives that have to hold, which are no parameters any more. */
static void conditions(void) {
    static const double at[] = {0, 0.25, 1, 1, 0}, targets[] = {2, -1, 0, 3, 2};
    static const int32_t orders[] = {0, 0, 1, 2, 0};
    FitArgs a = cubic();
    double ends[6];
    a.options.conditions = 5; /* the last one is the first one again */
    a.options.condition_params = at;
    a.options.condition_orders = orders;
    a.options.condition_targets = targets;
    nurbs *g = fitted(&a);
    CHECK_OK(nurbs_eval_derivs(g, 2, 2, VALUES(0.25, 1), 0, 0, ends, 0, 0, 0));
    CHECK_NEAR(ends, VALUES(-1), 1, 1e-14);
    CHECK_NEAR(ends + 4, VALUES(0, 3), 2, 1e-12);
    CHECK_OK(nurbs_eval(g, 1, VALUES(0), 0, 0, ends, 0, 0, 0));
    CHECK_NEAR(ends, VALUES(2), 1, 1e-14);
    NEAR(a.report.freedom, 1);
    const double sigma = sqrt(a.report.squares / (16 - 1));
    NEAR(a.report.sigma, sigma);
    nurbs_destroy(g);
    a.options.condition_orders = NULL;
    a.options.conditions = 2;
    g = fitted(&a);
    CHECK_OK(nurbs_eval(g, 2, at, 0, 0, ends, 0, 0, 0));
    CHECK_NEAR(ends, targets, 2, 1e-14);
    nurbs_destroy(g);
}

/* The trace of what the fitted values at the data are of the data. */
static double influence(FitArgs a) {
    double values[16], at[16], trace = 0;
    for (int i = 0; i < 16; ++i) {
        memset(values, 0, sizeof values);
        values[i] = 1;
        a.data.values = values;
        nurbs *g = fitted(&a);
        CHECK_OK(nurbs_eval(g, 16, a.data.params, 0, 0, at, 0, 0, 0));
        trace += at[i];
        nurbs_destroy(g);
    }
    return trace;
}

static void freedom(void) {
    for (int i = 0; i < 4; ++i) {
        FitArgs a = cubic();
        a.options.smoothing = i % 2 == 0 ? NURBS_SMOOTHING_NONE : NURBS_SMOOTHING_LAMBDA;
        a.options.lambda = 1e-3;
        a.options.conditions = i / 2;
        a.options.condition_params = VALUES(0);
        a.options.condition_targets = VALUES(0);
        nurbs_destroy(fitted(&a));
        const double trace = influence(a);
        CHECK_NEAR(&a.report.freedom, &trace, 1, 1e-9);
    }
}

/* A cubic needs no data for the control points that a penalty finds. */
static void several_fits(void) {
    FitArgs a = cubic();
    a.data.n = 2;
    a.data.params = VALUES(0.25, 0.5);
    a.data.values = VALUES(1, 2);
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_RANK, "control point");
    a.options.regularize = 1;
    nurbs *g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(0, 2 / 3.0, 2, 10 / 3.0, 4), 1e-9);
    CHECK_DOUBLE(a.report.freedom, 2);
    CHECK(a.report.largest <= 1e-14 && a.report.squares <= 1e-28);
    nurbs_destroy(g);
    a.data.n = 0;
    g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(0, 0, 0, 0, 0), 0);
    CHECK_INT(a.report.data_count, 0);
    CHECK_DOUBLE(a.report.weight, 0);
    CHECK_DOUBLE(a.report.largest, 0);
    CHECK_INT(a.report.largest_index, -1);
    nurbs_destroy(g);
    a.data = data_of(1, 1, 1, VALUES(0.5), VALUES(2));
    a.options.smoothing = NURBS_SMOOTHING_LAMBDA; /* and a penalty that leaves lines open */
    a.options.lambda = 1;
    g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(2, 2, 2, 2, 2), 1e-9);
    nurbs_destroy(g);
}

/* Some spans have no data, or all data are at one place. */
static void regularized(void) {
    FitArgs a = cubic();
    a.options.regularize = 1;
    a.knots = VALUES(0, 0, 0, 0, 1 / 3.0, 2 / 3.0, 1, 1, 1, 1);
    a.knot_count = 10;
    a.counts = COUNTS(6);
    a.data = data_of(1, 1, 3, VALUES(0.5, 0.5, 0.5), VALUES(1, 1, 4));
    nurbs *g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(2, 2, 2, 2, 2, 2), 1e-9);
    CHECK_NEAR(&a.report.freedom, VALUES(1), 1, 1e-6);
    nurbs_destroy(g);
    a.options.penalty_order = 3;
    a.data = data_of(1, 1, 2, VALUES(0.125, 0.25), VALUES(1, 2));
    g = NULL;
    CHECK_OK(fit_of(&a, NULL, NULL, &g));
    CHECK_NEAR(&a.report.freedom, VALUES(2), 1, 1e-6);
    nurbs_destroy(g);
}

/* Three data do not determine four control points, wherever they are. */
static void too_few_data(void) {
    int accepted = 0;
    for (int i = 1; i < 200; ++i) {
        const double at[] = {fmod(i * 0.6180339887498949, 1), fmod(i * 0.41421356237, 1),
                             fmod(i * 0.7320508, 1)};
        FitArgs a = cubic();
        nurbs *g = NULL;
        a.counts = COUNTS(4);
        a.knots = VALUES(0, 0, 0, 0, 1, 1, 1, 1);
        a.knot_count = 8;
        a.data = data_of(1, 1, 3, at, VALUES(1, 2, 0));
        accepted += fit_of(&a, NULL, NULL, &g) != NURBS_ERROR_RANK;
        nurbs_destroy(g);
    }
    CHECK_INT(accepted, 0);
}

int main(void) {
    a_penalty();
    criteria();
    targets();
    conditions();
    freedom();
    several_fits();
    regularized();
    too_few_data();
    return check_summary("fit_options");
}
