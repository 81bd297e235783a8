/* SPDX-License-Identifier: MIT */
/* nurbs_compose(): known values, knots, both directions, periodic outer curves, and what is refused. */
#include "check.h"
#include "shapes.h"

#define VALUES(...) ((const double[]){__VA_ARGS__})

/* A Bezier curve in the parameter space of something. */
static nurbs *inner(int32_t degree, int32_t dim, const double *points) {
    nurbs *f = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, dim, points, 0, 0, NULL, 0, &f));
    return f;
}

static void check_point(const nurbs *g, double t, const double *expected, int dim) {
    double point[4];
    CHECK_OK(nurbs_eval(g, 1, &t, 0, 0, point, 0, 0, 0));
    for (int c = 0; c < dim; ++c) {
        CHECK_DOUBLE(point[c], expected[c]);
    }
}

/* g(f(t)) for a Bezier curve f. */
static nurbs *composed(SplineArgs g, int32_t degree, int32_t dim, const double *points) {
    nurbs *outer = make(g), *f = inner(degree, dim, points), *h = NULL;
    CHECK_OK(nurbs_compose(outer, f, &h));
    nurbs_destroy(outer);
    nurbs_destroy(f);
    return h;
}

/* A Bezier curve with weights over [0, 1]. */
static nurbs *weighted(int32_t degree, int32_t dim, const double *points, const double *weights) {
    nurbs *f = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, dim, points, 0, 0, weights, 0, &f));
    return f;
}

/* The quarter circle (1 - t^2, 2 t) / (1 + t^2) on (u, v, u v), and a line over a rational linear map. */
static void rational_curves(void) {
    nurbs *g = make(patch()), *f = weighted(2, 2, VALUES(1, 0, 1, 1, 0, 1), VALUES(1, 1, 2)), *h = NULL;
    int32_t degree = 0;
    CHECK_OK(nurbs_compose(g, f, &h));
    CHECK_OK(nurbs_degree(h, 0, &degree));
    CHECK(degree == 4);
    check_point(h, 0, VALUES(1, 0, 0), 3);
    check_point(h, 1, VALUES(0, 1, 0), 3);
    double point[3], t = 0.5;
    CHECK_OK(nurbs_eval(h, 1, &t, 0, 0, point, 0, 0, 0));
    CHECK_NEAR(point, VALUES(0.6, 0.8, 0.48), 3, 4 * 0x1p-52);
    nurbs_destroy(h);
    nurbs_destroy(f);
    nurbs_destroy(g);
    g = make(arch());
    f = weighted(1, 1, VALUES(0, 1), VALUES(1, 2));
    CHECK_OK(nurbs_compose(g, f, &h));
    CHECK_POINTS(h, VALUES(0, 0, 1, 2, 3, 2, 4, 0));
    CHECK_WEIGHTS(h, VALUES(0.125, 0.25, 0.5, 1)); /* 1, 2, 4, 8, divided by 2 for each degree of g */
    nurbs_destroy(h);
    nurbs_destroy(f);
    nurbs_destroy(g);
}

static void curves(void) {
    nurbs *h = composed(twist(), 2, 1, VALUES(0, 0, 1)); /* 3 (t^2, t^4, t^6) */
    int32_t degree = 0;
    CHECK_OK(nurbs_degree(h, 0, &degree));
    CHECK(degree == 6);
    check_point(h, 0.5, VALUES(0.75, 0.1875, 0.046875), 3);
    nurbs_destroy(h);
    h = composed(twist(), 1, 1, VALUES(1, 0)); /* the other way round */
    CHECK_POINTS(h, VALUES(3, 3, 3, 2, 1, 0, 1, 0, 0, 0, 0, 0));
    nurbs_destroy(h);
    h = composed(hill(), 1, 1, VALUES(2, 4)); /* half as long: the knot at 3 comes to 1/2 */
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 0.5, 1, 1, 1));
    CHECK_POINTS(h, VALUES(1, 2, 4, 3));
    nurbs_destroy(h);
    h = composed(jump(), 2, 1, VALUES(0, 1, 2)); /* 2 t, raised in degree: the jump stays one */
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1));
    CHECK_POINTS(h, VALUES(0, 0.5, 1, 5, 5.5, 6));
    nurbs_destroy(h);
    h = composed(stairs(), 1, 1, VALUES(0, 2)); /* degree 0 */
    CHECK_KNOTS(h, 0, VALUES(0, 0.5, 1));
    CHECK_POINTS(h, VALUES(10, 20));
    nurbs_destroy(h);
    h = composed(circle(), 1, 1, VALUES(0.25, 0.75)); /* the left half */
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 0.5, 0.5, 1, 1, 1));
    check_point(h, 0.5, VALUES(-1, 0), 2);
    nurbs_destroy(h);
}

static void around_a_loop(void) {
    nurbs *h = composed(loop(), 1, 1, VALUES(-2, 10)), *g = make(loop()); /* three times, from -1 period on */
    check_point(h, 0.0, VALUES(0, 1), 2);
    for (int i = 0; i < 12; ++i) {
        double want[2], u = 2 + i % 4 + 0.25;
        CHECK_OK(nurbs_eval(g, 1, &u, 0, 0, want, 0, 0, 0));
        double got[2], t = (i + 0.25) / 12;
        CHECK_OK(nurbs_eval(h, 1, &t, 0, 0, got, 0, 0, 0));
        CHECK(fabs(got[0] - want[0]) < 1e-14 && fabs(got[1] - want[1]) < 1e-14);
    }
    nurbs *f = inner(1, 1, VALUES(0, 1e9)), *out = NULL;
    CHECK_NO_HANDLE(out, nurbs_compose(g, f, &out), NURBS_ERROR_OUTSIDE_DOMAIN, "65536|periods");
    nurbs_destroy(f);
    nurbs_destroy(g);
    nurbs_destroy(h);
}

static void on_surfaces_and_in_volumes(void) {
    nurbs *h = composed(patch(), 1, 2, VALUES(0, 0, 1, 1)); /* (t, t, t^2) */
    CHECK_POINTS(h, VALUES(0, 0, 0, 0.5, 0.5, 0, 1, 1, 1));
    nurbs_destroy(h);
    h = composed(patch(), 2, 2, VALUES(0, 0, 0.5, 1, 1, 0)); /* v returns */
    check_point(h, 0.5, VALUES(0.5, 0.5, 0.25), 3);
    nurbs_destroy(h);
    h = composed(cube(), 1, 3, VALUES(0, 0, 0, 1, 1, 1)); /* (t, t, t, t^3) */
    check_point(h, 0.5, VALUES(0.5, 0.5, 0.5, 0.125), 4);
    nurbs_destroy(h);
}

static void check_refused(SplineArgs g, nurbs *f, nurbs_status status, const char *text) {
    nurbs *outer = make(g), *h = NULL;
    CHECK_NO_HANDLE(h, nurbs_compose(outer, f, &h), status, text);
    nurbs_destroy(outer);
    nurbs_destroy(f);
}

static void refused(void) {
    nurbs *g = make(twist()), *f = inner(1, 1, VALUES(0, 1)), *h = NULL;
    CHECK_NO_HANDLE(h, nurbs_compose(NULL, f, &h), NURBS_ERROR_NULL, "g is NULL");
    CHECK_NO_HANDLE(h, nurbs_compose(g, NULL, &h), NURBS_ERROR_NULL, "f is NULL");
    CHECK_FAILS(nurbs_compose(g, f, NULL), NURBS_ERROR_NULL, "out is NULL");
    nurbs_destroy(g);
    nurbs_destroy(f);
    check_refused(twist(), make(patch()), NURBS_ERROR_AXES, "f has 2 axes");
    check_refused(patch(), make(circle()), NURBS_ERROR_OUTSIDE_DOMAIN, "coordinate");
    check_refused(patch(), weighted(2, 2, VALUES(0, 0, 0, 1, 1, 1), VALUES(1, 0, 1)), NURBS_ERROR_RATIONAL,
                  "f has the weight 0|positive");
    check_refused(twist(),
                  weighted(11, 1, VALUES(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11),
                           VALUES(1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2)),
                  NURBS_ERROR_DEGREE, "11 of f|3 of g|33|31");
    check_refused(twist(), weighted(2, 1, VALUES(0, 1, 0), VALUES(1, 2, 1)), NURBS_ERROR_NOT_MONOTONE,
                  "neither");
    check_refused(patch(), inner(1, 1, VALUES(0, 1)), NURBS_ERROR_DIMENSION, "dimension 1 of f|expected 2");
    check_refused(twist(), inner(11, 1, VALUES(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11)), NURBS_ERROR_DEGREE,
                  "11 of f|3 of g|33|31");
    check_refused(twist(), inner(2, 1, VALUES(0, 1, 0)), NURBS_ERROR_NOT_MONOTONE, "neither increases");
    check_refused(twist(), inner(1, 1, VALUES(0.5, 0.5)), NURBS_ERROR_NOT_MONOTONE, "strictly");
    check_refused(twist(), make(stairs()), NURBS_ERROR_NOT_MONOTONE, "strictly");
    check_refused(twist(), inner(1, 1, VALUES(0, 1.5)), NURBS_ERROR_OUTSIDE_DOMAIN,
                  "coordinate 0 of f|[0, 1]|t = 0 and 1");
    check_refused(patch(), inner(2, 2, VALUES(0, 0, 0, 4, 1, 0)), NURBS_ERROR_OUTSIDE_DOMAIN,
                  "coordinate 1 of f");
}

/* A curve of dimension 1. */
static nurbs *scalar(int32_t degree, int64_t count, const double *knots, const double *points) {
    return make((SplineArgs){1, &degree, &count, knots, count + degree + 1, 1, points, 0, 0, NULL, 0, 0});
}

/* A surface over [0, 2 middle] x [0, 1], straight along v and with an edge in the middle of u. */
static nurbs *roof(double middle, double left, double ridge, double right) {
    static const int32_t degrees[] = {1, 1};
    static const int64_t counts[] = {3, 2};
    const double knots[] = {0, 0, middle, 2 * middle, 2 * middle, 0, 0, 1, 1};
    const double points[] = {left, left, ridge, ridge, right, right};
    return make((SplineArgs){2, degrees, counts, knots, 9, 1, points, 0, 0, NULL, 0, 0});
}

/* Whether g(f(t)) is a value; both are used up. */
static void check_value(nurbs *g, nurbs *f, double t, double expected, double tolerance) {
    nurbs *h = NULL;
    double value = 0;
    CHECK_OK(nurbs_compose(g, f, &h));
    CHECK_OK(nurbs_eval(h, 1, &t, 0, 0, &value, 0, 0, 0));
    CHECK(fabs(value - expected) <= tolerance);
    nurbs_destroy(g);
    nurbs_destroy(f);
    nurbs_destroy(h);
}

static void touching_a_knot_line(void) {
    const double *below = VALUES(0.25, 0, 0.75, 0.5, 0.25, 1), *above = VALUES(0.75, 0, 0.25, 0.5, 0.75, 1);
    check_value(roof(0.5, 0, 0, 1), inner(2, 2, below), 0, 0, 0);
    check_value(roof(0.5, 1, 0, 0), inner(2, 2, below), 0, 0.5, 0);
    check_value(roof(0.5, 0, 0, 1), inner(2, 2, above), 0, 0.5, 0);
    check_value(roof(0.5, 1, 0, 0), inner(2, 2, above), 0, 0, 0);
}

/* The span between them is shorter than values of f are known, its ends count as one knot of multiplicity
 * 2. */
static void knots_an_ulp_apart(void) {
    const double knots[] = {0, 0, 0, 0.5, nextafter(0.5, 1), 1, 1, 1}, points[] = {0, 0, 1, 0, 0};
    check_value(scalar(2, 5, knots, points), inner(1, 1, VALUES(0, 1)), 0.25, 0.25, 1e-15);
    check_value(scalar(2, 5, knots, points), inner(1, 1, VALUES(0, 1)), 0.75, 0.25, 1e-15);
}

/* f rises by 0.02 within an ulp, so that its values are known to 0.04 there, but not so beside. */
static void beside_a_steep_piece(void) {
    const double knots[] = {1000, 1000, 1001, nextafter(1001, 1002), 1002, 1002},
                 values[] = {0, 0.45, 0.47, 1};
    const double u = 0.47 + 0.53 * 0.001; /* g(u) = 4 u - 6 u^2 up to 1/2 */
    check_value(scalar(2, 4, VALUES(0, 0, 0, 0.5, 1, 1, 1), VALUES(0, 1, 0, 3)), scalar(1, 4, knots, values),
                1001.001, 4 * u - 6 * u * u, 1e-12);
}

static void at_the_limits_of_doubles(void) {
    check_value(roof(1.5e307, 0, 1, 0), inner(1, 2, VALUES(3e306, 0, 2.7e307, 1)), 0, 0.2, 1e-15);
    const double end = nextafter(1, 2), points[] = {0, 0, 1.2e308, 0, 1.2e308, 1};
    const int32_t degree = 2;
    const int64_t count = 3;
    nurbs *f = make(
        (SplineArgs){1, &degree, &count, VALUES(1, 1, 1, end, end, end), 6, 2, points, 0, 0, NULL, 0, 0});
    nurbs *g = roof(8e307, 0, 1, 0), *h = NULL;
    CHECK_NO_HANDLE(h, nurbs_compose(g, f, &h), NURBS_ERROR_NOT_REPRESENTABLE, "coordinate 0|too steep");
    nurbs_destroy(f);
    nurbs_destroy(g);
}

/* As cheap as nearby, for which 2^40 periods in between must not be gone through. */
static void far_around_a_loop(void) {
    const double away = ldexp(4, 40);
    nurbs *near = composed(loop(), 1, 1, VALUES(3, 7)),
          *far = composed(loop(), 1, 1, VALUES(away + 3, away + 7));
    int64_t counts[2] = {0, 0};
    CHECK_OK(nurbs_count(near, 0, &counts[0]));
    CHECK_OK(nurbs_count(far, 0, &counts[1]));
    CHECK(counts[0] == counts[1]);
    for (int i = 0; i <= 16; ++i) {
        double want[2], got[2], t = i / 16.0;
        CHECK_OK(nurbs_eval(near, 1, &t, 0, 0, want, 0, 0, 0));
        CHECK_OK(nurbs_eval(far, 1, &t, 0, 0, got, 0, 0, 0));
        CHECK(fabs(got[0] - want[0]) < 1e-14 && fabs(got[1] - want[1]) < 1e-14);
    }
    nurbs_destroy(near);
    nurbs_destroy(far);
    check_refused(loop(), inner(1, 1, VALUES(1e30, 1.1e30)), NURBS_ERROR_OUTSIDE_DOMAIN, "2^52 periods from");
    check_refused(loop(), inner(1, 1, VALUES(0x1p56, 0x1p56 + 64)), NURBS_ERROR_OUTSIDE_DOMAIN, "2^52");
}

int main(void) {
    curves();
    rational_curves();
    around_a_loop();
    far_around_a_loop();
    on_surfaces_and_in_volumes();
    refused();
    touching_a_knot_line();
    knots_an_ulp_apart();
    beside_a_steep_piece();
    at_the_limits_of_doubles();
    return check_summary("compose");
}
