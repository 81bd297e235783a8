/* SPDX-License-Identifier: MIT */
/* nurbs_elevate(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

static nurbs *elevated(SplineArgs a, int32_t axis, int32_t times) {
    nurbs *g = make(a), *h = NULL;
    int32_t degree = -1;
    CHECK_OK(nurbs_elevate(g, axis, times, &h));
    CHECK_POINTS(g, a.points);
    CHECK_OK(nurbs_degree(h, axis, &degree));
    CHECK_INT(degree, a.degrees[axis] + times);
    nurbs_destroy(g);
    return h;
}

/* Q_i = (i P_i-1 + (4 - i) P_i) / 4 for a cubic Bezier curve. */
static void known_points(void) {
    nurbs *h = elevated(arch(), 0, 1);
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 0, 0, 1, 1, 1, 1, 1));
    CHECK_POINTS(h, VALUES(0, 0, 0.75, 1.5, 2, 2, 3.25, 1.5, 4, 0));
    nurbs_destroy(h);
    h = elevated(arch(), 0, 0);
    CHECK_POINTS(h, arch().points);
    nurbs_destroy(h);
    h = elevated(stairs(), 0, 1);
    CHECK_KNOTS(h, 0, VALUES(0, 0, 1, 1, 2, 2, 3, 3));
    CHECK_POINTS(h, VALUES(10, 10, 20, 20, 30, 30));
    nurbs_destroy(h);
    h = elevated(jump(), 0, 1);
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 1, 1, 1, 2, 2, 2));
    CHECK_POINTS(h, VALUES(0, 0.5, 1, 5, 5.5, 6));
    nurbs_destroy(h);
}

/* Beyond the domain only the knots that functions on it need are kept; the new copy of an end of a periodic
 * domain stands behind it. */
static void knots_of_open_forms(void) {
    int32_t form = 0;
    nurbs *h = elevated(hill(), 0, 1);
    CHECK_KNOTS(h, 0, VALUES(1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6));
    nurbs_destroy(h);
    h = elevated(loop(), 0, 1);
    CHECK_OK(nurbs_knot_form(h, 0, &form));
    CHECK_INT(form, NURBS_FORM_PERIODIC);
    CHECK_KNOTS(h, 0, VALUES(0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7));
    double p[22];
    CHECK_OK(nurbs_points(h, 11, p, 0, 0));
    CHECK_BITS(p, p + 16, 6 * sizeof *p);
    nurbs_destroy(h);
}

/* The shape stays, within 2 eps hull for each step and c eps hull for either evaluation. */
static void same_shape(SplineArgs a, int32_t axis, int32_t times, double c, double hull) {
    nurbs *g = make(a), *h = elevated(a, axis, times);
    double domain[3][2];
    for (int32_t k = 0; k < a.axes; ++k) {
        CHECK_OK(nurbs_domain(g, k, domain[k]));
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
    same_shape(arch(), 0, 2, 8, 4);
    same_shape(arch(), 0, 28, 32, 4);
    same_shape(circle(), 0, 3, 8, 2);
    same_shape(hill(), 0, 3, 8, 4);
    same_shape(loop(), 0, 4, 8, 1);
    same_shape(jump(), 0, 2, 4, 6);
    same_shape(trough(), 0, 2, 10, 4);
    same_shape(trough(), 1, 1, 8, 4);
    same_shape(cube(), 2, 3, 12, 1);
}

static void bad_arguments(void) {
    static const int32_t axes[] = {-1, 1, 3, INT32_MAX, INT32_MIN};
    nurbs *g = make(hill()), *h = NULL;
    CHECK_NO_HANDLE(h, nurbs_elevate(NULL, 0, 1, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_elevate(g, 0, 1, NULL), NURBS_ERROR_NULL, "out");
    for (int i = 0; i < 5; ++i) {
        CHECK_NO_HANDLE(h, nurbs_elevate(g, axes[i], 1, &h), NURBS_ERROR_AXIS, "axis");
    }
    CHECK_NO_HANDLE(h, nurbs_elevate(g, 0, -1, &h), NURBS_ERROR_TIMES, "times = -1");
    CHECK_NO_HANDLE(h, nurbs_elevate(g, 0, INT32_MIN, &h), NURBS_ERROR_TIMES, "times");
    CHECK_NO_HANDLE(h, nurbs_elevate(g, 0, 30, &h), NURBS_ERROR_DEGREE, "degree 2|axis 0|times = 30|31");
    CHECK_NO_HANDLE(h, nurbs_elevate(g, 0, INT32_MAX, &h), NURBS_ERROR_DEGREE, "degree 2|2147483647");
    CHECK_POINTS(g, hill().points);
    CHECK_KNOTS(g, 0, hill().knots);
    nurbs_destroy(g);
}

int main(void) {
    known_points();
    knots_of_open_forms();
    shapes_stay();
    bad_arguments();
    return check_summary("elevate");
}
