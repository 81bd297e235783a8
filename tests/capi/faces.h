/* SPDX-License-Identifier: MIT */
/* Surfaces, curves in their domains and faces for the tests of trimmed faces. */
#ifndef NURBS_TESTS_CAPI_FACES_H
#define NURBS_TESTS_CAPI_FACES_H

#include "shapes.h"

/* The plane (2 u, 3 v, 0) over the unit square. */
static inline nurbs *plane(void) {
    nurbs *g = NULL;
    static const double origin[] = {0, 0, 0}, u[] = {2, 0, 0}, v[] = {0, 3, 0};
    if (nurbs_surface_plane(3, origin, u, v, &g) != NURBS_OK) {
        exit(2);
    }
    return g;
}

/* A polyline through n places of a domain. */
static inline nurbs *polyline(int64_t n, const double *places) {
    static const int32_t degree = 1;
    double knots[64];
    for (int64_t i = 0; i < n + 2; ++i) {
        knots[i] = i == 0 ? 0 : i == n + 1 ? (double)(n - 1) : (double)(i - 1);
    }
    SplineArgs a = {1, &degree, &n, knots, n + 2, 2, places, 0, 0, NULL, 0, 0};
    return make(a);
}

static inline nurbs *segment(double u0, double v0, double u1, double v1) {
    const double places[] = {u0, v0, u1, v1};
    return polyline(2, places);
}

/* The boundary of a square, counterclockwise, as one curve. */
static inline nurbs *square(double lower, double upper) {
    const double places[] = {lower, lower, upper, lower, upper, upper, lower, upper, lower, lower};
    return polyline(5, places);
}

static inline nurbs *circle_in_domain(double u, double v, double radius) {
    nurbs *g = NULL;
    const double center[] = {u, v};
    if (nurbs_curve_circle(2, center, NULL, NULL, radius, NURBS_ARC_QUARTERS, &g) != NURBS_OK) {
        exit(2);
    }
    return g;
}

/* The face of loops of one curve each, which a test cannot go on without. */
static inline nurbs_face *face_of(const nurbs *surface, int64_t loops, const nurbs *const *curves) {
    static const int64_t ones[] = {1, 1, 1, 1, 1, 1, 1, 1};
    nurbs_face *face = NULL;
    if (nurbs_face_create(surface, loops, ones, curves, NULL, NULL, 1e-9, 0, NULL, &face) != NURBS_OK) {
        char text[check_text_size];
        (void)nurbs_last_error(text, check_text_size);
        fprintf(stderr, "a test face was refused: %s\n", text);
        exit(2);
    }
    return face;
}

/* The plane without a square hole in a square. */
static inline nurbs_face *frame_face(void) {
    nurbs *surface = plane(), *outer = square(0.125, 0.875), *inner = square(0.25, 0.5);
    const nurbs *curves[] = {inner, outer};
    nurbs_face *face = face_of(surface, 2, curves);
    nurbs_destroy(surface);
    nurbs_destroy(outer);
    nurbs_destroy(inner);
    return face;
}

#define VALUES(...) ((const double[]){__VA_ARGS__})
#define CURVES(...) ((const nurbs *const[]){__VA_ARGS__})
#define SIZES(...) ((const int64_t[]){__VA_ARGS__})

/* The same as CHECK_NO_HANDLE for faces. */
#define CHECK_NO_FACE(out, call, status, words)                                                              \
    do {                                                                                                     \
        (out) = (nurbs_face *)(void *)check_poison();                                                        \
        CHECK_FAILS(call, status, words);                                                                    \
        check_true(__FILE__, __LINE__, (out) == NULL, #out " == NULL");                                      \
    } while (0)

#endif
