/* SPDX-License-Identifier: MIT */
/* nurbs_insert_knot(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

static nurbs *inserted(SplineArgs a, int32_t axis, double knot, int32_t times) {
    nurbs *g = make(a), *h = NULL;
    CHECK_OK(nurbs_insert_knot(g, axis, knot, times, &h));
    CHECK_POINTS(g, a.points);
    nurbs_destroy(g);
    return h;
}

/* The points of de Casteljau's scheme at 1/2; the fourth time the curve falls apart into its two halves. */
static void cubic_in_the_middle(void) {
    nurbs *h = inserted(arch(), 0, 0.5, 1);
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 0, 0.5, 1, 1, 1, 1));
    CHECK_POINTS(h, VALUES(0, 0, 0.5, 1, 2, 2, 3.5, 1, 4, 0));
    nurbs_destroy(h);
    h = inserted(arch(), 0, 0.5, 3);
    CHECK_POINTS(h, VALUES(0, 0, 0.5, 1, 1.25, 1.5, 2, 1.5, 2.75, 1.5, 3.5, 1, 4, 0));
    nurbs_destroy(h);
    h = inserted(arch(), 0, 0.5, 4);
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 0, 0.5, 0.5, 0.5, 0.5, 1, 1, 1, 1));
    CHECK_POINTS(h, VALUES(0, 0, 0.5, 1, 1.25, 1.5, 2, 1.5, 2, 1.5, 2.75, 1.5, 3.5, 1, 4, 0));
    nurbs_destroy(h);
    h = inserted(arch(), 0, 0.5, 0);
    CHECK_KNOTS(h, 0, arch().knots);
    CHECK_POINTS(h, arch().points);
    nurbs_destroy(h);
}

/* Beside an existing knot, at it, and at an unclamped end of the domain. */
static void other_places(void) {
    nurbs *h = inserted(hill(), 0, 2, 1);
    CHECK_KNOTS(h, 0, VALUES(0, 1, 2, 2, 3, 4, 5, 6, 7));
    CHECK_POINTS(h, VALUES(0, 1, 2, 4, 2, 0));
    nurbs_destroy(h);
    h = inserted(hill(), 0, 3.5, 1);
    CHECK_POINTS(h, VALUES(0, 2, 3.5, 3.5, 2, 0));
    nurbs_destroy(h);
    h = inserted(stairs(), 0, 1.5, 1);
    CHECK_KNOTS(h, 0, VALUES(0, 1, 1.5, 2, 3));
    CHECK_POINTS(h, VALUES(10, 20, 20, 30));
    nurbs_destroy(h);
}

static void both_axes_of_a_surface(void) {
    nurbs *h = inserted(patch(), 0, 0.25, 1);
    CHECK_POINTS(h, VALUES(0, 0, 0, 0, 1, 0, 0.25, 0, 0, 0.25, 1, 0.25, 1, 0, 0, 1, 1, 1));
    CHECK_KNOTS(h, 1, VALUES(0, 0, 1, 1));
    nurbs_destroy(h);
    h = inserted(patch(), 1, 0.25, 1);
    CHECK_POINTS(h, VALUES(0, 0, 0, 0, 0.25, 0, 0, 1, 0, 1, 0, 0, 1, 0.25, 0.25, 1, 1, 1));
    CHECK_KNOTS(h, 1, VALUES(0, 0, 0.25, 1, 1));
    nurbs_destroy(h);
}

/* The shape stays, within 2 eps hull for each step and 2 c eps hull for the two evaluations. */
static void same_shape(SplineArgs a, int32_t axis, double knot, int32_t times, double c, double hull) {
    nurbs *g = make(a), *h = NULL;
    double domain[3][2];
    CHECK_OK(nurbs_insert_knot(g, axis, knot, times, &h));
    for (int32_t k = 0; k < a.axes; ++k) {
        CHECK_OK(nurbs_domain(h, k, domain[k]));
    }
    for (int i = 0; i <= 64; ++i) {
        double param[3], before[4], after[4];
        for (int k = 0; k < a.axes; ++k) {
            param[k] = domain[k][0] + (domain[k][1] - domain[k][0]) * ((i * (2 * k + 1)) % 65) / 64;
        }
        CHECK_OK(nurbs_eval(g, 1, param, 0, 0, before, 0, 0, 0));
        CHECK_OK(nurbs_eval(h, 1, param, 0, 0, after, 0, 0, 0));
        CHECK_NEAR(after, before, a.dim, (2 * times + 2 * c) * 0x1p-52 * hull);
    }
    nurbs_destroy(g);
    nurbs_destroy(h);
}

static void shapes_stay(void) {
    same_shape(arch(), 0, 0.3, 2, 4, 4);
    same_shape(circle(), 0, 0.1, 3, 4, 1);
    same_shape(circle(), 0, 0.25, 1, 4, 1);
    same_shape(hill(), 0, 4.9, 3, 4, 4);
    same_shape(loop(), 0, 2.7, 2, 4, 1);
    same_shape(jump(), 0, 1.3, 2, 3, 6);
    same_shape(trough(), 0, 0.7, 3, 7, 4);
    same_shape(trough(), 1, 1, 1, 7, 4);
    same_shape(cube(), 2, 0.6, 2, 9, 1);
}

/* Zero weights keep their points where the new knot does not reach. */
static void weights_follow(void) {
    static const int32_t degree = 1;
    static const int64_t count = 3;
    static const double knots[] = {0, 0, 1, 2, 2}, points[] = {1, 5, 7}, weights[] = {1, 3, 0.25};
    nurbs *g = NULL, *h = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 5, 1, points, 0, 0, weights, 0, 0, &g));
    CHECK_OK(nurbs_insert_knot(g, 0, 0.5, 1, &h));
    CHECK_WEIGHTS(h, VALUES(1, 2, 3, 0.25));
    CHECK_POINTS(h, VALUES(1, 4, 5, 7));
    nurbs_destroy(g);
    nurbs_destroy(h);
}

/* Copies one period away are inserted too, and the end of the domain is its start. */
static void periodic(void) {
    int32_t form = 0;
    int64_t count = 0;
    nurbs *h = inserted(loop(), 0, 2.5, 1), *k = NULL;
    CHECK_OK(nurbs_knot_form(h, 0, &form));
    CHECK_INT(form, NURBS_FORM_PERIODIC);
    CHECK_OK(nurbs_count(h, 0, &count));
    CHECK_INT(count, 7);
    CHECK_KNOTS(h, 0, VALUES(0, 1, 2, 2.5, 3, 4, 5, 6, 6.5, 7));
    nurbs_destroy(h);
    h = inserted(loop(), 0, 2, 1);
    k = inserted(loop(), 0, 6, 1);
    double a[10], b[10], p[14], q[14];
    CHECK_OK(nurbs_knots(h, 0, 10, a));
    CHECK_OK(nurbs_knots(k, 0, 10, b));
    CHECK_BITS(a, b, sizeof a);
    CHECK_OK(nurbs_points(h, 7, p, 0, 0));
    CHECK_OK(nurbs_points(k, 7, q, 0, 0));
    CHECK_BITS(p, q, sizeof p);
    CHECK_BITS(p, p + 10, 4 * sizeof *p);
    nurbs_destroy(h);
    nurbs_destroy(k);
}

static void multiplicities(void) {
    nurbs *g = make(arch()), *h = NULL;
    CHECK_NO_HANDLE(h, nurbs_insert_knot(g, 0, 0.5, 5, &h), NURBS_ERROR_MULTIPLICITY,
                    "knot = 0.5|times = 5|= 4");
    CHECK_NO_HANDLE(h, nurbs_insert_knot(g, 0, 0, 1, &h), NURBS_ERROR_MULTIPLICITY, "knot = 0 |4|times = 1");
    CHECK_NO_HANDLE(h, nurbs_insert_knot(g, 0, 1, 1, &h), NURBS_ERROR_MULTIPLICITY, "knot = 1 |4|times = 1");
    CHECK_NO_HANDLE(h, nurbs_insert_knot(g, 0, 0.5, INT32_MAX, &h), NURBS_ERROR_MULTIPLICITY, "0.5");
    nurbs_destroy(g);
    g = make(loop());
    CHECK_NO_HANDLE(h, nurbs_insert_knot(g, 0, 6, 3, &h), NURBS_ERROR_MULTIPLICITY,
                    "knot = 2 |times = 3|= 3");
    nurbs_destroy(g);
    g = make(circle());
    CHECK_NO_HANDLE(h, nurbs_insert_knot(g, 0, 0.5, 2, &h), NURBS_ERROR_MULTIPLICITY,
                    "knot = 0.5|times = 2|= 3");
    nurbs_destroy(g);
}

static void bad_arguments(void) {
    static const int32_t axes[] = {-1, 1, 3, INT32_MAX, INT32_MIN};
    nurbs *g = make(hill()), *h = NULL;
    CHECK_NO_HANDLE(h, nurbs_insert_knot(NULL, 0, 3, 1, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_insert_knot(g, 0, 3, 1, NULL), NURBS_ERROR_NULL, "out");
    for (int i = 0; i < 5; ++i) {
        CHECK_NO_HANDLE(h, nurbs_insert_knot(g, axes[i], 3, 1, &h), NURBS_ERROR_AXIS, "axis");
    }
    CHECK_NO_HANDLE(h, nurbs_insert_knot(g, 0, NAN, 1, &h), NURBS_ERROR_PARAMETER_NOT_FINITE, "knot|nan");
    CHECK_NO_HANDLE(h, nurbs_insert_knot(g, 0, INFINITY, 1, &h), NURBS_ERROR_PARAMETER_NOT_FINITE,
                    "knot|inf");
    CHECK_NO_HANDLE(h, nurbs_insert_knot(g, 0, -INFINITY, 0, &h), NURBS_ERROR_PARAMETER_NOT_FINITE,
                    "knot|inf");
    CHECK_NO_HANDLE(h, nurbs_insert_knot(g, 0, 1.5, 1, &h), NURBS_ERROR_OUTSIDE_DOMAIN, "knot|1.5|2|5");
    CHECK_NO_HANDLE(h, nurbs_insert_knot(g, 0, 5.5, 1, &h), NURBS_ERROR_OUTSIDE_DOMAIN, "knot|5.5|2|5");
    CHECK_NO_HANDLE(h, nurbs_insert_knot(g, 0, 1.5, 0, &h), NURBS_ERROR_OUTSIDE_DOMAIN, "knot|1.5|2|5");
    CHECK_NO_HANDLE(h, nurbs_insert_knot(g, 0, 3, -1, &h), NURBS_ERROR_TIMES, "times|-1");
    CHECK_NO_HANDLE(h, nurbs_insert_knot(g, 0, 3, INT32_MIN, &h), NURBS_ERROR_TIMES, "times");
    CHECK_POINTS(g, hill().points);
    CHECK_KNOTS(g, 0, hill().knots);
    nurbs_destroy(g);
}

int main(void) {
    cubic_in_the_middle();
    other_places();
    both_axes_of_a_surface();
    shapes_stay();
    weights_follow();
    periodic();
    multiplicities();
    bad_arguments();
    return check_summary("insert_knot");
}
