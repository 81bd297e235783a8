/* SPDX-License-Identifier: MIT */
/* Planes, bilinear patches and trilinear volumes: their corners, layouts, and what is refused. */
#include "check.h"
#include "shapes.h"

#define VALUES(...) ((const double[]){__VA_ARGS__})

static void plane(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_plane(3, VALUES(1, 2, 3), VALUES(4, 0, 0), VALUES(0, 0, 5), &g));
    CHECK_POINTS(g, VALUES(1, 2, 3, 1, 2, 8, 5, 2, 3, 5, 2, 8));
    CHECK_KNOTS(g, 0, VALUES(0, 0, 1, 1));
    nurbs_destroy(g);
    CHECK_OK(nurbs_surface_plane(2, NULL, VALUES(1e-300, 0), VALUES(1e300, 1e285), &g));
    CHECK_POINTS(g, VALUES(0, 0, 1e300, 1e285, 1e-300, 0, 1e300, 1e285));
    nurbs_destroy(g);
    CHECK_OK(nurbs_surface_plane(3, VALUES(1e16, 0, 0), VALUES(1, 1, 0), VALUES(1, 0, 1), &g));
    CHECK_POINTS(g, VALUES(1e16, 0, 0, 1e16, 0, 1, 1e16, 1, 0, 1e16 + 2, 1, 1)); /* rounded once */
    nurbs_destroy(g);
}

static void plane_refused(void) {
    const double *u = VALUES(1, 2, 3), *v = VALUES(0, 1, 0);
    nurbs *g = NULL;
    CHECK_NO_HANDLE(g, nurbs_surface_plane(1, NULL, u, v, &g), NURBS_ERROR_DIMENSION, "dim = 1|at least 2");
    CHECK_NO_HANDLE(g, nurbs_surface_plane(-1, NULL, u, v, &g), NURBS_ERROR_DIMENSION, "-1");
    CHECK_NO_HANDLE(g, nurbs_surface_plane(3, NULL, NULL, v, &g), NURBS_ERROR_NULL, "u is NULL");
    CHECK_NO_HANDLE(g, nurbs_surface_plane(3, NULL, u, NULL, &g), NURBS_ERROR_NULL, "v is NULL");
    CHECK_FAILS(nurbs_surface_plane(3, NULL, u, v, NULL), NURBS_ERROR_NULL, "out is NULL");
    CHECK_NO_HANDLE(g, nurbs_surface_plane(3, edited(u, 3, 2, INFINITY), u, v, &g),
                    NURBS_ERROR_POINT_NOT_FINITE, "origin[2] = inf");
    CHECK_NO_HANDLE(g, nurbs_surface_plane(3, NULL, edited(u, 3, 0, NAN), v, &g), NURBS_ERROR_DIRECTION,
                    "u[0] = nan");
    CHECK_NO_HANDLE(g, nurbs_surface_plane(3, NULL, u, edited(v, 3, 1, 0), &g), NURBS_ERROR_DIRECTION,
                    "v is zero");
    CHECK_NO_HANDLE(g, nurbs_surface_plane(3, NULL, u, VALUES(-3e-200, -6e-200, -9e-200), &g),
                    NURBS_ERROR_DIRECTION, "u and v are parallel");
    CHECK_NO_HANDLE(g, nurbs_surface_plane(2, VALUES(1e308, 0), VALUES(1e308, 0), VALUES(0, 1), &g),
                    NURBS_ERROR_NOT_REPRESENTABLE, "corners|overflows");
}

static void patches(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_bilinear(2, VALUES(0, 1, 10, 11, 20, 21, 30, 31), 0, 0, &g));
    CHECK_POINTS(g, VALUES(0, 1, 10, 11, 20, 21, 30, 31));
    CHECK_KNOTS(g, 1, VALUES(0, 0, 1, 1));
    nurbs_destroy(g);
    CHECK_OK(nurbs_surface_bilinear(2, VALUES(0, 10, 20, 30, 1, 11, 21, 31), 1, 4, &g)); /* by component */
    CHECK_POINTS(g, VALUES(0, 1, 10, 11, 20, 21, 30, 31));
    nurbs_destroy(g);
    CHECK_OK(nurbs_volume_trilinear(1, VALUES(0, 1, 2, 3, 4, 5, 6, 7), 0, 0, &g));
    CHECK_POINTS(g, VALUES(0, 1, 2, 3, 4, 5, 6, 7));
    double value = 0;
    CHECK_OK(nurbs_eval(g, 1, VALUES(1, 0, 1), 0, 0, &value, 0, 0, 0));
    CHECK_DOUBLE(value, 5);
    nurbs_destroy(g);
}

static void patches_refused(void) {
    const double *corners = VALUES(0, 1, 2, 3, 4, 5, 6, 7);
    nurbs *g = NULL;
    CHECK_NO_HANDLE(g, nurbs_surface_bilinear(0, corners, 0, 0, &g), NURBS_ERROR_DIMENSION, "0");
    CHECK_NO_HANDLE(g, nurbs_volume_trilinear(-7, corners, 0, 0, &g), NURBS_ERROR_DIMENSION, "-7");
    CHECK_NO_HANDLE(g, nurbs_surface_bilinear(2, NULL, 0, 0, &g), NURBS_ERROR_NULL, "corners is NULL");
    CHECK_NO_HANDLE(g, nurbs_volume_trilinear(1, NULL, 0, 0, &g), NURBS_ERROR_NULL, "corners is NULL");
    CHECK_NO_HANDLE(g, nurbs_surface_bilinear(2, corners, 1, 0, &g), NURBS_ERROR_STRIDE, "stride");
    CHECK_NO_HANDLE(g, nurbs_volume_trilinear(1, corners, -1, 0, &g), NURBS_ERROR_STRIDE, "stride");
    CHECK_NO_HANDLE(g, nurbs_surface_bilinear(2, edited(corners, 8, 5, NAN), 0, 0, &g),
                    NURBS_ERROR_POINT_NOT_FINITE, "corners[2][1] = nan");
    CHECK_NO_HANDLE(g, nurbs_volume_trilinear(1, edited(corners, 8, 7, -INFINITY), 0, 0, &g),
                    NURBS_ERROR_POINT_NOT_FINITE, "corners[7][0] = -inf");
    CHECK_FAILS(nurbs_surface_bilinear(2, corners, 0, 0, NULL), NURBS_ERROR_NULL, "out is NULL");
    CHECK_FAILS(nurbs_volume_trilinear(1, corners, 0, 0, NULL), NURBS_ERROR_NULL, "out is NULL");
}

int main(void) {
    plane();
    plane_refused();
    patches();
    patches_refused();
    return check_summary("flat patches");
}
