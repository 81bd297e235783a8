/* SPDX-License-Identifier: MIT */
/* Fits that outliers do not pull along. */
#include "fits.h"

/* The line 1 + t at 0, ..., 20, but for a datum that is 100 off. */
static FitArgs spoilt(double *params, double *values) {
    FitArgs a = line();
    for (int i = 0; i <= 20; ++i) {
        params[i] = 0.1 * i;
        values[i] = 1 + params[i] + (i == 7 ? 100 : 0);
    }
    a.data = data_of(1, 1, 21, params, values);
    return a;
}

/* What all data but one agree in is found exactly, or nearly. */
static void one_outlier(void) {
    double params[21], values[21];
    FitArgs a = spoilt(params, values);
    nurbs *g = fitted(&a);
    double points[2];
    CHECK_OK(nurbs_points(g, 2, points, 0, 0));
    CHECK(points[0] > 3);
    CHECK_INT(a.report.outliers, 0);
    CHECK_INT(a.report.rounds, 1);
    nurbs_destroy(g);
    for (int32_t rule = NURBS_ROBUST_HUBER; rule <= NURBS_ROBUST_TUKEY; ++rule) {
        a.options.robust = rule;
        g = fitted(&a);
        CHECK_POINTS_NEAR(g, VALUES(1, 3), rule == NURBS_ROBUST_HUBER ? 1e-9 : 1e-14);
        CHECK_INT(a.report.outliers, 1);
        CHECK_INT(a.report.data_count, 21);
        CHECK_INT(a.report.largest_index, 7);
        CHECK_NEAR(&a.report.largest, VALUES(100), 1, 1e-8);
        CHECK_NEAR(&a.report.weight, VALUES(21), 1, 1e-12);
        CHECK(a.report.rounds > 1 && a.report.sigma >= 0 && a.report.sigma < 1e-8);
        nurbs_destroy(g);
    }
}

/* Huber's estimate of a constant for 0, 0, 0, 0, 1, -1, ..., with a width: the mean of values cut off at width sigma. */
static void a_location(void) {
    FitArgs a = line();
    a.data = data_of(1, 1, 6, VALUES(0, 0.25, 0.75, 1, 1.5, 2), VALUES(-2, -1, 0, 1, 2, 12));
    a.degrees = DEGREES(0);
    a.counts = COUNTS(1);
    a.knots = VALUES(0, 2);
    a.knot_count = 2;
    a.options.robust = NURBS_ROBUST_HUBER;
    a.options.robust_width = 1;
    nurbs *g = fitted(&a);
    double m;
    CHECK_OK(nurbs_points(g, 1, &m, 0, 0));
    double sum = 0;
    for (int i = 0; i < 6; ++i) {
        const double r = a.data.values[i] - m;
        sum += r > a.report.sigma ? a.report.sigma : r < -a.report.sigma ? -a.report.sigma : r;
    }
    CHECK_NEAR(&sum, VALUES(0), 1, 1e-5);
    CHECK(a.report.outliers >= 1);
    nurbs_destroy(g);
}

/* Data that do not count, weights, and data that all agree. */
static void awkward(void) {
    double params[21], values[21], weights[21];
    FitArgs a = spoilt(params, values);
    for (int i = 0; i <= 20; ++i) {
        weights[i] = 1 + i % 3;
    }
    weights[20] = 0;
    values[20] = NAN;
    params[3] = 17;
    a.data.weights = weights;
    a.data.flags = NURBS_NAN;
    a.options.robust = NURBS_ROBUST_TUKEY;
    nurbs *g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(1, 3), 1e-13);
    CHECK_INT(a.report.data_count, 19);
    CHECK_INT(a.report.outliers, 1);
    nurbs_destroy(g);
    a = line();
    a.data.values = VALUES(1, 2, 3);
    a.options.robust = NURBS_ROBUST_HUBER;
    g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(1, 3), 1e-15);
    CHECK_INT(a.report.bits, 0);
    nurbs_destroy(g);
    a.data.values = VALUES(0, 0, 0);
    g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(0, 0), 0);
    CHECK_DOUBLE(a.report.sigma, 0);
    nurbs_destroy(g);
}

/* A number that stands for none, however large, takes nothing from the others. */
static void sentinels(void) {
    static const double large[] = {1e6, 1e15, 1e30, 1e300};
    double params[21], values[21];
    for (int i = 0; i < 4; ++i) {
        FitArgs a = spoilt(params, values);
        for (int k = 0; k <= 20; ++k) {
            values[k] += k == 7 ? 0 : 0.01 * (k % 3 - 1);
        }
        values[15] = large[i];
        a.options.robust = NURBS_ROBUST_TUKEY;
        nurbs *g = fitted(&a);
        CHECK_POINTS_NEAR(g, VALUES(1, 3), 0.02);
        CHECK_INT(a.report.outliers, 2);
        CHECK(a.report.sigma < 0.03);
        nurbs_destroy(g);
    }
}

/* Where only outliers determine a control point, they do, and the fit is Huber's. */
static void only_outliers(void) {
    double params[40], values[40];
    FitArgs a = line();
    for (int i = 0; i < 40; ++i) {
        params[i] = i < 38 ? i / 37.0 : 2;
        values[i] = i < 38 ? 0.01 * (i % 2) : i == 38 ? 50 : -50;
    }
    a.data = data_of(1, 1, 40, params, values);
    a.counts = COUNTS(3);
    a.knots = VALUES(0, 0, 1, 2, 2);
    a.knot_count = 5;
    a.options.robust = NURBS_ROBUST_HUBER;
    nurbs *huber = fitted(&a), *tukey = NULL;
    double points[3];
    CHECK_OK(nurbs_points(huber, 3, points, 0, 0));
    CHECK(fabs(points[0]) < 0.1 && fabs(points[2]) < 50);
    a.options.robust = NURBS_ROBUST_TUKEY;
    tukey = fitted(&a);
    CHECK_POINTS_NEAR(tukey, points, 0);
    CHECK_INT(a.report.bits, NURBS_FIT_NOT_CONVERGED);
    nurbs_destroy(huber);
    nurbs_destroy(tukey);
}

static void refused(void) {
    FitArgs a = line();
    a.options.robust = 3;
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_RULE, "robust = 3");
    a.options.robust = -1;
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_RULE, "robust = -1");
    a.options.robust = NURBS_ROBUST_HUBER;
    a.options.robust_width = -1;
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_FACTOR, "robust_width = -1");
    a.options.robust_width = NAN;
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_FACTOR, "robust_width = nan");
    a.options.robust_width = 0;
    nurbs_statistics *s = statistics_of_line();
    check_fit_fails(__FILE__, __LINE__, a, s, NURBS_ERROR_RULE, "robust = 1|data");
    nurbs_statistics_destroy(s);
    ToleranceArgs t = tolerance_args(a.data, 0.1);
    t.options.robust = NURBS_ROBUST_TUKEY;
    nurbs *g = NULL;
    CHECK_NO_HANDLE(g, tolerance_fit(&t, NULL, &g), NURBS_ERROR_RULE, "robust = 2|tolerance");
}

static void watched(void) {
    ManyData many = many_data(20000);
    FitArgs a = line();
    a.data = data_of(1, 1, many.n, many.params, many.values);
    a.options.robust = NURBS_ROBUST_TUKEY;
    nurbs *g = NULL;
    nurbs_call_options call = watched_by(NULL, 1000);
    CHECK_NO_HANDLE(g, fit_of(&a, NULL, &call, &g), NURBS_ERROR_WORK, "work");
    free_many(many);
}

int main(void) {
    one_outlier();
    a_location();
    awkward();
    sentinels();
    only_outliers();
    refused();
    watched();
    return check_summary("fit_robust");
}
