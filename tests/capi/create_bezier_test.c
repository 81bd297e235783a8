/* SPDX-License-Identifier: MIT */
/* nurbs_create_bezier(): curves, patches and volumes without knots. */
#include "check.h"

#include "shapes.h"

#include <stdint.h>

static nurbs_status create_bezier(const SplineArgs *a, nurbs **out) {
    return nurbs_create_bezier(a->axes, a->degrees, a->dim, a->points, a->point_stride, a->component_stride,
                               a->weights, a->weight_stride, out);
}

#define REFUSE(shape, field, value, status, words)                                                           \
    do {                                                                                                     \
        SplineArgs args_ = shape();                                                                          \
        nurbs *out_;                                                                                         \
        args_.field = (value);                                                                               \
        CHECK_NO_HANDLE(out_, create_bezier(&args_, &out_), status, words);                                  \
    } while (0)
#define INTS(...) ((const int32_t[]){__VA_ARGS__})

/* A quarter of the unit circle with the weights 1, 1, 2. */
static SplineArgs quarter(void) {
    static const int32_t degrees[] = {2};
    static const int64_t counts[] = {3};
    static const double knots[] = {0, 0, 0, 1, 1, 1}, points[] = {1, 0, 1, 1, 0, 1}, weights[] = {1, 1, 2};
    SplineArgs a = {1, degrees, counts, knots, 6, 2, points, 0, 0, weights, 0, 0};
    return a;
}

static void stores(SplineArgs a) {
    int64_t offset = 0;
    nurbs *g = NULL;
    CHECK_OK(create_bezier(&a, &g));
    CHECK_POINTS(g, a.points);
    if (a.weights != NULL) {
        CHECK_WEIGHTS(g, a.weights);
    }
    for (int32_t k = 0; k < a.axes; ++k) {
        int64_t count = 0;
        CHECK_OK(nurbs_count(g, k, &count));
        CHECK_INT(count, a.degrees[k] + 1);
        CHECK_KNOTS(g, k, a.knots + offset);
        offset += a.counts[k] + a.degrees[k] + 1;
    }
    nurbs_destroy(g);
}

/* C(1/2) = (0.6, 0.8): w = 5/4, w x = 3/4, w y = 1. */
static void quarter_circle(void) {
    static const double half = 0.5, expected[] = {0.6, 0.8};
    double point[2];
    SplineArgs a = quarter();
    nurbs *g = NULL;
    CHECK_OK(create_bezier(&a, &g));
    CHECK_OK(nurbs_eval(g, 1, &half, 0, 0, point, 0, 0, 0));
    CHECK_NEAR(point, expected, 2, 4 * 0x1p-52);
    nurbs_destroy(g);
}

/* Degree 0 is the constant; on some axes only it makes a cylinder. */
static void degree_zero(void) {
    static const double point = 3.5, points[] = {1, 2}, params[] = {0.25, 0.75};
    double value = 0;
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, INTS(0), 1, &point, 0, 0, NULL, 0, &g));
    CHECK_OK(nurbs_eval(g, 1, params, 0, 0, &value, 0, 0, 0));
    CHECK_DOUBLE(value, 3.5);
    nurbs_destroy(g);
    CHECK_OK(nurbs_create_bezier(2, INTS(0, 1), 1, points, 0, 0, NULL, 0, &g));
    CHECK_OK(nurbs_eval(g, 1, params, 0, 0, &value, 0, 0, 0));
    CHECK_DOUBLE(value, 1.75);
    nurbs_destroy(g);
}

static void null_arguments(void) {
    SplineArgs a = arch();
    REFUSE(arch, degrees, NULL, NURBS_ERROR_NULL, "degrees");
    REFUSE(arch, points, NULL, NURBS_ERROR_NULL, "points");
    CHECK_FAILS(create_bezier(&a, NULL), NURBS_ERROR_NULL, "out");
}

static void bad_arguments(void) {
    REFUSE(arch, axes, 0, NURBS_ERROR_AXES, "axes|0");
    REFUSE(arch, axes, 4, NURBS_ERROR_AXES, "axes|4");
    REFUSE(arch, axes, -2, NURBS_ERROR_AXES, "axes|-2");
    REFUSE(arch, degrees, INTS(-1), NURBS_ERROR_DEGREE, "degrees[0|-1");
    REFUSE(arch, degrees, INTS(32), NURBS_ERROR_DEGREE, "degrees[0|32");
    REFUSE(patch, degrees, INTS(1, 32), NURBS_ERROR_DEGREE, "degrees[1|32");
    REFUSE(arch, dim, 0, NURBS_ERROR_DIMENSION, "dim|0");
    REFUSE(arch, dim, -1, NURBS_ERROR_DIMENSION, "dim|-1");
    REFUSE(arch, point_stride, -1, NURBS_ERROR_STRIDE, "point|-1");
    REFUSE(arch, point_stride, 1, NURBS_ERROR_STRIDE, "point|1");
    REFUSE(arch, component_stride, -1, NURBS_ERROR_STRIDE, "point|-1");
    REFUSE(arch, point_stride, INT64_MAX, NURBS_ERROR_OVERFLOW, "point");
    REFUSE(arch, component_stride, INT64_MAX, NURBS_ERROR_OVERFLOW, "point");
    REFUSE(quarter, weight_stride, -1, NURBS_ERROR_STRIDE, "weight|-1");
    REFUSE(quarter, weight_stride, INT64_MAX, NURBS_ERROR_OVERFLOW, "weight");
    REFUSE(arch, points, edited(arch().points, 8, 6, NAN), NURBS_ERROR_POINT_NOT_FINITE, "points[3|nan");
    REFUSE(quarter, weights, edited(quarter().weights, 3, 1, INFINITY), NURBS_ERROR_WEIGHT_NOT_FINITE,
           "weights[1|inf");
    REFUSE(quarter, weights, edited(quarter().weights, 3, 1, -1), NURBS_ERROR_WEIGHT_NEGATIVE,
           "weights[1|-1");
    REFUSE(quarter, weights, edited(quarter().weights, 3, 0, 0), NURBS_ERROR_WEIGHTS_VANISH, "weights|(0)");
}

int main(void) {
    stores(arch());
    stores(quarter());
    stores(patch());
    stores(cube());
    quarter_circle();
    degree_zero();
    null_arguments();
    bad_arguments();
    return check_summary("create_bezier");
}
