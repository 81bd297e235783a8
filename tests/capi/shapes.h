/* SPDX-License-Identifier: MIT */
/* Splines with known values, as arguments of nurbs_create(), so that a test can change one argument at a
 * time. */
#ifndef NURBS_TESTS_CAPI_SHAPES_H
#define NURBS_TESTS_CAPI_SHAPES_H

#include "check.h"

typedef struct SplineArgs {
    int32_t axes;
    const int32_t *degrees;
    const int64_t *counts;
    const double *knots;
    int64_t knot_count;
    int32_t dim;
    const double *points;
    int64_t point_stride, component_stride;
    const double *weights;
    int64_t weight_stride;
    uint32_t flags;
} SplineArgs;

static inline nurbs_status create(const SplineArgs *a, nurbs **out) {
    return nurbs_create(a->axes, a->degrees, a->counts, a->knots, a->knot_count, a->dim, a->points,
                        a->point_stride, a->component_stride, a->weights, a->weight_stride, a->flags, out);
}

/* The spline itself; a test cannot go on without it. */
static inline nurbs *make(SplineArgs a) {
    nurbs *g = NULL;
    if (create(&a, &g) != NURBS_OK || g == NULL) {
        char text[check_text_size];
        (void)nurbs_last_error(text, check_text_size);
        fprintf(stderr, "a test shape was refused: %s\n", text);
        exit(2);
    }
    return g;
}

/* Cubic Bezier curve in the plane: C(t) = (3 t + 3 t^2 - 2 t^3, 6 t - 6 t^2). */
static inline SplineArgs arch(void) {
    static const int32_t degrees[] = {3};
    static const int64_t counts[] = {4};
    static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    static const double points[] = {0, 0, 1, 2, 3, 2, 4, 0};
    SplineArgs a = {1, degrees, counts, knots, 8, 2, points, 0, 0, NULL, 0, 0};
    return a;
}

/* Cubic Bezier curve in space: C(t) = 3 (t, t^2, t^3). */
static inline SplineArgs twist(void) {
    static const int32_t degrees[] = {3};
    static const int64_t counts[] = {4};
    static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    static const double points[] = {0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 3, 3};
    SplineArgs a = {1, degrees, counts, knots, 8, 3, points, 0, 0, NULL, 0, 0};
    return a;
}

#define HALF_ROOT 0.70710678118654757 /* sqrt(1/2), rounded */

/* The unit circle from nine points of degree 2 (Piegl & Tiller, example 7.1). */
static inline SplineArgs circle(void) {
    static const int32_t degrees[] = {2};
    static const int64_t counts[] = {9};
    static const double knots[] = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
    static const double points[] = {1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0};
    static const double weights[] = {1, HALF_ROOT, 1, HALF_ROOT, 1, HALF_ROOT, 1, HALF_ROOT, 1};
    SplineArgs a = {1, degrees, counts, knots, 12, 2, points, 0, 0, weights, 0, 0};
    return a;
}

/* Uniform unclamped quadratic on the line, domain [2, 5], points 0, 2, 4, 2, 0: C(i + 2) is the mean of
 * points i, i + 1. */
static inline SplineArgs hill(void) {
    static const int32_t degrees[] = {2};
    static const int64_t counts[] = {5};
    static const double knots[] = {0, 1, 2, 3, 4, 5, 6, 7};
    static const double points[] = {0, 2, 4, 2, 0};
    SplineArgs a = {1, degrees, counts, knots, 8, 1, points, 0, 0, NULL, 0, 0};
    return a;
}

/* Periodic uniform quadratic around the square (+-1, +-1), domain [2, 6]. */
static inline SplineArgs loop(void) {
    static const int32_t degrees[] = {2};
    static const int64_t counts[] = {6};
    static const double knots[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    static const double points[] = {1, 1, -1, 1, -1, -1, 1, -1, 1, 1, -1, 1};
    SplineArgs a = {1, degrees, counts, knots, 9, 2, points, 0, 0, NULL, 0, NURBS_PERIODIC};
    return a;
}

/* Degree 1 with a jump at 1: t on [0, 1), 4 + t on [1, 2]. */
static inline SplineArgs jump(void) {
    static const int32_t degrees[] = {1};
    static const int64_t counts[] = {4};
    static const double knots[] = {0, 0, 1, 1, 2, 2};
    static const double points[] = {0, 1, 5, 6};
    SplineArgs a = {1, degrees, counts, knots, 6, 1, points, 0, 0, NULL, 0, 0};
    return a;
}

/* Degree 0: 10, 20, 30 on [0, 1), [1, 2), [2, 3]. */
static inline SplineArgs stairs(void) {
    static const int32_t degrees[] = {0};
    static const int64_t counts[] = {3};
    static const double knots[] = {0, 1, 2, 3};
    static const double points[] = {10, 20, 30};
    SplineArgs a = {1, degrees, counts, knots, 4, 1, points, 0, 0, NULL, 0, 0};
    return a;
}

/* Bilinear patch S(u, v) = (u, v, u v). */
static inline SplineArgs patch(void) {
    static const int32_t degrees[] = {1, 1};
    static const int64_t counts[] = {2, 2};
    static const double knots[] = {0, 0, 1, 1, 0, 0, 1, 1};
    static const double points[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1};
    SplineArgs a = {2, degrees, counts, knots, 8, 3, points, 0, 0, NULL, 0, 0};
    return a;
}

/* Surface of degrees 2 and 1 with counts 3 and 4: S(u, v) = (u, v, u^2 + v) for v in [0, 3]. */
static inline SplineArgs trough(void) {
    static const int32_t degrees[] = {2, 1};
    static const int64_t counts[] = {3, 4};
    static const double knots[] = {0, 0, 0, 1, 1, 1, 0, 0, 1, 2, 3, 3};
    static const double points[] = {0,   0, 0, 0,   1, 1, 0, 2, 2, 0, 3, 3, 0.5, 0, 0, 0.5, 1, 1,
                                    0.5, 2, 2, 0.5, 3, 3, 1, 0, 1, 1, 1, 2, 1,   2, 3, 1,   3, 4};
    SplineArgs a = {2, degrees, counts, knots, 12, 3, points, 0, 0, NULL, 0, 0};
    return a;
}

/* Trilinear volume V(u, v, w) = (u, v, w, u v w). */
static inline SplineArgs cube(void) {
    static const int32_t degrees[] = {1, 1, 1};
    static const int64_t counts[] = {2, 2, 2};
    static const double knots[] = {0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1};
    static const double points[] = {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0,
                                    1, 0, 0, 0, 1, 0, 1, 0, 1, 1, 0, 0, 1, 1, 1, 1};
    SplineArgs a = {3, degrees, counts, knots, 12, 4, points, 0, 0, NULL, 0, 0};
    return a;
}

/* N * dim values of the points of g, at most 64: how many; 0 and a report if there are none to read. */
static inline int64_t few_points(const char *file, int line, const nurbs *g, double *values) {
    int64_t count = 0;
    int32_t dim = 0;
    (void)nurbs_point_count(g, &count);
    (void)nurbs_dimension(g, &dim);
    if (count * dim > 64 || nurbs_points(g, count, values, 0, 0) != NURBS_OK) {
        check_report(file, line, "the points cannot be read\n");
        return 0;
    }
    return count * dim;
}

static inline void check_points(const char *file, int line, const nurbs *g, const double *expected) {
    double values[64];
    const int64_t size = few_points(file, line, g, values);
    check_bits(file, line, values, expected, (size_t)size * sizeof *values);
}

static inline void check_points_near(const char *file, int line, const nurbs *g, const double *expected,
                                     double bound) {
    double values[64];
    const int64_t size = few_points(file, line, g, values);
    check_doubles(file, line, values, expected, size, bound);
}
#define CHECK_POINTS_NEAR(g, expected, bound) check_points_near(__FILE__, __LINE__, g, expected, bound)

static inline void check_knot_vector(const char *file, int line, const nurbs *g, int32_t axis,
                                     const double *expected) {
    int64_t count = 0;
    int32_t degree = 0;
    double values[64];
    (void)nurbs_count(g, axis, &count);
    (void)nurbs_degree(g, axis, &degree);
    count += degree + 1;
    if (count > 64 || nurbs_knots(g, axis, count, values) != NURBS_OK) {
        check_report(file, line, "the knots cannot be read\n");
        return;
    }
    check_bits(file, line, values, expected, (size_t)count * sizeof *values);
}

static inline void check_weights(const char *file, int line, const nurbs *g, const double *expected) {
    int64_t count = 0;
    double values[64];
    (void)nurbs_point_count(g, &count);
    if (count > 64 || nurbs_weights(g, count, values, 0) != NURBS_OK) {
        check_report(file, line, "the weights cannot be read\n");
        return;
    }
    check_bits(file, line, values, expected, (size_t)count * sizeof *values);
}

#define CHECK_POINTS(g, expected) check_points(__FILE__, __LINE__, g, expected)
#define CHECK_KNOTS(g, axis, expected) check_knot_vector(__FILE__, __LINE__, g, axis, expected)
#define CHECK_WEIGHTS(g, expected) check_weights(__FILE__, __LINE__, g, expected)

#endif
