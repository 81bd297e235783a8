/* SPDX-License-Identifier: MIT */
/* nurbs_mirror(), nurbs_project_to_plane() and nurbs_project_from(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

static void mirrored(void) {
    nurbs *g = make(arch()), *h = NULL, *k = NULL;
    CHECK_OK(nurbs_mirror(g, VALUES(1, 7), VALUES(-3, 0), &h)); /* x -> 2 - x */
    CHECK_POINTS(h, VALUES(2, 0, 1, 2, -1, 2, -2, 0));
    CHECK_OK(nurbs_mirror(h, VALUES(1, 7), VALUES(1e-300, 0), &k));
    CHECK_POINTS(k, arch().points);
    nurbs_destroy(h);
    nurbs_destroy(k);
    CHECK_OK(nurbs_mirror(g, VALUES(0, 0), VALUES(1, -1), &h)); /* exchanges x and y */
    CHECK_POINTS(h, VALUES(0, 0, 2, 1, 2, 3, 0, 4));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_mirror(g, VALUES(0, 0), VALUES(0, 0), &h), NURBS_ERROR_DIRECTION, "normal is 0");
    CHECK_NO_HANDLE(h, nurbs_mirror(g, VALUES(0, NAN), VALUES(0, 1), &h), NURBS_ERROR_POINT_NOT_FINITE,
                    "point[1] = nan");
    CHECK_NO_HANDLE(h, nurbs_mirror(g, VALUES(0, 0), VALUES(INFINITY, 1), &h), NURBS_ERROR_DIRECTION,
                    "normal[0] = inf");
    CHECK_NO_HANDLE(h, nurbs_mirror(g, NULL, VALUES(0, 1), &h), NURBS_ERROR_NULL, "point");
    CHECK_NO_HANDLE(h, nurbs_mirror(g, VALUES(0, 1), NULL, &h), NURBS_ERROR_NULL, "normal");
    CHECK_NO_HANDLE(h, nurbs_mirror(NULL, VALUES(0, 1), VALUES(0, 1), &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_mirror(g, VALUES(0, 1), VALUES(0, 1), NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
}

static void projected(void) {
    nurbs *g = make(arch()), *h = NULL;
    CHECK_OK(nurbs_project_to_plane(g, VALUES(5, 1), VALUES(0, 2), NULL, &h));
    CHECK_POINTS(h, VALUES(0, 1, 1, 1, 3, 1, 4, 1));
    nurbs_destroy(h);
    CHECK_OK(nurbs_project_to_plane(g, VALUES(5, 0), VALUES(0, 2), VALUES(1, 1), &h));
    CHECK_POINTS(h, VALUES(0, 0, -1, 0, 1, 0, 4, 0));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_project_to_plane(g, VALUES(0, 0), VALUES(0, 2), VALUES(1, 0), &h),
                    NURBS_ERROR_DIRECTION, "parallel");
    CHECK_NO_HANDLE(h, nurbs_project_to_plane(g, VALUES(0, 0), VALUES(0, 2), VALUES(0, 0), &h),
                    NURBS_ERROR_DIRECTION, "direction is 0");
    CHECK_NO_HANDLE(h, nurbs_project_to_plane(g, VALUES(0, 0), VALUES(0, 2), VALUES(NAN, 0), &h),
                    NURBS_ERROR_DIRECTION, "direction[0] = nan");
    CHECK_NO_HANDLE(h, nurbs_project_to_plane(NULL, VALUES(0, 0), VALUES(0, 2), NULL, &h), NURBS_ERROR_NULL,
                    "g");
    CHECK_FAILS(nurbs_project_to_plane(g, VALUES(0, 1), VALUES(0, 1), NULL, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
}

/* From (0, -4) to the x axis: x -> 4 x / (y + 4). */
static void perspective(void) {
    nurbs *g = make(arch()), *h = NULL;
    CHECK_OK(nurbs_project_from(g, VALUES(0, -4), VALUES(9, 0), VALUES(0, 1), &h));
    CHECK_WEIGHTS(h, VALUES(4, 6, 6, 4));
    double points[8], t = 0.5, x[2];
    CHECK_OK(nurbs_points(h, 4, points, 0, 0));
    CHECK_NEAR(points, VALUES(0, 0, 4.0 / 6, 0, 2, 0, 4, 0), 8, 1e-15);
    CHECK_OK(nurbs_eval(h, 1, &t, 0, 0, x, 0, 0, 0));
    CHECK_NEAR(x, VALUES(8 / 5.5, 0), 2, 1e-15); /* the arch is (2, 1.5) there */
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_project_from(g, VALUES(3, 0), VALUES(9, 0), VALUES(0, 1), &h),
                    NURBS_ERROR_DIRECTION, "eye lies in the plane");
    CHECK_NO_HANDLE(h, nurbs_project_from(g, VALUES(NAN, 1), VALUES(9, 0), VALUES(0, 1), &h),
                    NURBS_ERROR_POINT_NOT_FINITE, "eye[0] = nan");
    CHECK_NO_HANDLE(h, nurbs_project_from(g, NULL, VALUES(9, 0), VALUES(0, 1), &h), NURBS_ERROR_NULL, "eye");
    CHECK_NO_HANDLE(h, nurbs_project_from(NULL, VALUES(9, 0), VALUES(9, 0), VALUES(0, 1), &h),
                    NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_project_from(g, VALUES(0, 1), VALUES(0, 1), VALUES(0, 1), NULL), NURBS_ERROR_NULL,
                "out");
    nurbs_destroy(g);
}

int main(void) {
    mirrored();
    projected();
    perspective();
    return check_summary("projections");
}
