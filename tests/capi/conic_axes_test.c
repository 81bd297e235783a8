/* SPDX-License-Identifier: MIT */
/* nurbs_conic_axes(). */
#include "check.h"

#define EQUATION(...) ((const double[]){__VA_ARGS__})

typedef struct Axes {
    int32_t type;
    double origin[2], x[2], sizes[2];
} Axes;

static nurbs_status try_axes(const double *q, Axes *a) {
    return nurbs_conic_axes(q, &a->type, a->origin, a->x, a->sizes);
}

static void check_axes(const double *q, int32_t type, const double *values) {
    Axes a;
    FILL(a.origin);
    CHECK_OK(try_axes(q, &a));
    CHECK_INT(a.type, type);
    CHECK_NEAR(a.origin, values, 2, 1e-15);
    CHECK_NEAR(a.x, values + 2, 2, 1e-15);
    CHECK_NEAR(a.sizes, values + 4, 2, 2e-15);
}

static void kinds(void) {
    check_axes(EQUATION(1, 0, 1, 0, 0, -4), NURBS_CONIC_ELLIPSE, EQUATION(0, 0, 1, 0, 2, 2));
    check_axes(EQUATION(4, 0, 1, -8, 0, 0), NURBS_CONIC_ELLIPSE, EQUATION(1, 0, 0, 1, 2, 1));
    check_axes(EQUATION(-1, 0, -4, 0, 0, 4), NURBS_CONIC_ELLIPSE, EQUATION(0, 0, 1, 0, 2, 1));
    check_axes(EQUATION(0, 0, 1, -4, 0, 0), NURBS_CONIC_PARABOLA, EQUATION(0, 0, 1, 0, 1, 0));
    check_axes(EQUATION(1, 0, 0, 0, 8, 8), NURBS_CONIC_PARABOLA, EQUATION(0, -1, 0, -1, 2, 0));
    check_axes(EQUATION(1, 0, -4, 0, 0, -4), NURBS_CONIC_HYPERBOLA, EQUATION(0, 0, 1, 0, 2, 1));
    check_axes(EQUATION(1, 0, -4, 0, 0, 4), NURBS_CONIC_HYPERBOLA, EQUATION(0, 0, 0, 1, 1, 2));
    check_axes(EQUATION(0, 1, 0, 0, 0, -2), NURBS_CONIC_HYPERBOLA,
               EQUATION(0, 0, sqrt(0.5), sqrt(0.5), 2, 2));
    /* any factor, any scale */
    check_axes(EQUATION(1e-300, 0, -4e-300, 0, 0, 4e-300), NURBS_CONIC_HYPERBOLA, EQUATION(0, 0, 0, 1, 1, 2));
    check_axes(EQUATION(1, 0, 1, 0, 0, -1e-40), NURBS_CONIC_ELLIPSE, EQUATION(0, 0, 1, 0, 1e-20, 1e-20));
    /* the smallest ellipse and hyperbola beside a parabola */
    Axes a;
    CHECK_OK(try_axes(EQUATION(1, 2, 1 + 0x1p-52, 1, 0, -1), &a));
    CHECK_INT(a.type, NURBS_CONIC_ELLIPSE);
    CHECK_OK(try_axes(EQUATION(1, 2, 1 - 0x1p-53, 1, 0, -1), &a));
    CHECK_INT(a.type, NURBS_CONIC_HYPERBOLA);
    CHECK_OK(try_axes(EQUATION(1, 2, 1, 1, 0, -1), &a));
    CHECK_INT(a.type, NURBS_CONIC_PARABOLA);
}

static void bad_input(void) {
    static const double circle[] = {1, 0, 1, 0, 0, -4};
    Axes a;
    FILL(a.origin);
    FILL(a.x);
    FILL(a.sizes);
    CHECK_FAILS(nurbs_conic_axes(NULL, &a.type, a.origin, a.x, a.sizes), NURBS_ERROR_NULL, "coefficients");
    CHECK_FAILS(nurbs_conic_axes(circle, NULL, a.origin, a.x, a.sizes), NURBS_ERROR_NULL, "type");
    CHECK_FAILS(nurbs_conic_axes(circle, &a.type, NULL, a.x, a.sizes), NURBS_ERROR_NULL, "origin");
    CHECK_FAILS(nurbs_conic_axes(circle, &a.type, a.origin, NULL, a.sizes), NURBS_ERROR_NULL, "x");
    CHECK_FAILS(nurbs_conic_axes(circle, &a.type, a.origin, a.x, NULL), NURBS_ERROR_NULL, "sizes");
    CHECK_FAILS(nurbs_conic_axes(circle, &a.type, a.origin, a.origin, a.sizes), NURBS_ERROR_OVERLAP, "x");
    CHECK_FAILS(try_axes(edited(circle, 6, 3, NAN), &a), NURBS_ERROR_FACTOR, "coefficients[3]|nan");
    CHECK_FAILS(try_axes(edited(circle, 6, 5, INFINITY), &a), NURBS_ERROR_FACTOR, "coefficients[5]|inf");
    CHECK_FAILS(try_axes(edited(circle, 6, 5, 0), &a), NURBS_ERROR_CONIC, "coefficients");    /* one point */
    CHECK_FAILS(try_axes(edited(circle, 6, 5, 1), &a), NURBS_ERROR_CONIC, "coefficients");    /* none */
    CHECK_FAILS(try_axes(EQUATION(0, 0, 0, 1, 1, 1), &a), NURBS_ERROR_CONIC, "coefficients"); /* a line */
    CHECK_FAILS(try_axes(EQUATION(0, 0, 0, 0, 0, 0), &a), NURBS_ERROR_CONIC, "coefficients");
    CHECK_FAILS(try_axes(EQUATION(1, 0, 0, 0, 0, -1), &a), NURBS_ERROR_CONIC, "coefficients"); /* parallels */
    CHECK_FAILS(try_axes(EQUATION(1, 0, -1, 0, 0, 0), &a), NURBS_ERROR_CONIC, "coefficients"); /* a cross */
    CHECK_FAILS(try_axes(EQUATION(1, 0, 1e-300, 0, 1e300, -1), &a), NURBS_ERROR_NOT_REPRESENTABLE,
                "overflow");
    CHECK_UNTOUCHED(a.origin);
    CHECK_UNTOUCHED(a.x);
    CHECK_UNTOUCHED(a.sizes);
}

int main(void) {
    kinds();
    bad_input();
    return check_summary("conic_axes");
}
