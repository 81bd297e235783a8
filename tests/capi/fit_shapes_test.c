/* SPDX-License-Identifier: MIT */
/* Fits that rise, fall, are convex or concave, or stay between bounds. */
#include "fits.h"

#define TRENDS(...) ((const int32_t[]){__VA_ARGS__})

/* A polygon with the corners 0, 1, 2, 3, one datum at each. */
static FitArgs polygon(const double *values) {
    static const double params[] = {0, 1, 2, 3}, knots[] = {0, 0, 1, 2, 3, 3};
    static const int64_t count = 4;
    FitArgs a = line();
    a.data = data_of(1, 1, 4, params, values);
    a.counts = &count;
    a.knots = knots;
    a.knot_count = 6;
    return a;
}

static void check_polygon(const char *file, int line, FitArgs a, const double *expected) {
    nurbs *g = fitted(&a);
    check_points_near(file, line, g, expected, 1e-14);
    nurbs_destroy(g);
}
#define CHECK_POLYGON(a, ...) check_polygon(__FILE__, __LINE__, a, VALUES(__VA_ARGS__))

/* Neighbours that violate become their mean. */
static void trends(void) {
    FitArgs a = polygon(VALUES(0, 3, 1, 4));
    CHECK_POLYGON(a, 0, 3, 1, 4);
    a.options.shapes = TRENDS(NURBS_TREND_RISING);
    CHECK_POLYGON(a, 0, 2, 2, 4);
    nurbs_destroy(fitted(&a));
    CHECK_NEAR(&a.report.freedom, VALUES(3), 1, 1e-9);
    CHECK_NEAR(&a.report.squares, VALUES(2), 1, 1e-14);
    a.options.shapes = TRENDS(NURBS_TREND_FALLING);
    CHECK_POLYGON(a, 2, 2, 2, 2);
    a.options.shapes = TRENDS(0);
    CHECK_POLYGON(a, 0, 3, 1, 4);
    /* One second difference is of the wrong sign: a sixth of it goes to its corners. */
    a = polygon(VALUES(0, 0, 1, 1));
    a.options.shapes = TRENDS(NURBS_TREND_CONVEX);
    CHECK_POLYGON(a, 0, 1 / 6.0, 2 / 3.0, 7 / 6.0);
    a.options.shapes = TRENDS(NURBS_TREND_CONCAVE);
    CHECK_POLYGON(a, -1 / 6.0, 1 / 3.0, 5 / 6.0, 1);
    a.options.shapes = TRENDS(NURBS_TREND_RISING + NURBS_TREND_CONVEX);
    CHECK_POLYGON(a, 0, 1 / 6.0, 2 / 3.0, 7 / 6.0);
}

static void bounds(void) {
    FitArgs a = polygon(VALUES(0, 3, 1, 4));
    a.options.lower = VALUES(0.5);
    a.options.upper = VALUES(2.5);
    CHECK_POLYGON(a, 0.5, 2.5, 1, 2.5);
    nurbs *g = fitted(&a); /* as doubles */
    double points[4];
    CHECK_OK(nurbs_points(g, 4, points, 0, 0));
    CHECK_DOUBLE(points[0], 0.5);
    CHECK_DOUBLE(points[1], 2.5);
    nurbs_destroy(g);
    a.options.lower = VALUES(-INFINITY);
    CHECK_POLYGON(a, 0, 2.5, 1, 2.5);
    a.options.upper = NULL;
    CHECK_POLYGON(a, 0, 3, 1, 4);
    a.options.lower = VALUES(2);
    a.options.upper = VALUES(2);
    CHECK_POLYGON(a, 2, 2, 2, 2);
    /* Of a condition, and of values far away. */
    a = polygon(VALUES(1e8, 1e8 + 3, 1e8 + 1, 1e8 + 4));
    a.options.shapes = TRENDS(NURBS_TREND_RISING);
    a.options.upper = VALUES(1e8 + 3);
    a.options.conditions = 1;
    a.options.condition_params = VALUES(0);
    a.options.condition_targets = VALUES(1e8 + 2.5);
    g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(1e8 + 2.5, 1e8 + 2.5, 1e8 + 2.5, 1e8 + 3), 1e-7);
    nurbs_destroy(g);
}

/* Bounds that are far away change nothing, solutions may be 0, and conditions may leave no room for rounding. */
static void limits(void) {
    FitArgs a = polygon(VALUES(0, 3, 1, 4));
    a.options.lower = VALUES(-1e300);
    a.options.upper = VALUES(1e300);
    CHECK_POLYGON(a, 0, 3, 1, 4);
    a.options.shapes = TRENDS(NURBS_TREND_RISING);
    CHECK_POLYGON(a, 0, 2, 2, 4);
    a = polygon(VALUES(-1, -2, -1, -3));
    a.options.shapes = TRENDS(NURBS_TREND_RISING);
    a.options.lower = VALUES(0);
    CHECK_POLYGON(a, 0, 0, 0, 0);
    a.options.upper = VALUES(0);
    CHECK_POLYGON(a, 0, 0, 0, 0);
    a = polygon(VALUES(0, 0, 0, 0));
    a.options.shapes = TRENDS(NURBS_TREND_CONVEX);
    a.options.lower = VALUES(1);
    CHECK_POLYGON(a, 1, 1, 1, 1);
    a = polygon(VALUES(0, 3, 1, 4)); /* constant at its end, and therefore everywhere */
    a.options.shapes = TRENDS(NURBS_TREND_RISING + NURBS_TREND_CONVEX);
    a.options.conditions = 1;
    a.options.condition_params = VALUES(3);
    a.options.condition_orders = DEGREES(1);
    a.options.condition_targets = VALUES(0);
    CHECK_POLYGON(a, 2, 2, 2, 2);
}

/* Of statistics, to a tolerance, of several coordinates, with a penalty, and of steps. */
static void other_fits(void) {
    FitArgs a = line();
    a.data.values = VALUES(1, 0, 0);
    a.options.shapes = TRENDS(NURBS_TREND_RISING);
    CHECK_POLYGON(a, 1 / 3.0, 1 / 3.0);
    a.options.smoothing = NURBS_SMOOTHING_LAMBDA;
    a.options.penalty_order = 1;
    a.options.lambda = 10;
    CHECK_POLYGON(a, 1 / 3.0, 1 / 3.0);
    a = line();
    nurbs_statistics *s = statistics_of_line();
    nurbs *g = NULL;
    a.options.upper = VALUES(0.5);
    CHECK_OK(fit_of(&a, s, NULL, &g));
    CHECK_POINTS_NEAR(g, VALUES(0.3, 0.5), 1e-15);
    nurbs_destroy(g);
    nurbs_statistics_destroy(s);
    a = polygon(VALUES(0, 3, 1, 4));
    a.data.dim = 2;
    a.data.values = VALUES(0, 0, 3, 3, 1, 1, 4, 4);
    a.options.shapes = TRENDS(0, NURBS_TREND_RISING);
    CHECK_POLYGON(a, 0, 0, 3, 2, 1, 2, 4, 4);
    a = polygon(VALUES(0, 3, 1, 4));
    a.degrees = DEGREES(0);
    a.counts = COUNTS(3);
    a.knots = VALUES(0, 1, 2, 3);
    a.knot_count = 4;
    a.options.shapes = TRENDS(NURBS_TREND_RISING);
    CHECK_POLYGON(a, 0, 8 / 3.0, 8 / 3.0);
    ToleranceArgs t = tolerance_args(polygon(VALUES(0, 3, 1, 4)).data, 1.5);
    t.degrees = DEGREES(1);
    t.options.shapes = TRENDS(NURBS_TREND_RISING);
    CHECK_OK(tolerance_fit(&t, NULL, &g));
    CHECK_INT(t.report.bits, 0);
    nurbs_destroy(g);
}

/* A plane over the unit square, of four data. */
static void surfaces(void) {
    FitArgs a = line();
    a.data = data_of(2, 1, 4, VALUES(0, 0, 0, 1, 1, 0, 1, 1), VALUES(0, 2, 3, 1));
    a.degrees = DEGREES(1, 1);
    a.counts = COUNTS(2, 2);
    a.knots = VALUES(0, 0, 1, 1, 0, 0, 1, 1);
    a.knot_count = 8;
    a.options.shapes = TRENDS(NURBS_TREND_RISING, 0);
    CHECK_POLYGON(a, 0, 1.5, 3, 1.5);
    a.options.shapes = TRENDS(NURBS_TREND_RISING, NURBS_TREND_RISING);
    CHECK_POLYGON(a, 0, 2, 2, 2);
}

/* Bounds of a closed polygon, and a volume that rises along its last axis. */
static void closed_curves_and_volumes(void) {
    static double corners[24];
    FitArgs a = line();
    a.data = data_of(1, 1, 3, VALUES(0, 1, 2), VALUES(0, 3, 1));
    a.flags = NURBS_PERIODIC;
    a.counts = COUNTS(4);
    a.knots = VALUES(-1, 0, 1, 2, 3, 4);
    a.knot_count = 6;
    a.options.upper = VALUES(2);
    nurbs *g = fitted(&a);
    double points[4];
    CHECK_OK(nurbs_points(g, 4, points, 0, 0));
    CHECK_DOUBLE(points[0], points[3]);
    CHECK(points[0] <= 2 && points[1] <= 2 && points[2] <= 2);
    nurbs_destroy(g);
    for (int i = 0; i < 8; ++i) {
        for (int k = 0; k < 3; ++k) {
            corners[3 * i + k] = i >> (2 - k) & 1;
        }
    }
    a = line();
    a.data = data_of(3, 1, 8, corners, VALUES(0, 1, 2, 0, 5, 5, 4, 8));
    a.degrees = DEGREES(1, 1, 1);
    a.counts = COUNTS(2, 2, 2);
    a.knots = VALUES(0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1);
    a.knot_count = 12;
    a.options.shapes = TRENDS(0, 0, NURBS_TREND_RISING);
    CHECK_POLYGON(a, 0, 1, 1, 1, 5, 5, 4, 8);
}

#define FAILS(change, status, words)                                                                         \
    do {                                                                                                     \
        FitArgs a = line();                                                                                  \
        change;                                                                                              \
        check_fit_fails(__FILE__, __LINE__, a, NULL, status, words);                                         \
    } while (0)

static void refused(void) {
    FAILS(a.options.shapes = TRENDS(16), NURBS_ERROR_RULE, "shapes[0][0] = 16");
    FAILS(a.options.shapes = TRENDS(-1), NURBS_ERROR_RULE, "shapes[0][0] = -1");
    FAILS(a.options.shapes = TRENDS(3), NURBS_ERROR_RULE, "shapes[0][0] = 3|opposite");
    FAILS(a.options.shapes = TRENDS(13), NURBS_ERROR_RULE, "shapes[0][0] = 13|opposite");
    FAILS(a.options.lower = VALUES(NAN), NURBS_ERROR_POINT_NOT_FINITE, "lower[0]");
    FAILS(a.options.upper = VALUES(NAN), NURBS_ERROR_POINT_NOT_FINITE, "upper[0]");
    FAILS((a.options.lower = VALUES(1), a.options.upper = VALUES(0.5)), NURBS_ERROR_CONTRADICTION,
          "lower[0] = 1|upper[0] = 0.5");
    FAILS(a.options.lower = VALUES(INFINITY), NURBS_ERROR_CONTRADICTION, "lower[0] = inf");
    FAILS(a.options.upper = VALUES(-INFINITY), NURBS_ERROR_CONTRADICTION, "upper[0] = -inf");
    FAILS(a.options.reserved2 = 1, NURBS_ERROR_OPTIONS, "reserved2 = 1");
    FAILS((a.degrees = DEGREES(0), a.counts = COUNTS(1), a.knots = VALUES(0, 2), a.knot_count = 2,
           a.options.shapes = TRENDS(NURBS_TREND_CONVEX)),
          NURBS_ERROR_ORDER, "degree 1");
    FAILS((a.counts = COUNTS(4), a.knots = VALUES(0, 0, 1, 1, 2, 2), a.knot_count = 6,
           a.options.shapes = TRENDS(NURBS_TREND_CONCAVE)),
          NURBS_ERROR_MULTIPLICITY, "knot 1");
    FAILS((a.flags = NURBS_PERIODIC, a.counts = COUNTS(3), a.knot_count = 5, a.knots = VALUES(-1, 0, 1, 2, 3),
           a.options.shapes = TRENDS(NURBS_TREND_RISING)),
          NURBS_ERROR_RULE, "periodic");
    FAILS((a.options.shapes = TRENDS(NURBS_TREND_FALLING), a.options.conditions = 2,
           a.options.condition_params = VALUES(0, 2), a.options.condition_targets = VALUES(0, 1)),
          NURBS_ERROR_CONTRADICTION, "missed");
    FAILS((a.options.upper = VALUES(0.5), a.options.conditions = 1, a.options.condition_params = VALUES(0),
           a.options.condition_targets = VALUES(0.75)),
          NURBS_ERROR_CONTRADICTION, "missed");
    FAILS((a.options.upper = VALUES(0.5), a.options.conditions = 1, a.options.condition_params = VALUES(0),
           a.options.condition_targets = VALUES(0.5 + 1e-7)),
          NURBS_ERROR_CONTRADICTION, "missed");
}

/* The data may leave open what the shape does not decide either. */
static void undetermined(void) {
    FitArgs a = line();
    a.data.n = 1;
    a.options.shapes = TRENDS(NURBS_TREND_RISING);
    check_fit_fails(__FILE__, __LINE__, a, NULL, NURBS_ERROR_RANK, "control point");
    a.options.regularize = 1;
    nurbs *g = fitted(&a);
    CHECK_POINTS_NEAR(g, VALUES(0, 0), 1e-9);
    nurbs_destroy(g);
}

int main(void) {
    trends();
    bounds();
    limits();
    other_fits();
    surfaces();
    closed_curves_and_volumes();
    refused();
    undetermined();
    return check_summary("fit_shapes");
}
