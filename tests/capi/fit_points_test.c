/* SPDX-License-Identifier: MIT */
/* nurbs_fit_points() and nurbs_fit(): what they find. */
#include "fits.h"
#include "shapes.h"

#define NEAR(actual, expected) CHECK_NEAR(&(actual), VALUES(expected), 1, 1e-14)

static void check_line_report(const nurbs_fit_report *r) {
    CHECK_INT(r->struct_size, sizeof *r);
    CHECK_INT(r->data_count, 3);
    CHECK_DOUBLE(r->weight, 3);
    NEAR(r->squares, 1 / 6.0);
    NEAR(r->rms, sqrt(1 / 18.0));
    CHECK_DOUBLE(r->lambda, 0);
    CHECK_DOUBLE(r->freedom, 2);
    NEAR(r->sigma, sqrt(1 / 6.0));
    CHECK(r->residual >= 0 && r->residual <= 1e-20);
    CHECK_INT(r->bits, 0);
    CHECK_INT(r->rounds, 1);
    CHECK_INT(r->outliers, 0);
}

static void a_line(void) {
    FitArgs a = line();
    nurbs *g = fitted(&a), *h = NULL;
    CHECK_POINTS_NEAR(g, VALUES(1 / 6.0, 7 / 6.0), 1e-15);
    check_line_report(&a.report);
    NEAR(a.report.largest, 1 / 3.0);
    CHECK_INT(a.report.largest_index, 1);
    CHECK_OK(nurbs_fit_points(&a.data, a.degrees, a.counts, a.knots, a.knot_count, 0, NULL, NULL, &h));
    double made[2];
    CHECK_OK(nurbs_points(g, 2, made, 0, 0));
    CHECK_POINTS(h, made);
    nurbs_destroy(g);
    nurbs_destroy(h);
    nurbs_statistics *s = statistics_of_line();
    a.report = unwritten_report();
    CHECK_OK(nurbs_fit(s, a.degrees, a.counts, a.knots, a.knot_count, 0, NULL, &a.report, &g));
    CHECK_POINTS(g, made);
    check_line_report(&a.report);
    CHECK_DOUBLE(a.report.largest, NAN);
    CHECK_INT(a.report.largest_index, -1);
    nurbs_destroy(g);
    nurbs_statistics_destroy(s);
}

/* A weight of 2 counts as two data, one of 0 as none, whatever the value is. */
static void weights(void) {
    FitArgs a = line();
    a.data.weights = VALUES(1, 2, 1);
    nurbs *g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(0.25, 1.25), 1e-15);
    CHECK_DOUBLE(a.report.weight, 4);
    NEAR(a.report.squares, 0.25);
    NEAR(a.report.rms, 0.25);
    NEAR(a.report.sigma, 0.5);
    nurbs_destroy(g);
    for (int i = 0; i < 4; ++i) {
        a = line();
        a.data.n = 4;
        a.data.params = VALUES(0, 1, 0.5, 2);
        a.data.values = edited(VALUES(0, 1, 0, 1), 4, 2, VALUES(NAN, INFINITY, -5, 1e30)[i]);
        a.data.weights = VALUES(0.5, 9, 0.5, 9, 0, 9, 0.5);
        a.data.weight_stride = 2;
        g = fitted(&a);
        CHECK_POINTS_NEAR(g, VALUES(1 / 6.0, 7 / 6.0), 1e-15);
        CHECK_INT(a.report.data_count, 3);
        NEAR(a.report.squares, 1 / 12.0);
        NEAR(a.report.largest, 1 / 3.0);
        CHECK_INT(a.report.largest_index, 1);
        nurbs_destroy(g);
    }
}

/* A weight that is lost beside the largest one leaves its value out of all answers. */
static void weights_that_count_as_none(void) {
    FitArgs a = line();
    a.data.n = 4;
    a.data.params = VALUES(0, 1, 1, 2);
    a.data.values = VALUES(0, 1, 64, 1);
    a.data.weights = VALUES(1, 1, 0x1p-60, 1);
    nurbs *g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(1 / 6.0, 7 / 6.0), 1e-15);
    CHECK_INT(a.report.data_count, 3);
    NEAR(a.report.largest, 1 / 3.0);
    CHECK_INT(a.report.largest_index, 1);
    nurbs_destroy(g);
}

/* The values of data that are left out do not decide what the others are rounded to. */
static void data_left_out(void) {
    FitArgs a = line();
    a.data.n = 6;
    a.data.params = VALUES(NAN, 0, 1, -INFINITY, 2, 2.5);
    a.data.values = VALUES(1e30, 0, 1, NAN, 1, -1e30);
    a.data.flags = NURBS_NAN;
    nurbs *g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(1 / 6.0, 7 / 6.0), 1e-15);
    check_line_report(&a.report);
    NEAR(a.report.largest, 1 / 3.0);
    CHECK_INT(a.report.largest_index, 2);
    nurbs_destroy(g);
    a.data.n = 4; /* not enough are left */
    a.data.values = VALUES(1e30, NAN, 1, NAN);
    a.data.weights = VALUES(1, 0, 1, 1);
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_RANK, "control point");
}

/* Parameters outside move to the nearer end. */
static void clamped(void) {
    FitArgs a = line();
    a.data.params = VALUES(-INFINITY, 1, 7);
    a.data.flags = NURBS_CLAMP;
    nurbs *g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(1 / 6.0, 7 / 6.0), 1e-15);
    check_line_report(&a.report);
    NEAR(a.report.largest, 1 / 3.0);
    nurbs_destroy(g);
    a.data.params = VALUES(-INFINITY, 1, NAN);
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_PARAMETER_NOT_FINITE, "params[2]|nan");
    a.data.n = 4;
    a.data.params = VALUES(-1, 1, INFINITY, NAN);
    a.data.values = VALUES(0, 1, 1, 8);
    a.data.flags = NURBS_CLAMP | NURBS_NAN;
    a.report = unwritten_report();
    g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(1 / 6.0, 7 / 6.0), 1e-15);
    check_line_report(&a.report);
    nurbs_destroy(g);
}

/* The end of the domain is its start, seen from the right, and the other way round seen from the left. */
static void wrapped(void) {
    FitArgs a = line();
    a.data.flags = NURBS_WRAP;
    a.data.params = VALUES(-2, 3, 1.9999999999999998);
    nurbs *g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(1 / 6.0, 7 / 6.0), 1e-14);
    nurbs_destroy(g);
    a = line();
    a.data.n = 4;
    a.data.params = VALUES(0, 2, 1, 1);
    a.data.values = VALUES(0, 1, 1, 1); /* 0 and 1 at 0, 1 and 1 at 1 */
    a.data.flags = NURBS_WRAP;
    g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(0.5, 1.5), 1e-14);
    NEAR(a.report.squares, 0.5);
    NEAR(a.report.largest, 0.5);
    nurbs_destroy(g);
    a.data.flags = NURBS_WRAP | NURBS_LEFT; /* 0 and 1 at 2 */
    g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(1.5, 0.5), 1e-14);
    NEAR(a.report.squares, 0.5);
    nurbs_destroy(g);
    a.data.params = VALUES(0, 2, INFINITY, 1);
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_PARAMETER_NOT_FINITE, "params[2]|inf");
}

/* Steps on [0, 1) and [1, 2], of data at 0, 1, 1, 2. */
static void at_a_jump(void) {
    FitArgs a = line();
    a.data.n = 4;
    a.data.params = VALUES(0, 1, 1, 2);
    a.data.values = VALUES(0, 3, 6, 12);
    a.degrees = DEGREES(0);
    a.knots = VALUES(0, 1, 2);
    a.knot_count = 3;
    nurbs *g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(0, 7), 1e-14);
    nurbs_destroy(g);
    a.data.flags = NURBS_LEFT;
    g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(3, 12), 1e-14);
    NEAR(a.report.squares, 18);
    nurbs_destroy(g);
}

/* Columns of a table, and records apart from each other. */
static void layouts(void) {
    static const double table[4][4] = {{0, 0, 1, 8}, {1, 2, 1, 9}, {2, 2, 1, 7}, {-1, -1, -1, -1}};
    static const double columns[] = {0, 9, 2, 9, 2, 9, 1, 9, 1, 9, 1, 9};
    double made[4];
    FitArgs a = line();
    a.data.dim = 2;
    a.data.params = table[0];
    a.data.param_stride = a.data.value_stride = 4;
    a.data.values = table[0] + 1;
    nurbs *g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(1 / 3.0, 1, 7 / 3.0, 1), 1e-14);
    NEAR(a.report.squares, 4 / 6.0);
    NEAR(a.report.sigma, sqrt(4 / 12.0));
    CHECK_OK(nurbs_points(g, 2, made, 0, 0));
    nurbs_destroy(g);
    a.data.values = columns;
    a.data.value_stride = 2;
    a.data.value_component_stride = 6;
    a.data.param_component_stride = 5;
    g = fitted(&a);
    CHECK_POINTS(g, made);
    nurbs_destroy(g);
}

/* The parameters of a grid, one axis after the other. */
static void grid_params(int32_t axes, int side, double *columns) {
    const int n = axes == 2 ? side * side : side * side * side;
    for (int i = 0; i < n; ++i) {
        int rest = i;
        for (int32_t k = axes; k-- > 0; rest /= side) {
            columns[k * n + i] = rest % side / (double)(side - 1);
        }
    }
}

static void a_surface(void) {
    double params[18], values[27];
    FitArgs a = line();
    grid_params(2, 3, params);
    for (int i = 0; i < 9; ++i) {
        values[3 * i] = params[i];
        values[3 * i + 1] = params[9 + i];
        values[3 * i + 2] = params[i] * params[9 + i];
    }
    a.data = data_of(2, 3, 9, params, values);
    a.data.param_stride = 1;
    a.data.param_component_stride = 9;
    a.degrees = DEGREES(1, 1);
    a.counts = COUNTS(2, 2);
    a.knots = VALUES(0, 0, 1, 1, 0, 0, 1, 1);
    a.knot_count = 8;
    nurbs *g = fitted(&a);
    CHECK_POINTS_NEAR(g, patch().points, 1e-14);
    CHECK_INT(a.report.data_count, 9);
    CHECK_DOUBLE(a.report.freedom, 4);
    CHECK(a.report.squares <= 1e-28 && a.report.largest <= 1e-14);
    nurbs_destroy(g);
    a.flags = NURBS_ON_AXIS(2, NURBS_PERIODIC);
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_FLAGS, "0x10000");
    a.flags = 0;
    a.data.flags = NURBS_ON_AXIS(1, NURBS_CLAMP);
    params[4] = 1.5; /* on axis 0 */
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_OUTSIDE_DOMAIN, "params[4][0] = 1.5|[0, 1]");
    a.data.flags = NURBS_ON_AXIS(2, NURBS_CLAMP);
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_FLAGS, "0x20000|2 axes");
}

static void a_volume(void) {
    double params[81], values[108];
    FitArgs a = line();
    grid_params(3, 3, params);
    for (int i = 0; i < 27; ++i) {
        for (int c = 0; c < 3; ++c) {
            values[4 * i + c] = params[27 * c + i];
        }
        values[4 * i + 3] = params[i] * params[27 + i] * params[54 + i];
    }
    a.data = data_of(3, 4, 27, params, values);
    a.data.param_stride = 1;
    a.data.param_component_stride = 27;
    a.degrees = DEGREES(1, 1, 1);
    a.counts = COUNTS(2, 2, 2);
    a.knots = VALUES(0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1);
    a.knot_count = 12;
    nurbs *g = fitted(&a);
    CHECK_POINTS_NEAR(g, cube().points, 1e-14);
    CHECK_DOUBLE(a.report.freedom, 8);
    nurbs_destroy(g);
}

/* Round a circle more than once: control points wrap bit for bit. */
static void a_loop(void) {
    double params[24], values[48], points[22];
    FitArgs a = line();
    for (int i = 0; i < 24; ++i) {
        params[i] = i / 8.0 - 1;
        values[2 * i] = cos(0.78539816339744828 * i);
        values[2 * i + 1] = sin(0.78539816339744828 * i);
    }
    a.data = data_of(1, 2, 24, params, values);
    a.data.flags = NURBS_WRAP;
    a.degrees = DEGREES(3);
    a.counts = COUNTS(11);
    a.knots =
        VALUES(-0.375, -0.25, -0.125, 0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1, 1.125, 1.25, 1.375);
    a.knot_count = 15;
    a.flags = NURBS_PERIODIC;
    nurbs *g = fitted(&a);
    int32_t form = 0;
    CHECK_OK(nurbs_points(g, 11, points, 0, 0));
    CHECK_BITS(points, points + 16, 6 * sizeof(double));
    CHECK_OK(nurbs_knot_form(g, 0, &form));
    CHECK_INT(form, NURBS_FORM_PERIODIC);
    CHECK(a.report.largest <= 1e-14);
    CHECK_DOUBLE(a.report.freedom, 8);
    nurbs_destroy(g);
    a.data.flags = 0;
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_OUTSIDE_DOMAIN, "params[0]|= -1|[0, 1]");
    a.data.flags = NURBS_WRAP;
    a.knots = edited(a.knots, 15, 14, 1.5);
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_PERIODIC_KNOTS, "knots|axis 0");
}

/* What overflows is infinite, and what is infinite is refused, even beside the largest values. */
static void large_values(void) {
    FitArgs a = line();
    a.data.values = VALUES(0, 1e200, 1e200);
    nurbs_destroy(fitted(&a));
    CHECK_DOUBLE(a.report.squares, INFINITY);
    CHECK_NEAR(&a.report.largest, VALUES(1e200 / 3), 1, 1e186);
    a.data.values = VALUES(1.7e308, INFINITY, 0);
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_POINT_NOT_FINITE, "values[1][0]|inf");
    a.data.values = VALUES(1.7e308, 1.7e308, -1.7e308);
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_NOT_REPRESENTABLE, "of the result");
}

/* A fit that takes some time, of data and of statistics. */
static void watched_calls(FitArgs a, const nurbs_statistics *statistics) {
    FitWatcher w = {0, 0, 0, 0};
    nurbs_call_options call = watched_by(&w, 0);
    nurbs *plain = NULL, *g = NULL;
    double points[64];
    CHECK_OK(fit_of(&a, statistics, NULL, &plain));
    CHECK_OK(nurbs_points(plain, 64, points, 0, 0));
    CHECK_OK(fit_of(&a, statistics, &call, &g));
    CHECK_POINTS(g, points);
    CHECK_INT(w.wrong, 0);
    nurbs_destroy(plain);
    nurbs_destroy(g);
    a.report = unwritten_report();
    const nurbs_fit_report before = a.report;
    call = watched_by(NULL, 1);
    CHECK_NO_HANDLE(g, fit_of(&a, statistics, &call, &g), NURBS_ERROR_WORK, "work = 1");
    call.work = -1;
    CHECK_NO_HANDLE(g, fit_of(&a, statistics, &call, &g), NURBS_ERROR_OPTIONS, "call|work = -1");
    call.struct_size = 8;
    CHECK_NO_HANDLE(g, fit_of(&a, statistics, &call, &g), NURBS_ERROR_OPTIONS, "call|struct_size = 8");
    CHECK(memcmp(&before, &a.report, sizeof before) == 0);
}

static void cancelled(FitArgs a) {
    FitWatcher w = {0, 0, 7, 0};
    const nurbs_call_options call = watched_by(&w, 0);
    nurbs *g = NULL;
    a.report = unwritten_report();
    const nurbs_fit_report before = a.report;
    CHECK_NO_HANDLE(g, fit_of(&a, NULL, &call, &g), NURBS_ERROR_CANCELLED, "progress|7");
    CHECK_INT(w.calls, 1);
    CHECK(memcmp(&before, &a.report, sizeof before) == 0);
}

static void long_calls(void) {
    const int64_t count = 64, knot_count = 72;
    const int32_t degree = 7;
    double knots[72];
    const ManyData many = many_data(500000);
    nurbs_statistics *none = NULL, *all = NULL;
    FitArgs a = line();
    CHECK_OK(nurbs_knots_open_uniform(degree, count, 0, 1, knot_count, knots));
    a.data = data_of(1, 1, many.n, many.params, many.values);
    a.degrees = &degree;
    a.counts = &count;
    a.knots = knots;
    a.knot_count = knot_count;
    CHECK_OK(nurbs_statistics_create(1, &degree, COUNTS(58), knots + 7, 58, 1, 2, 1, &none));
    CHECK_OK(nurbs_statistics_add(none, &a.data, &all));
    watched_calls(a, NULL);
    watched_calls(a, all);
    cancelled(a);
    nurbs_statistics_destroy(none);
    nurbs_statistics_destroy(all);
    free_many(many);
}

int main(void) {
    a_line();
    weights();
    weights_that_count_as_none();
    data_left_out();
    clamped();
    wrapped();
    at_a_jump();
    layouts();
    a_surface();
    a_volume();
    a_loop();
    large_values();
    long_calls();
    return check_summary("fit_points");
}
