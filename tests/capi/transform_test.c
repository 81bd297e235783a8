/* SPDX-License-Identifier: MIT */
/* nurbs_transform() and nurbs_transform_projective(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

/* Equal values, where signs of zeros are left open. */
static void points_are(const nurbs *g, int64_t n, int32_t dim, const double *expected) {
    double points[32];
    CHECK_OK(nurbs_points(g, n, points, 0, 0));
    CHECK_DOUBLES(points, expected, n * dim);
}

static void affine(void) {
    static const double turn[] = {0, -1, 1, 0}, move[] = {10, 20}, drop[] = {0, 1},
                        add[] = {1, 0, 0, 1, 0, 0};
    nurbs *g = make(arch()), *h = NULL;
    CHECK_OK(nurbs_transform(g, 2, turn, move, &h));
    CHECK_POINTS(h, VALUES(10, 20, 8, 21, 8, 23, 10, 24));
    CHECK_KNOTS(h, 0, arch().knots);
    nurbs_destroy(h);
    CHECK_OK(nurbs_transform(g, 1, drop, NULL, &h));
    CHECK_POINTS(h, VALUES(0, 2, 2, 0));
    nurbs_destroy(h);
    CHECK_OK(nurbs_transform(g, 3, add, NULL, &h));
    CHECK_POINTS(h, VALUES(0, 0, 0, 1, 2, 0, 3, 2, 0, 4, 0, 0));
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = make(circle());
    CHECK_OK(nurbs_transform(g, 2, turn, NULL, &h));
    CHECK_WEIGHTS(h, circle().weights);
    points_are(h, 9, 2, VALUES(0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0, 1, 1, 0, 1));
    nurbs_destroy(h);
    nurbs_destroy(g);
}

/* w' = 1 + x in front of the plane x = -1; -w' gives the same points with the same weights. */
static void projective(void) {
    static const double map[] = {2, 0, 0, 0, 4, 0, 1, 0, 1}, minus[] = {-2, 0, 0, 0, -4, 0, -1, 0, -1},
                        through[] = {1, 0, 0, 0, 1, 0, 1, 0, -2}, gone[] = {1, 0, 0, 0, 1, 0, 0, 0, 0};
    int32_t rational = 0;
    double records[12];
    nurbs *g = make(arch()), *h = NULL;
    CHECK_OK(nurbs_transform_projective(g, 2, map, &h));
    CHECK_WEIGHTS(h, VALUES(1, 2, 4, 5));
    CHECK_POINTS(h, VALUES(0, 0, 1, 4, 1.5, 2, 1.6, 0));
    nurbs_destroy(h);
    CHECK_OK(nurbs_transform_projective(g, 2, minus, &h));
    CHECK_WEIGHTS(h, VALUES(1, 2, 4, 5));
    points_are(h, 4, 2, VALUES(0, 0, 1, 4, 1.5, 2, 1.6, 0));
    nurbs_destroy(h);
    CHECK_OK(nurbs_transform_projective(g, 2, through, &h));
    CHECK_OK(nurbs_is_rational(h, &rational));
    CHECK_INT(rational, 1);
    CHECK_OK(nurbs_homogeneous_points(h, 4, records, 0, 0));
    CHECK_DOUBLES(records, VALUES(0, 0, -2, 1, 2, -1, 3, 2, 1, 4, 0, 2), 12);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_transform_projective(g, 2, gone, &h), NURBS_ERROR_WEIGHTS_VANISH, "weight");
    nurbs_destroy(g);
}

static void bad_arguments(void) {
    static const double one[] = {1, 0, 0, 1, 0, 0, 0, 0, 1}, huge[] = {1e308, 1e308, 1e308, 1e308};
    static const int32_t dims[] = {0, -1, INT32_MAX, INT32_MIN};
    nurbs *g = make(arch()), *h = NULL;
    for (int i = 0; i < 4; ++i) {
        CHECK_NO_HANDLE(h, nurbs_transform(g, dims[i], one, NULL, &h), NURBS_ERROR_DIMENSION, "out_dim");
        CHECK_NO_HANDLE(h, nurbs_transform_projective(g, dims[i], one, &h), NURBS_ERROR_DIMENSION, "out_dim");
    }
    CHECK_NO_HANDLE(h, nurbs_transform(NULL, 2, one, NULL, &h), NURBS_ERROR_NULL, "g");
    CHECK_NO_HANDLE(h, nurbs_transform(g, 2, NULL, NULL, &h), NURBS_ERROR_NULL, "matrix");
    CHECK_FAILS(nurbs_transform(g, 2, one, NULL, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(h, nurbs_transform_projective(NULL, 2, one, &h), NURBS_ERROR_NULL, "g");
    CHECK_NO_HANDLE(h, nurbs_transform_projective(g, 2, NULL, &h), NURBS_ERROR_NULL, "matrix");
    CHECK_FAILS(nurbs_transform_projective(g, 2, one, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(h, nurbs_transform(g, 2, edited(one, 4, 3, NAN), NULL, &h), NURBS_ERROR_MATRIX,
                    "matrix[1][1]|nan");
    CHECK_NO_HANDLE(h, nurbs_transform(g, 2, one, edited(one, 2, 1, INFINITY), &h), NURBS_ERROR_MATRIX,
                    "translation[1]|inf");
    CHECK_NO_HANDLE(h, nurbs_transform_projective(g, 2, edited(one, 9, 5, -INFINITY), &h), NURBS_ERROR_MATRIX,
                    "matrix[1][2]|inf");
    CHECK_NO_HANDLE(h, nurbs_transform(g, 2, huge, NULL, &h), NURBS_ERROR_NOT_REPRESENTABLE, "points[1]");
    CHECK_POINTS(g, arch().points);
    nurbs_destroy(g);
}

int main(void) {
    affine();
    projective();
    bad_arguments();
    return check_summary("transform");
}
