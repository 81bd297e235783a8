/* SPDX-License-Identifier: MIT */
/* nurbs_iso(): iso-curves and iso-surfaces. */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

/* Evaluates g at one parameter and compares. */
static void value_is(const nurbs *g, const double *param, const double *expected, int dim, double bound) {
    double point[4];
    CHECK_OK(nurbs_eval(g, 1, param, 0, 0, point, 0, 0, 0));
    CHECK_NEAR(point, expected, dim, bound);
}

#define VALUES(...) ((const double[]){__VA_ARGS__})

/* trough: S(u, v) = (u, v, u^2 + v). */
static void curves_of_a_surface(void) {
    static const double u_knots[] = {0, 0, 0, 1, 1, 1}, v_knots[] = {0, 0, 1, 2, 3, 3};
    int32_t axes = 0, degree = 0, rational = -1;
    nurbs *g = make(trough()), *c = NULL;
    CHECK_OK(nurbs_iso(g, 1, 1.5, 0, &c));
    CHECK_OK(nurbs_axes(c, &axes));
    CHECK_INT(axes, 1);
    CHECK_OK(nurbs_degree(c, 0, &degree));
    CHECK_INT(degree, 2);
    CHECK_OK(nurbs_is_rational(c, &rational));
    CHECK_INT(rational, 0);
    CHECK_KNOTS(c, 0, u_knots);
    CHECK_POINTS(c, VALUES(0, 1.5, 1.5, 0.5, 1.5, 1.5, 1, 1.5, 2.5));
    value_is(c, VALUES(0.25), VALUES(0.25, 1.5, 1.5625), 3, 0);
    nurbs_destroy(c);
    CHECK_OK(nurbs_iso(g, 0, 0.5, 0, &c));
    CHECK_KNOTS(c, 0, v_knots);
    CHECK_POINTS(c, VALUES(0.5, 0, 0.25, 0.5, 1, 1.25, 0.5, 2, 2.25, 0.5, 3, 3.25));
    nurbs_destroy(c);
    nurbs_destroy(g);
}

/* At the ends the boundary points themselves are the curve, bit for bit. */
static void boundaries(void) {
    nurbs *g = make(trough()), *c = NULL;
    CHECK_OK(nurbs_iso(g, 0, 0, 0, &c));
    CHECK_POINTS(c, trough().points);
    nurbs_destroy(c);
    CHECK_OK(nurbs_iso(g, 0, 1, 0, &c));
    CHECK_POINTS(c, trough().points + 24);
    nurbs_destroy(c);
    CHECK_OK(nurbs_iso(g, 1, 3, 0, &c));
    CHECK_POINTS(c, VALUES(0, 3, 3, 0.5, 3, 3, 1, 3, 4));
    nurbs_destroy(c);
    nurbs_destroy(g);
}

/* cube: V = (u, v, w, u v w); fixing the middle axis keeps u and w in order. */
static void surfaces_of_a_volume(void) {
    int32_t axes = 0;
    nurbs *g = make(cube()), *s = NULL, *c = NULL;
    for (int32_t k = 0; k < 3; ++k) {
        double at[3] = {0.5, 0.5, 0.5}, rest[2] = {0.125, 0.75}, point[4];
        at[k] = 0.25;
        at[k == 0 ? 1 : 0] = rest[0];
        at[k == 2 ? 1 : 2] = rest[1];
        CHECK_OK(nurbs_iso(g, k, 0.25, 0, &s));
        CHECK_OK(nurbs_axes(s, &axes));
        CHECK_INT(axes, 2);
        CHECK_OK(nurbs_eval(g, 1, at, 0, 0, point, 0, 0, 0));
        value_is(s, rest, point, 4, 0);
        nurbs_destroy(s);
    }
    CHECK_OK(nurbs_iso(g, 1, 0.25, 0, &s));
    nurbs_destroy(g);
    CHECK_OK(nurbs_iso(s, 1, 0.5, 0, &c));
    nurbs_destroy(s);
    value_is(c, VALUES(0.75), VALUES(0.75, 0.25, 0.5, 0.09375), 4, 0);
    nurbs_destroy(c);
}

/* A cylinder over the periodic loop: what is left stays periodic, or was not. */
static void periodic_axes(void) {
    static const int32_t degrees[] = {2, 1};
    static const int64_t counts[] = {6, 2};
    static const double knots[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 0, 0, 1, 1};
    static const double points[] = {1, 5, 2, 6, 3, 7, 4, 8, 1, 5, 2, 6};
    SplineArgs a = {2, degrees, counts, knots, 13, 1, points, 0, 0, NULL, 0, NURBS_PERIODIC};
    int32_t form = -1;
    nurbs *g = make(a), *c = NULL;
    CHECK_OK(nurbs_iso(g, 1, 0.5, 0, &c));
    CHECK_OK(nurbs_knot_form(c, 0, &form));
    CHECK_INT(form, NURBS_FORM_PERIODIC);
    CHECK_POINTS(c, VALUES(3, 4, 5, 6, 3, 4));
    nurbs_destroy(c);
    CHECK_OK(nurbs_iso(g, 0, 3, 0, &c));
    CHECK_OK(nurbs_knot_form(c, 0, &form));
    CHECK_INT(form, NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END);
    CHECK_POINTS(c, VALUES(2.5, 6.5));
    nurbs_destroy(c);
    CHECK_OK(nurbs_iso(g, 0, 7, NURBS_WRAP, &c));
    CHECK_POINTS(c, VALUES(2.5, 6.5));
    nurbs_destroy(c);
    nurbs_destroy(g);
}

/* Weights change with the other points: a patch with weights 1, 3 at v = 0, 1. */
static SplineArgs weighted_patch(void) {
    static const double weights[] = {1, 3, 1, 3};
    SplineArgs a = patch();
    a.weights = weights;
    return a;
}

static void rational(void) {
    double point[3];
    nurbs *g = make(weighted_patch()), *c = NULL;
    CHECK_OK(nurbs_iso(g, 1, 0.5, 0, &c));
    CHECK_OK(nurbs_eval(g, 1, VALUES(0.25, 0.5), 0, 0, point, 0, 0, 0));
    value_is(c, VALUES(0.25), point, 3, 2 * 6 * 0x1p-52);
    value_is(c, VALUES(0.25), VALUES(0.25, 0.75, 0.1875), 3, 2 * 6 * 0x1p-52);
    nurbs_destroy(c);
    CHECK_NO_HANDLE(c, nurbs_iso(g, 1, -0.5, NURBS_EXTRAPOLATE, &c), NURBS_ERROR_WEIGHTS_VANISH, "");
    CHECK_NO_HANDLE(c, nurbs_iso(g, 1, -2, NURBS_EXTRAPOLATE, &c), NURBS_ERROR_WEIGHT_NEGATIVE, "");
    nurbs_destroy(g);
}

static void flags(void) {
    nurbs *g = make(patch()), *c = NULL;
    CHECK_OK(nurbs_iso(g, 0, 7, NURBS_CLAMP, &c));
    CHECK_POINTS(c, patch().points + 6);
    nurbs_destroy(c);
    CHECK_OK(nurbs_iso(g, 0, -INFINITY, NURBS_CLAMP, &c));
    CHECK_POINTS(c, patch().points);
    nurbs_destroy(c);
    CHECK_OK(nurbs_iso(g, 1, 2, NURBS_EXTRAPOLATE, &c));
    CHECK_POINTS(c, VALUES(0, 2, 0, 1, 2, 2));
    nurbs_destroy(c);
    CHECK_OK(nurbs_iso(g, 1, 1, NURBS_WRAP, &c));
    CHECK_POINTS(c, VALUES(0, 0, 0, 1, 0, 0));
    nurbs_destroy(c);
    CHECK_OK(nurbs_iso(g, 1, 1, NURBS_WRAP | NURBS_LEFT, &c));
    CHECK_POINTS(c, VALUES(0, 1, 0, 1, 1, 1));
    nurbs_destroy(c);
    nurbs_destroy(g);
}

/* The side is taken at a jump of the axis that is fixed. */
static void sides(void) {
    static const int32_t degrees[] = {1, 0};
    static const int64_t counts[] = {2, 2};
    static const double knots[] = {0, 0, 1, 1, 0, 1, 2}, points[] = {1, 5, 2, 6};
    SplineArgs a = {2, degrees, counts, knots, 7, 1, points, 0, 0, NULL, 0, 0};
    nurbs *g = make(a), *c = NULL;
    CHECK_OK(nurbs_iso(g, 1, 1, 0, &c));
    CHECK_POINTS(c, VALUES(5, 6));
    nurbs_destroy(c);
    CHECK_OK(nurbs_iso(g, 1, 1, NURBS_LEFT, &c));
    CHECK_POINTS(c, VALUES(1, 2));
    nurbs_destroy(c);
    nurbs_destroy(g);
}

static void bad_arguments(void) {
    static const uint32_t bad[] = {NURBS_NAN,
                                   NURBS_NAN | NURBS_CLAMP,
                                   NURBS_CLAMP | NURBS_WRAP,
                                   NURBS_CLAMP | NURBS_EXTRAPOLATE,
                                   0x20u,
                                   0x80u,
                                   NURBS_ON_AXIS(1, NURBS_CLAMP),
                                   NURBS_ON_AXIS(2, NURBS_LEFT),
                                   0x01000000u,
                                   0xffffffffu};
    static const int32_t axes[] = {-1, 2, INT32_MAX, INT32_MIN};
    nurbs *g = make(patch()), *curve = make(arch()), *c = NULL;
    CHECK_NO_HANDLE(c, nurbs_iso(NULL, 0, 0.5, 0, &c), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_iso(g, 0, 0.5, 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(c, nurbs_iso(curve, 0, 0.5, 0, &c), NURBS_ERROR_AXES, "1");
    for (int i = 0; i < 4; ++i) {
        CHECK_NO_HANDLE(c, nurbs_iso(g, axes[i], 0.5, 0, &c), NURBS_ERROR_AXIS, "axis");
    }
    for (int i = 0; i < 10; ++i) {
        CHECK_NO_HANDLE(c, nurbs_iso(g, 1, 0.5, bad[i], &c), NURBS_ERROR_FLAGS, "flags");
    }
    CHECK_NO_HANDLE(c, nurbs_iso(g, 0, NAN, 0, &c), NURBS_ERROR_PARAMETER_NOT_FINITE, "param|nan");
    CHECK_NO_HANDLE(c, nurbs_iso(g, 0, INFINITY, 0, &c), NURBS_ERROR_PARAMETER_NOT_FINITE, "param|inf");
    CHECK_NO_HANDLE(c, nurbs_iso(g, 0, INFINITY, NURBS_WRAP, &c), NURBS_ERROR_PARAMETER_NOT_FINITE,
                    "param|inf");
    CHECK_NO_HANDLE(c, nurbs_iso(g, 0, NAN, NURBS_CLAMP, &c), NURBS_ERROR_PARAMETER_NOT_FINITE, "param|nan");
    CHECK_NO_HANDLE(c, nurbs_iso(g, 0, 1.5, 0, &c), NURBS_ERROR_OUTSIDE_DOMAIN, "param|1.5|0|1");
    CHECK_NO_HANDLE(c, nurbs_iso(g, 1, -0.25, NURBS_LEFT, &c), NURBS_ERROR_OUTSIDE_DOMAIN, "param|-0.25|0|1");
    nurbs_destroy(g);
    nurbs_destroy(curve);
}

static void overflow(void) {
    static const int32_t degrees[] = {2, 1};
    static const double points[] = {0, 0, 1e300, 1e300, 0, 0};
    nurbs *g = NULL, *c = NULL;
    CHECK_OK(nurbs_create_bezier(2, degrees, 1, points, 0, 0, NULL, 0, &g));
    CHECK_NO_HANDLE(c, nurbs_iso(g, 0, 1e100, NURBS_EXTRAPOLATE, &c), NURBS_ERROR_NOT_REPRESENTABLE, "");
    nurbs_destroy(g);
}

int main(void) {
    curves_of_a_surface();
    boundaries();
    surfaces_of_a_volume();
    periodic_axes();
    rational();
    flags();
    sides();
    bad_arguments();
    overflow();
    return check_summary("iso");
}
