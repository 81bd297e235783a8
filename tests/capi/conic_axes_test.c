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

/* Ellipses and hyperbolas whose axes differ by more than the range of a double has powers of two for their
 * squares: with axes of 1e-100 and 1e100, A / C = 1e400. */
static void long_and_thin(void) {
    static const double tilt = 0x1p-330;
    Axes a;
    for (int power = 10; power <= 330; power += 40) {
        const double s = ldexp(1, power);
        for (int side = -1; side <= 1; side += 2) { /* s^2 x^2 + side y^2 / s^2 = 1, and x and y exchanged */
            CHECK_OK(try_axes(EQUATION(s * s, 0, side / s / s, 0, 0, -1), &a));
            CHECK_INT(a.type, side > 0 ? NURBS_CONIC_ELLIPSE : NURBS_CONIC_HYPERBOLA);
            CHECK_NEAR(a.sizes, ((const double[]){side > 0 ? s : 1 / s, side > 0 ? 1 / s : s}), 2, 1e-15 * s);
            CHECK_NEAR(&a.sizes[side > 0], &(double){1 / s}, 1, 1e-15 / s);
            CHECK_DOUBLES(a.x, ((const double[]){side<0, side> 0}), 2);
            CHECK_OK(try_axes(EQUATION(side / s / s, 0, s * s, 0, 0, -1), &a));
            CHECK_NEAR(&a.sizes[side > 0], &(double){1 / s}, 1, 1e-15 / s);
            CHECK_NEAR(&a.sizes[side < 0], &(double){s}, 1, 1e-15 * s);
            CHECK_DOUBLES(a.x, ((const double[]){side > 0, side < 0}), 2);
        }
        /* about (3 / s, 5 s): s^2 (x - 3 / s)^2 + (y / s - 5)^2 = 1 */
        CHECK_OK(try_axes(EQUATION(s * s, 0, 1 / s / s, -6 * s, -10 / s, 33), &a));
        CHECK_NEAR(&a.origin[0], &(double){3 / s}, 1, 1e-14 / s);
        CHECK_NEAR(&a.origin[1], &(double){5 * s}, 1, 1e-14 * s);
        CHECK_NEAR(&a.sizes[0], &(double){s}, 1, 1e-13 * s);
        CHECK_NEAR(&a.sizes[1], &(double){1 / s}, 1, 1e-13 / s);
    }
    /* (x / t + y t)^2 + y^2 t^2 = 1 */
    CHECK_OK(try_axes(EQUATION(1 / tilt / tilt, 2, 2 * tilt * tilt, 0, 0, -1), &a));
    CHECK_INT(a.type, NURBS_CONIC_ELLIPSE);
    CHECK_NEAR(&a.sizes[0], &(double){1 / tilt}, 1, 1e-15 / tilt);
    CHECK_NEAR(&a.sizes[1], &tilt, 1, 1e-15 * tilt);
    CHECK_NEAR(&a.x[0], &(double){tilt * tilt}, 1, 1e-15 * tilt * tilt);
    CHECK_DOUBLE(a.x[1], -1);
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
    long_and_thin();
    bad_input();
    return check_summary("conic_axes");
}
