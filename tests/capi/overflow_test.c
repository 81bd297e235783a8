/* SPDX-License-Identifier: MIT */
/* Results that are too large are told from arguments that are not finite, and arrays that are too long for
 * any memory are refused before they are looked at. */
#include "shapes.h"

#define VALUES(...) ((const double[]){__VA_ARGS__})

static nurbs *curve(int32_t degree, int64_t count, const double *knots, const double *points,
                    uint32_t flags) {
    nurbs *g = NULL;
    CHECK_OK(
        nurbs_create(1, &degree, &count, knots, count + degree + 1, 1, points, 0, 0, NULL, 0, flags, &g));
    return g;
}

static nurbs *homogeneous(int32_t degree, const double *records) {
    static const double knots[] = {0, 0, 0, 1, 1, 1};
    const int64_t count = degree + 1;
    nurbs *g = NULL;
    CHECK_OK(
        nurbs_create_homogeneous(1, &degree, &count, knots + 2 - degree, 2 * count, 1, records, 0, 0, 0, &g));
    return g;
}

static void points(void) {
    nurbs *g = curve(2, 5, VALUES(0, 0, 0, 0.5, 0.625, 1, 1, 1),
                     VALUES(1.79e308, -1.79e308, 1.79e308, -1.7e308, 1.79e308), 0),
          *h = NULL;
    CHECK_NO_HANDLE(h, nurbs_reduce_degree(g, 0, 1, NULL, &h), NURBS_ERROR_NOT_REPRESENTABLE,
                    "of the result");
    CHECK_NO_HANDLE(h, nurbs_simplify(g, INFINITY, NULL, &h), NURBS_ERROR_NOT_REPRESENTABLE, "of the result");
    nurbs_destroy(g);
    g = homogeneous(2, VALUES(1e300, 1, 1e300, 1, 1e300, 1));
    CHECK_NO_HANDLE(h, nurbs_reparametrize_moebius(g, 0, 1e30, &h), NURBS_ERROR_NOT_REPRESENTABLE,
                    "of the result");
    nurbs_destroy(g);
}

static void knots(void) {
    nurbs *g = curve(2, 3, VALUES(-8e307, -8e307, -8e307, 8e307, 8e307, 8e307), VALUES(0, 1, 0), 0),
          *h = NULL;
    CHECK_NO_HANDLE(h, nurbs_make_periodic(g, 0, INFINITY, NULL, NULL, &h), NURBS_ERROR_NOT_REPRESENTABLE,
                    "knots");
    nurbs_destroy(g);
    g = curve(0, 2, VALUES(-8.5e307, 0, 8.5e307), VALUES(1, 2), NURBS_PERIODIC);
    CHECK_NO_HANDLE(h, nurbs_warp(g, NULL, VALUES(1), 1, 2, &h), NURBS_ERROR_NOT_REPRESENTABLE, "knots");
    nurbs_destroy(g);
    g = curve(0, 2, VALUES(0, 1e308, 1.6e308), VALUES(1, 2), NURBS_PERIODIC);
    CHECK_NO_HANDLE(h, nurbs_move_seam(g, 0, 1e308, &h), NURBS_ERROR_NOT_REPRESENTABLE, "knots");
    nurbs_destroy(g);
    g = curve(2, 3, VALUES(-8e307, 0, 0, 8e307, 8e307, 8e307), VALUES(0, 1, 0), 0);
    CHECK_NO_HANDLE(h, nurbs_extend(g, 0, NURBS_END, 9e307, 2, &h), NURBS_ERROR_NOT_REPRESENTABLE, "knots");
    nurbs_destroy(g);
}

/* Points (w x) / w of homogeneous splines. */
static void quotients(void) {
    nurbs *g = homogeneous(1, VALUES(1e16, 1e-300, 1e16, 2e-300));
    double a[2], b[2];
    int32_t status;
    int64_t count;
    CHECK_FAILS(nurbs_box(g, NULL, 0, a, b, NULL), NURBS_ERROR_NOT_REPRESENTABLE, "overflows");
    CHECK_FAILS(
        nurbs_closest_points(g, 1, VALUES(0), 0, 0, NULL, 0, 0, a, 0, 0, NULL, 0, 0, NULL, 0, &status, 0),
        NURBS_ERROR_NOT_REPRESENTABLE, "overflows");
    CHECK_FAILS(nurbs_critical_points(g, VALUES(0), NULL, 0, 0, 2, a, b, NULL, &count, &status),
                NURBS_ERROR_NOT_REPRESENTABLE, "overflows");
    nurbs_destroy(g);
}

static void weights(void) {
    static const int32_t degree = 1;
    static const int64_t count = 3;
    static const double own_knots[] = {0, 0, 1, 2, 2}, own[] = {0, 1, 2}, wide[] = {1e-200, 1e-200, 1e200};
    nurbs *g = NULL, *h = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, own_knots, 5, 1, own, 0, 0, wide, 0, 0, &g));
    CHECK_NO_HANDLE(h, nurbs_warp(g, NULL, VALUES(1), 0.1, 2, &h), NURBS_ERROR_WEIGHTS_VANISH, "is 0");
    CHECK_NO_HANDLE(h, nurbs_reduce_degree(g, 0, 1, NULL, &h), NURBS_ERROR_WEIGHTS_VANISH, "is 0");
    nurbs_destroy(g);
}

/* Nothing can be read at the address of the arrays. */
static void handle_arrays(void) {
    static const int64_t counts[] = {INT64_C(1) << 53, (INT64_C(1) << 60) - 1, INT64_C(1) << 61, INT64_MAX};
    const nurbs *const *none = (const nurbs *const *)(uintptr_t)8;
    for (int i = 0; i < 4; ++i) {
        const int64_t n = counts[i];
        double a[16];
        nurbs *h = NULL;
        nurbs_list *list = NULL;
        CHECK_NO_HANDLE(h, nurbs_join(n, none, 0, 0, 0, NULL, &h), NURBS_ERROR_OVERFLOW,
                        "parts|address space");
        CHECK_FAILS(nurbs_make_compatible(n, none, 0, 0, NULL, &list), NURBS_ERROR_OVERFLOW,
                    "splines|address space");
        CHECK(list == NULL);
        CHECK_FAILS(nurbs_enclosed_area(n, none, 0, 0, a, NULL, NULL, NULL), NURBS_ERROR_OVERFLOW,
                    "curves|address space");
        CHECK_FAILS(nurbs_enclosed_volume(n, none, 0, a, NULL, NULL, NULL, NULL), NURBS_ERROR_OVERFLOW,
                    "surfaces|address space");
    }
}

/* A stride that takes the second of two records beyond all addresses; that of a single one means nothing. */
static void strides(void) {
    static const int64_t far = INT64_C(1) << 53;
    nurbs *g = curve(1, 2, VALUES(0, 0, 1, 1), VALUES(2, 4), 0);
    double points[2] = {0, 0};
    CHECK_FAILS(nurbs_eval(g, 2, VALUES(0, 1), far, 0, points, 0, 0, 0), NURBS_ERROR_OVERFLOW, "params");
    CHECK_FAILS(nurbs_eval(g, 2, VALUES(0, 1), 0, 0, points, far, 0, 0), NURBS_ERROR_OVERFLOW, "points");
    CHECK(points[0] == 0 && points[1] == 0);
    CHECK_OK(nurbs_eval(g, 1, VALUES(0.5), far, far, points, far, 4 * far, 0));
    CHECK_OK(nurbs_eval(g, 1, VALUES(0.5), 0, far, points + 1, 0, 4 * far, 0));
    CHECK(points[0] == 3 && points[1] == 3);
    nurbs_destroy(g);
}

int main(void) {
    handle_arrays();
    strides();
    points();
    knots();
    quotients();
    weights();
    return check_summary("overflow");
}
