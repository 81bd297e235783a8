/* SPDX-License-Identifier: MIT */
/* nurbs_create_hermite() and nurbs_basis_matrix(). */
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
    nurbs_destroy(h);
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
                    NURBS_ERROR_POINT_NOT_FINITE, "inf");
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
    refusals();
    return check_summary("segments");
}
