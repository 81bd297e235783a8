/* SPDX-License-Identifier: MIT */
/* nurbs_create_hermite(), nurbs_to_hermite() and nurbs_basis_matrix(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

static void check_matrix(int32_t from, int32_t to, const double *expected) {
    double m[16];
    CHECK_OK(nurbs_basis_matrix(from, to, 3, 16, m));
    CHECK_DOUBLES(m, expected, 16);
}

static void matrices(void) {
    const double third = 1.0 / 3, sixth = 1.0 / 6;
    check_matrix(NURBS_BASIS_BERNSTEIN, NURBS_BASIS_POWER,
                 VALUES(1, 0, 0, 0, -3, 3, 0, 0, 3, -6, 3, 0, -1, 3, -3, 1));
    check_matrix(NURBS_BASIS_POWER, NURBS_BASIS_BERNSTEIN,
                 VALUES(1, 0, 0, 0, 1, third, 0, 0, 1, 2.0 / 3, third, 0, 1, 1, 1, 1));
    check_matrix(NURBS_BASIS_HERMITE, NURBS_BASIS_BERNSTEIN,
                 VALUES(1, 0, 0, 0, 1, third, 0, 0, 0, 0, 1, -third, 0, 0, 1, 0));
    check_matrix(NURBS_BASIS_BERNSTEIN, NURBS_BASIS_HERMITE,
                 VALUES(1, 0, 0, 0, -3, 3, 0, 0, 0, 0, 0, 1, 0, 0, -3, 3));
    check_matrix(NURBS_BASIS_HERMITE, NURBS_BASIS_POWER,
                 VALUES(1, 0, 0, 0, 0, 1, 0, 0, -3, -2, 3, -1, 2, 1, -2, 1));
    check_matrix(NURBS_BASIS_BSPLINE, NURBS_BASIS_BERNSTEIN,
                 VALUES(sixth, 2.0 / 3, sixth, 0, 0, 2.0 / 3, third, 0, 0, third, 2.0 / 3, 0, 0, sixth,
                        2.0 / 3, sixth));
    check_matrix(NURBS_BASIS_BERNSTEIN, NURBS_BASIS_BSPLINE,
                 VALUES(6, -7, 2, 0, 0, 2, -1, 0, 0, -1, 2, 0, 0, 2, -7, 6));
    check_matrix(
        NURBS_BASIS_BSPLINE, NURBS_BASIS_POWER,
        VALUES(sixth, 2.0 / 3, sixth, 0, -0.5, 0, 0.5, 0, 0.5, -1, 0.5, 0, -sixth, 0.5, -0.5, sixth));
    check_matrix(NURBS_BASIS_BSPLINE, NURBS_BASIS_BSPLINE,
                 VALUES(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1));
}

static void hermite(void) {
    nurbs *h = NULL;
    const double points[] = {0, 0, 3, 1, 3, 4}, tangents[] = {3, 0, 0, 3, -3, 0};
    CHECK_OK(nurbs_create_hermite(3, VALUES(0, 1, 3), 2, points, 0, 0, tangents, 0, 0, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 0, 1, 1, 3, 3, 3, 3));
    CHECK_POINTS(h, VALUES(0, 0, 1, 0, 3, 0, 3, 3, 5, 4, 3, 4));
    double derivs[12];
    CHECK_OK(nurbs_eval_derivs(h, 1, 3, VALUES(0, 1, 3), 0, 0, derivs, 0, 0, 0));
    CHECK_DOUBLES(derivs, VALUES(0, 0, 3, 0, 3, 1, 0, 3, 3, 4, -3, 0), 12);
    double params[3], back[6], slopes[6];
    int64_t count = 0;
    CHECK_OK(nurbs_to_hermite(h, 0, NULL, NULL, NULL, &count));
    CHECK_INT(count, 3);
    CHECK_OK(nurbs_to_hermite(h, 3, params, back, slopes, &count));
    CHECK_DOUBLES(params, VALUES(0, 1, 3), 3);
    CHECK_DOUBLES(back, points, 6);
    CHECK_DOUBLES(slopes, tangents, 6);
    FILL(back);
    CHECK_OK(nurbs_to_hermite(h, 9, NULL, NULL, slopes, NULL));
    CHECK_OK(nurbs_to_hermite(h, 0, params, back, slopes, NULL));
    CHECK_UNTOUCHED(back);
    nurbs_destroy(h);
}

/* A parabola of degree 2, unclamped: C' = 2, 0, ... are the differences of its points. */
static void lower_degrees(void) {
    double params[5], points[10], tangents[10];
    nurbs *g = make(hill());
    CHECK_OK(nurbs_to_hermite(g, 4, params, points, tangents, NULL));
    CHECK_DOUBLES(params, VALUES(2, 3, 4, 5), 4);
    CHECK_DOUBLES(points, VALUES(1, 3, 3, 1), 4);
    CHECK_DOUBLES(tangents, VALUES(2, 2, -2, -2), 4);
    nurbs_destroy(g);
    g = make(loop());
    CHECK_OK(nurbs_to_hermite(g, 5, params, points, tangents, NULL));
    CHECK_DOUBLES(points, VALUES(0, 1, -1, 0, 0, -1, 1, 0, 0, 1), 10);
    CHECK_DOUBLES(tangents, VALUES(-2, 0, 0, -2, 2, 0, 0, 2, -2, 0), 10);
    nurbs_destroy(g);
}

static void no_hermite(SplineArgs a, nurbs_status status, const char *words) {
    double x[8];
    int64_t count;
    FILL(x);
    memset(&count, 0x5a, sizeof count);
    nurbs *g = make(a);
    CHECK_FAILS(nurbs_to_hermite(g, 0, x, x + 2, x + 4, &count), status, words);
    CHECK_UNTOUCHED(x);
    check_untouched(__FILE__, __LINE__, &count, sizeof count);
    nurbs_destroy(g);
}

/* The difference of the points overflows, but not the slope. */
static void large_points(void) {
    static const int32_t degree = 1;
    static const int64_t two = 2;
    nurbs *g = NULL;
    double slopes[2];
    CHECK_OK(nurbs_create(1, &degree, &two, VALUES(0, 0, 10, 10), 4, 1, VALUES(-1.7e308, 1.7e308), 0, 0, NULL,
                          0, 0, &g));
    CHECK_OK(nurbs_to_hermite(g, 2, NULL, NULL, slopes, NULL));
    CHECK_DOUBLES(slopes, VALUES(2 * (1.7e308 / 10), 2 * (1.7e308 / 10)), 2);
    nurbs_destroy(g);
}

static void hermite_refusals(void) {
    static const int32_t four = 4;
    static const int64_t five = 5;
    static const double knots[] = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1}, values[] = {0, 1, 2, 3, 4};
    const SplineArgs quartic = {1, &four, &five, knots, 10, 1, values, 0, 0, NULL, 0, 0};
    no_hermite(patch(), NURBS_ERROR_AXES, "2 axes");
    no_hermite(circle(), NURBS_ERROR_RATIONAL, "g");
    no_hermite(quartic, NURBS_ERROR_DEGREE, "degree 4|3");
    no_hermite(jump(), NURBS_ERROR_CONTINUITY, "knot 1|2 times|at most 0|degree 1");
    no_hermite(stairs(), NURBS_ERROR_CONTINUITY, "knot 1|1 times|at most 0");
    double x[8];
    int64_t count;
    FILL(x);
    memset(&count, 0x5a, sizeof count);
    nurbs *g = make(arch());
    CHECK_FAILS(nurbs_to_hermite(NULL, 2, x, x + 2, x + 4, &count), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_to_hermite(g, 1, x, x + 2, x + 4, &count), NURBS_ERROR_SIZE, "cap = 1|2");
    CHECK_FAILS(nurbs_to_hermite(g, -1, x, NULL, NULL, &count), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_to_hermite(g, 2, x, x + 1, x + 4, &count), NURBS_ERROR_OVERLAP, "points|params");
    CHECK_UNTOUCHED(x);
    check_untouched(__FILE__, __LINE__, &count, sizeof count);
    nurbs_destroy(g);
    static const double steep[] = {0, 0, 1e-300, 1e-300}, far[] = {-1e10, 1e10};
    static const int32_t one = 1;
    static const int64_t two = 2;
    CHECK_OK(nurbs_create(1, &one, &two, steep, 4, 1, far, 0, 0, NULL, 0, 0, &g));
    CHECK_FAILS(nurbs_to_hermite(g, 2, x, x + 2, x + 4, NULL), NURBS_ERROR_NOT_REPRESENTABLE, "tangent");
    CHECK_UNTOUCHED(x);
    nurbs_destroy(g);
}

static void refusals(void) {
    nurbs *h = NULL;
    double m[16];
    FILL(m);
    const double x[] = {0, 1, 2};
    CHECK_NO_HANDLE(h, nurbs_create_hermite(1, x, 1, x, 0, 0, x, 0, 0, &h), NURBS_ERROR_COUNT, "n = 1");
    CHECK_NO_HANDLE(h, nurbs_create_hermite(2, x, 0, x, 0, 0, x, 0, 0, &h), NURBS_ERROR_DIMENSION, "dim = 0");
    CHECK_NO_HANDLE(h, nurbs_create_hermite(2, NULL, 1, x, 0, 0, x, 0, 0, &h), NURBS_ERROR_NULL, "params");
    CHECK_NO_HANDLE(h, nurbs_create_hermite(2, x, 1, NULL, 0, 0, x, 0, 0, &h), NURBS_ERROR_NULL, "points");
    CHECK_NO_HANDLE(h, nurbs_create_hermite(2, x, 1, x, 0, 0, NULL, 0, 0, &h), NURBS_ERROR_NULL, "tangents");
    CHECK_NO_HANDLE(h, nurbs_create_hermite(2, x, 1, x, -1, 0, x, 0, 0, &h), NURBS_ERROR_STRIDE, "points");
    CHECK_NO_HANDLE(h, nurbs_create_hermite(2, VALUES(1, 1), 1, x, 0, 0, x, 0, 0, &h),
                    NURBS_ERROR_KNOTS_DECREASING, "params[1] = 1");
    CHECK_NO_HANDLE(h, nurbs_create_hermite(2, VALUES(NAN, 1), 1, x, 0, 0, x, 0, 0, &h),
                    NURBS_ERROR_PARAMETER_NOT_FINITE, "params[0] = nan");
    CHECK_NO_HANDLE(h, nurbs_create_hermite(2, x, 1, VALUES(0, INFINITY), 0, 0, x, 0, 0, &h),
                    NURBS_ERROR_POINT_NOT_FINITE, "points[1][0] = inf");
    CHECK_NO_HANDLE(h, nurbs_create_hermite(2, x, 1, x, 0, 0, VALUES(0, 5, NAN), 2, 0, &h),
                    NURBS_ERROR_POINT_NOT_FINITE, "tangents[1][0] = nan");
    CHECK_NO_HANDLE(h,
                    nurbs_create_hermite(3, VALUES(0, 1, 1e300), 1, x, 0, 0, VALUES(0, -1e10, 1), 0, 0, &h),
                    NURBS_ERROR_NOT_REPRESENTABLE, "points[1][0] + tangents[1][0]|1 + -1e+10 * 1e+300 / 3");
    CHECK_NO_HANDLE(h, nurbs_create_hermite(INT64_MAX, x, 1, x, 0, 0, x, 0, 0, &h), NURBS_ERROR_OVERFLOW,
                    "points");
    CHECK_FAILS(nurbs_create_hermite(2, x, 1, x, 0, 0, x, 0, 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_basis_matrix(4, 0, 3, 16, m), NURBS_ERROR_BASIS, "from = 4");
    CHECK_FAILS(nurbs_basis_matrix(0, -1, 3, 16, m), NURBS_ERROR_BASIS, "to = -1");
    CHECK_FAILS(nurbs_basis_matrix(0, 1, 22, 16, m), NURBS_ERROR_DEGREE, "degree = 22|21");
    CHECK_FAILS(nurbs_basis_matrix(0, NURBS_BASIS_HERMITE, 2, 9, m), NURBS_ERROR_DEGREE, "degree = 2|odd");
    CHECK_FAILS(nurbs_basis_matrix(0, 1, 3, 15, m), NURBS_ERROR_SIZE, "size = 15|16");
    CHECK_FAILS(nurbs_basis_matrix(0, 1, 3, 16, NULL), NURBS_ERROR_NULL, "matrix");
    CHECK_UNTOUCHED(m);
}

int main(void) {
    matrices();
    hermite();
    lower_degrees();
    large_points();
    hermite_refusals();
    refusals();
    return check_summary("segments");
}
