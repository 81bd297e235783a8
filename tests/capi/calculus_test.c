/* SPDX-License-Identifier: MIT */
/* nurbs_blossom(), nurbs_derivative(), nurbs_antiderivative(), nurbs_product() and nurbs_sum(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

static void check_point(const nurbs *g, double t, const double *expected, int dim) {
    double point[4];
    CHECK_OK(nurbs_eval(g, 1, &t, 0, 0, point, 0, 0, 0));
    for (int c = 0; c < dim; ++c) {
        CHECK_DOUBLE(point[c], expected[c]);
    }
}

static void polar_forms(void) {
    nurbs *g = make(twist()), *h = make(stairs()), *j = make(jump()), *c = make(circle()), *p = make(patch());
    const double half = 0.5, one = 1, pair[] = {0.25, 0.5};
    double values[3] = {7, 7, 7};
    CHECK_OK(nurbs_blossom(g, &half, 3, VALUES(0, 0.5, 1), values, 0)); /* 3 (mean, pairs / 3, product) */
    CHECK_DOUBLE(values[0], 1.5);
    CHECK_DOUBLE(values[1], 0.5);
    CHECK_DOUBLE(values[2], 0);
    CHECK_OK(nurbs_blossom(g, &half, 3, VALUES(0, 0, 2), values, 0)); /* beyond the span */
    CHECK_DOUBLE(values[0], 2);
    CHECK_OK(nurbs_blossom(h, &one, 0, NULL, values, 0)); /* degree 0 has no arguments */
    CHECK_DOUBLE(values[0], 20);
    CHECK_OK(nurbs_blossom(h, &one, 0, NULL, values, NURBS_LEFT));
    CHECK_DOUBLE(values[0], 10);
    CHECK_OK(nurbs_blossom(j, &one, 1, VALUES(0.5), values, 0)); /* each piece continues */
    CHECK_DOUBLE(values[0], 4.5);
    CHECK_OK(nurbs_blossom(j, &one, 1, VALUES(0.5), values, NURBS_LEFT));
    CHECK_DOUBLE(values[0], 0.5);
    CHECK_OK(nurbs_blossom(c, VALUES(0.1), 2, VALUES(0, 0), values, 0));
    CHECK_DOUBLE(values[0], 1);
    CHECK_DOUBLE(values[2], 1); /* the weight */
    CHECK_OK(nurbs_blossom(p, pair, 2, VALUES(0.5, 0.25), values, 0));
    CHECK_DOUBLE(values[2], 0.125);
    values[0] = 7;
    CHECK_FAILS(nurbs_blossom(NULL, &half, 3, VALUES(0, 0, 0), values, 0), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_blossom(g, NULL, 3, VALUES(0, 0, 0), values, 0), NURBS_ERROR_NULL, "params");
    CHECK_FAILS(nurbs_blossom(g, &half, 3, NULL, values, 0), NURBS_ERROR_NULL, "args");
    CHECK_FAILS(nurbs_blossom(g, &half, 3, VALUES(0, 0, 0), NULL, 0), NURBS_ERROR_NULL, "values");
    CHECK_FAILS(nurbs_blossom(g, &half, 2, VALUES(0, 0, 0), values, 0), NURBS_ERROR_SIZE, "count = 2|3");
    CHECK_FAILS(nurbs_blossom(g, &half, -1, VALUES(0, 0, 0), values, 0), NURBS_ERROR_SIZE, "count = -1");
    CHECK_FAILS(nurbs_blossom(g, &half, 3, VALUES(0, NAN, 0), values, 0), NURBS_ERROR_PARAMETER_NOT_FINITE,
                "args[1] = nan");
    CHECK_FAILS(nurbs_blossom(g, VALUES(1.5), 3, VALUES(0, 0, 0), values, 0), NURBS_ERROR_OUTSIDE_DOMAIN,
                "params[0] = 1.5|[0, 1]");
    CHECK_FAILS(nurbs_blossom(g, VALUES(NAN), 3, VALUES(0, 0, 0), values, 0),
                NURBS_ERROR_PARAMETER_NOT_FINITE, "params[0] = nan");
    CHECK_FAILS(nurbs_blossom(g, &half, 3, VALUES(0, 0, 0), values, NURBS_NAN), NURBS_ERROR_FLAGS,
                "NURBS_NAN");
    CHECK_FAILS(nurbs_blossom(g, &half, 3, VALUES(0, 0, 0), values, 0x100), NURBS_ERROR_FLAGS, "0x100");
    CHECK_FAILS(nurbs_blossom(g, &half, 3, values, values, 0), NURBS_ERROR_OVERLAP, "values|args");
    CHECK_DOUBLE(values[0], 7);
    CHECK_OK(nurbs_blossom(g, VALUES(1.5), 3, VALUES(0, 0, 1), values, NURBS_CLAMP));
    CHECK_DOUBLE(values[0], 1);
    nurbs_destroy(g);
    nurbs_destroy(h);
    nurbs_destroy(j);
    nurbs_destroy(c);
    nurbs_destroy(p);
}

static void derivatives(void) {
    nurbs *g = make(arch()), *h = NULL;
    CHECK_OK(nurbs_derivative(g, 0, 1, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 1, 1, 1));
    CHECK_POINTS(h, VALUES(3, 6, 6, 0, 3, -6));
    nurbs_destroy(h);
    CHECK_OK(nurbs_derivative(g, 0, 3, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 1));
    CHECK_POINTS(h, VALUES(-12, 0));
    nurbs_destroy(h);
    CHECK_OK(nurbs_derivative(g, 0, 255, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 1));
    CHECK_POINTS(h, VALUES(0, 0));
    nurbs_destroy(h);
    CHECK_OK(nurbs_derivative(g, 0, 0, &h));
    CHECK_POINTS(h, VALUES(0, 0, 1, 2, 3, 2, 4, 0));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_derivative(g, 0, -1, &h), NURBS_ERROR_ORDER, "order = -1");
    CHECK_NO_HANDLE(h, nurbs_derivative(g, 0, 256, &h), NURBS_ERROR_ORDER, "order = 256");
    CHECK_NO_HANDLE(h, nurbs_derivative(g, 1, 1, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_derivative(NULL, 0, 1, &h), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_derivative(g, 0, 1, NULL), NURBS_ERROR_NULL, "out is NULL");
    nurbs_destroy(g);
    g = make(jump()); /* the layer between the pieces drops out, with one copy of the knot */
    CHECK_OK(nurbs_derivative(g, 0, 1, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 1, 2));
    CHECK_POINTS(h, VALUES(1, 1));
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = make(loop());
    CHECK_OK(nurbs_derivative(g, 0, 1, &h));
    CHECK_KNOTS(h, 0, VALUES(1, 2, 3, 4, 5, 6, 7));
    CHECK_POINTS(h, VALUES(-2, 0, 0, -2, 2, 0, 0, 2, -2, 0));
    int32_t form = 0;
    CHECK_OK(nurbs_knot_form(h, 0, &form));
    CHECK(form == NURBS_FORM_PERIODIC);
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = make(hill());
    CHECK_OK(nurbs_derivative(g, 0, 2, &h)); /* unclamped: second differences */
    CHECK_KNOTS(h, 0, VALUES(2, 3, 4, 5));
    CHECK_POINTS(h, VALUES(0, -4, 0));
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void rational_derivatives(void) {
    nurbs *g = make(circle()), *h = NULL;
    int32_t degree = 0;
    double point[2];
    CHECK_OK(nurbs_derivative(g, 0, 1, &h));
    CHECK_OK(nurbs_degree(h, 0, &degree));
    CHECK(degree == 4);
    CHECK_OK(nurbs_eval(h, 1, VALUES(0), 0, 0, point, 0, 0, 0));
    CHECK(fabs(point[0]) < 1e-14 && fabs(point[1] - 8 * HALF_ROOT) < 1e-14);
    nurbs_destroy(h);
    CHECK_OK(nurbs_derivative(g, 0, 14, &h));
    CHECK_OK(nurbs_degree(h, 0, &degree));
    CHECK(degree == 30);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_derivative(g, 0, 15, &h), NURBS_ERROR_DEGREE, "derivative 15|32|axis 0|31");
    nurbs_destroy(g);
    SplineArgs a = hill(); /* a weight of 0 sends control points of the derivative to infinity */
    a.weights = VALUES(1, 1, 0, 1, 1);
    g = make(a);
    CHECK_OK(nurbs_derivative(g, 0, 1, &h));
    for (double t = 2; t <= 5; t += 0.125) {
        double derivs[2], value;
        CHECK_OK(nurbs_eval_derivs(g, 1, 1, &t, 0, 0, derivs, 0, 0, 0));
        CHECK_OK(nurbs_eval(h, 1, &t, 0, 0, &value, 0, 0, 0));
        CHECK(fabs(value - derivs[1]) < 1e-13);
    }
    nurbs_destroy(h);
    nurbs_destroy(g);
    a = stairs();
    a.weights = VALUES(1, 2, 3);
    g = make(a);
    CHECK_OK(nurbs_derivative(g, 0, 1, &h));
    CHECK_POINTS(h, VALUES(0, 0, 0));
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void integrals(void) {
    nurbs *g = make(stairs()), *h = NULL;
    CHECK_OK(nurbs_antiderivative(g, 0, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 1, 2, 3, 3));
    CHECK_POINTS(h, VALUES(0, 10, 30, 60));
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = make(jump());
    CHECK_OK(nurbs_antiderivative(g, 0, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 1, 1, 2, 2, 2));
    CHECK_POINTS(h, VALUES(0, 0, 0.5, 3, 6));
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = make(
        hill()); /* unclamped: 0 at 2, the start of the domain; the mean of points i and i + 1 at 2 + i */
    CHECK_OK(nurbs_antiderivative(g, 0, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 1, 2, 3, 4, 5, 6, 7, 7));
    double value = -1;
    CHECK_OK(nurbs_eval(h, 1, VALUES(2), 0, 0, &value, 0, 0, 0));
    CHECK(fabs(value) < 1e-15);
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = make(loop());
    CHECK_OK(nurbs_antiderivative(g, 0, &h));
    int32_t form = -1;
    CHECK_OK(nurbs_knot_form(h, 0, &form));
    CHECK(form == 0);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_antiderivative(g, 1, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_antiderivative(NULL, 0, &h), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_antiderivative(g, 0, NULL), NURBS_ERROR_NULL, "out is NULL");
    CHECK_OK(nurbs_elevate(g, 0, 29, &h));
    nurbs *none = NULL;
    CHECK_NO_HANDLE(none, nurbs_antiderivative(h, 0, &none), NURBS_ERROR_DEGREE, "degree 31|axis 0");
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = make(circle());
    CHECK_NO_HANDLE(h, nurbs_antiderivative(g, 0, &h), NURBS_ERROR_RATIONAL, "rational");
    nurbs_destroy(g);
}

static void products(void) {
    nurbs *g = make(arch()), *t = make(twist()), *c = make(circle()), *j = make(jump()), *s = make(stairs()),
          *p = make(patch()), *l = make(loop()), *h = NULL;
    double point[3];
    CHECK_OK(nurbs_product(t, t, NURBS_PRODUCT_DOT, &h)); /* 9 (t^2 + t^4 + t^6) */
    check_point(h, 1, VALUES(27), 1);
    nurbs_destroy(h);
    CHECK_OK(nurbs_product(t, t, NURBS_PRODUCT_CROSS, &h));
    check_point(h, 0.5, VALUES(0, 0, 0), 3);
    nurbs_destroy(h);
    CHECK_OK(nurbs_product(g, g, 0, &h));
    check_point(h, 0.5, VALUES(4, 2.25), 2);
    nurbs_destroy(h);
    CHECK_OK(nurbs_product(j, j, 0, &h)); /* the jump stays one */
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 1, 1, 1, 2, 2, 2));
    CHECK_POINTS(h, VALUES(0, 0, 1, 25, 30, 36));
    nurbs_destroy(h);
    CHECK_OK(nurbs_product(s, s, 0, &h));
    CHECK_POINTS(h, VALUES(100, 400, 900));
    nurbs_destroy(h);
    CHECK_OK(nurbs_product(p, p, 0, &h));
    CHECK_OK(nurbs_eval(h, 1, VALUES(0.5, 1), 0, 0, point, 0, 0, 0));
    CHECK_DOUBLE(point[0], 0.25);
    CHECK_DOUBLE(point[2], 0.25);
    nurbs_destroy(h);
    CHECK_OK(nurbs_product(l, l, 0, &h)); /* periodic stays periodic */
    int32_t form = 0;
    CHECK_OK(nurbs_knot_form(h, 0, &form));
    CHECK(form == NURBS_FORM_PERIODIC);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_product(g, t, 0, &h), NURBS_ERROR_DIMENSION, "2 of a|3 of b");
    CHECK_NO_HANDLE(h, nurbs_product(g, t, NURBS_PRODUCT_DOT, &h), NURBS_ERROR_DIMENSION, "2 of a|3 of b");
    CHECK_NO_HANDLE(h, nurbs_product(g, c, NURBS_PRODUCT_CROSS, &h), NURBS_ERROR_DIMENSION, "3 and 3");
    CHECK_NO_HANDLE(h, nurbs_product(g, j, 0, &h), NURBS_ERROR_INCOMPATIBLE,
                    "b: domain [0, 2]|axis 0|[0, 1]");
    CHECK_NO_HANDLE(h, nurbs_product(g, p, 0, &h), NURBS_ERROR_INCOMPATIBLE, "b: 2 axes|1");
    CHECK_NO_HANDLE(h, nurbs_product(g, g, 1, &h), NURBS_ERROR_FLAGS, "flags = 0x1");
    CHECK_NO_HANDLE(h, nurbs_product(g, g, NURBS_PRODUCT_DOT | NURBS_PRODUCT_CROSS, &h), NURBS_ERROR_FLAGS,
                    "0x18000000");
    CHECK_NO_HANDLE(h, nurbs_product(NULL, g, 0, &h), NURBS_ERROR_NULL, "a is NULL");
    CHECK_NO_HANDLE(h, nurbs_product(g, NULL, 0, &h), NURBS_ERROR_NULL, "b is NULL");
    CHECK_FAILS(nurbs_product(g, g, 0, NULL), NURBS_ERROR_NULL, "out is NULL");
    nurbs *high = NULL;
    CHECK_OK(nurbs_elevate(g, 0, 26, &high));
    CHECK_NO_HANDLE(h, nurbs_product(high, g, 0, &h), NURBS_ERROR_DEGREE, "29 and 3|32|31");
    nurbs_destroy(high);
    nurbs_destroy(g);
    nurbs_destroy(t);
    nurbs_destroy(c);
    nurbs_destroy(j);
    nurbs_destroy(s);
    nurbs_destroy(p);
    nurbs_destroy(l);
}

static void sums(void) {
    nurbs *g = make(arch()), *t = make(twist()), *c = make(circle()), *j = make(jump()), *l = make(loop()),
          *h = NULL;
    CHECK_OK(nurbs_sum(g, 2, g, -1, &h));
    CHECK_POINTS(h, VALUES(0, 0, 1, 2, 3, 2, 4, 0));
    nurbs_destroy(h);
    CHECK_OK(nurbs_sum(c, 0.5, c, 0.5, &h)); /* the same weights: the denominator is kept */
    int32_t degree = 0;
    CHECK_OK(nurbs_degree(h, 0, &degree));
    CHECK(degree == 2);
    check_point(h, 0.25, VALUES(0, 1), 2);
    nurbs_destroy(h);
    CHECK_OK(nurbs_sum(g, 1, c, 1, &h)); /* over the weights of the circle */
    CHECK_OK(nurbs_degree(h, 0, &degree));
    CHECK(degree == 5);
    check_point(h, 1, VALUES(5, 0), 2);
    nurbs_destroy(h);
    CHECK_OK(nurbs_sum(l, 1, l, 1, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 1, 2, 3, 4, 5, 6, 7, 8));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_sum(g, 1, t, 1, &h), NURBS_ERROR_DIMENSION, "3 of b|2");
    CHECK_NO_HANDLE(h, nurbs_sum(g, 1, j, 1, &h), NURBS_ERROR_INCOMPATIBLE, "domain [0, 2]");
    CHECK_NO_HANDLE(h, nurbs_sum(g, NAN, g, 1, &h), NURBS_ERROR_FACTOR, "alpha = nan");
    CHECK_NO_HANDLE(h, nurbs_sum(g, 1, g, INFINITY, &h), NURBS_ERROR_FACTOR, "beta = inf");
    CHECK_NO_HANDLE(h, nurbs_sum(g, 1e308, g, 1e308, &h), NURBS_ERROR_NOT_REPRESENTABLE, "overflows");
    CHECK_NO_HANDLE(h, nurbs_sum(NULL, 1, g, 1, &h), NURBS_ERROR_NULL, "a is NULL");
    CHECK_NO_HANDLE(h, nurbs_sum(g, 1, NULL, 1, &h), NURBS_ERROR_NULL, "b is NULL");
    CHECK_FAILS(nurbs_sum(g, 1, g, 1, NULL), NURBS_ERROR_NULL, "out is NULL");
    nurbs_destroy(g);
    nurbs_destroy(t);
    nurbs_destroy(c);
    nurbs_destroy(j);
    nurbs_destroy(l);
}

int main(void) {
    polar_forms();
    derivatives();
    rational_derivatives();
    integrals();
    products();
    sums();
    return check_summary("calculus");
}
