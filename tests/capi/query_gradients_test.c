/* SPDX-License-Identifier: MIT */
/* nurbs_closest_adjoint() and nurbs_length_adjoint(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

enum { room = 32 };

static double points[room], weights[room], queries[room];
static int32_t status[4];

/* A segment from (0, 0) to (2, 0). */
static SplineArgs segment(void) {
    static const int32_t degrees[] = {1};
    static const int64_t counts[] = {2};
    static const double knots[] = {0, 0, 1, 1}, net[] = {0, 0, 2, 0};
    SplineArgs a = {1, degrees, counts, knots, 4, 2, net, 0, 0, NULL, 0, 0};
    return a;
}

/* The foot of (1/2, 1) is (1/2, 0) at 1/4, with dt = <dx, (1/2, 0)> and dd = <dx, (0, 1)>. */
static void foot_of_a_segment(void) {
    static const double point[] = {0.5, 1}, param = 0.25, one = 1, along[] = {3, 5};
    nurbs *g = make(segment());
    CHECK_OK(
        nurbs_closest_adjoint(g, 1, point, &param, &one, NULL, &one, points, weights, queries, status, 0));
    CHECK_DOUBLES(queries, ((const double[]){0.5, 1}), 2);
    CHECK_DOUBLES(points, ((const double[]){-0.375, -0.75 - 0.25, -0.125, -0.25 + 0.25}), 4);
    CHECK(status[0] == 0);
    /* the foot itself follows the point along the segment, and the segment across it */
    CHECK_OK(nurbs_closest_adjoint(g, 1, point, &param, NULL, along, NULL, points, NULL, queries, NULL, 0));
    CHECK_DOUBLES(queries, ((const double[]){3, 0}), 2);
    CHECK_DOUBLE(points[1] + points[3], 5);
    CHECK_DOUBLE(points[0] + points[2], 0);
    CHECK_OK(nurbs_closest_adjoint(g, 0, NULL, NULL, NULL, NULL, NULL, points, weights, NULL, NULL, 0));
    CHECK_DOUBLES(points, ((const double[]){0, 0, 0, 0}), 4);
    nurbs_destroy(g);
}

/* No single foot at the centre of a circle, and no gradient of the distance 0, but of all else. */
static void singular(void) {
    static const double centre[] = {0, 0}, on_it[] = {0.5, 0}, param = 0.125, quarter = 0.25, one = 1;
    nurbs *g = make(circle());
    CHECK_OK(
        nurbs_closest_adjoint(g, 1, centre, &param, &one, NULL, NULL, points, weights, queries, status, 0));
    CHECK(status[0] == NURBS_CLOSEST_SINGULAR);
    CHECK(points[0] == 0 && points[2] == 0 && weights[1] == 0 && queries[0] == 0 && queries[1] == 0);
    nurbs_destroy(g);
    g = make(segment());
    CHECK_OK(
        nurbs_closest_adjoint(g, 1, on_it, &quarter, NULL, NULL, &one, points, weights, queries, status, 0));
    CHECK(status[0] == NURBS_CLOSEST_SINGULAR && points[1] == 0 && queries[1] == 0);
    CHECK_OK(
        nurbs_closest_adjoint(g, 1, on_it, &quarter, &one, NULL, NULL, points, weights, queries, status, 0));
    CHECK(status[0] == 0);
    CHECK_DOUBLES(queries, ((const double[]){0.5, 0}), 2);
    /* the parameter moves all the same */
    CHECK_OK(
        nurbs_closest_adjoint(g, 1, on_it, &quarter, &one, NULL, &one, points, weights, queries, status, 0));
    CHECK(status[0] == NURBS_CLOSEST_SINGULAR);
    CHECK_DOUBLES(queries, ((const double[]){0.5, 0}), 2);
    nurbs_destroy(g);
}

static void points_that_are_no_numbers(void) {
    static const double given[] = {0.5, 1, NAN, 1}, params[] = {0.25, NAN}, ones[] = {1, 1};
    nurbs *g = make(segment());
    CHECK_OK(nurbs_closest_adjoint(g, 2, given, params, ones, NULL, NULL, points, NULL, queries, status,
                                   NURBS_NAN_POINTS));
    CHECK(status[0] == 0 && status[1] == NURBS_CLOSEST_INVALID);
    CHECK(isnan(queries[2]) && isnan(queries[3]) && queries[0] == 0.5);
    CHECK_DOUBLES(points, ((const double[]){-0.375, -0.25, -0.125, 0.25}), 4);
    nurbs_destroy(g);
}

typedef struct Foot {
    const nurbs *g;
    int64_t n;
    const double *points, *params, *of_params, *of_feet, *of_distances;
    double *to_points, *to_weights, *to_queries;
    int32_t *status;
    uint32_t flags;
} Foot;

static const double good[] = {0.5, 1, 0.25, 1}, at[] = {0.25, 0.5}, given[] = {1, 2, 3, 4};

#define BAD_FOOT(field, value, expected, words)                                                              \
    do {                                                                                                     \
        Foot a_ = {g, 2, good, at, given, given, given, points, weights, queries, status, 0};                \
        a_.field = (value);                                                                                  \
        FILL(points);                                                                                        \
        FILL(weights);                                                                                       \
        FILL(queries);                                                                                       \
        CHECK_FAILS(nurbs_closest_adjoint(a_.g, a_.n, a_.points, a_.params, a_.of_params, a_.of_feet,        \
                                          a_.of_distances, a_.to_points, a_.to_weights, a_.to_queries,       \
                                          a_.status, a_.flags),                                              \
                    expected, words);                                                                        \
        CHECK_UNTOUCHED(points);                                                                             \
        CHECK_UNTOUCHED(weights);                                                                            \
        CHECK_UNTOUCHED(queries);                                                                            \
    } while (0)

static void bad_feet(void) {
    nurbs *g = make(segment());
    BAD_FOOT(g, NULL, NURBS_ERROR_NULL, "g");
    BAD_FOOT(n, -1, NURBS_ERROR_COUNT, "n|-1");
    BAD_FOOT(n, INT64_MAX, NURBS_ERROR_OVERFLOW, "");
    BAD_FOOT(points, NULL, NURBS_ERROR_NULL, "points");
    BAD_FOOT(params, NULL, NURBS_ERROR_NULL, "params");
    BAD_FOOT(points, edited(good, 4, 3, INFINITY), NURBS_ERROR_POINT_NOT_FINITE, "points[1][1]|inf");
    BAD_FOOT(params, edited(at, 2, 1, NAN), NURBS_ERROR_PARAMETER_NOT_FINITE, "params[1]|nan");
    BAD_FOOT(params, edited(at, 2, 0, 1.5), NURBS_ERROR_OUTSIDE_DOMAIN, "params[0]|1.5");
    BAD_FOOT(flags, NURBS_CLAMP, NURBS_ERROR_FLAGS, "flags");
    BAD_FOOT(flags, NURBS_ON_AXIS(1, NURBS_LEFT), NURBS_ERROR_FLAGS, "flags");
    BAD_FOOT(to_weights, points + 3, NURBS_ERROR_OVERLAP, "grad_points|grad_weights");
    BAD_FOOT(to_queries, points + 3, NURBS_ERROR_OVERLAP, "grad_points|grad_queries");
    BAD_FOOT(to_points, (double *)(uintptr_t)good, NURBS_ERROR_OVERLAP, "grad_points|points");
    BAD_FOOT(to_queries, (double *)(uintptr_t)at, NURBS_ERROR_OVERLAP, "grad_queries|params");
    BAD_FOOT(to_queries, (double *)(uintptr_t)given, NURBS_ERROR_OVERLAP, "grad_queries|cotangents");
    nurbs_destroy(g);
}

/* Nothing depends on where the curve lies, or on a factor of all weights. */
static void length_of_an_arch(void) {
    double error = 1, whole[8];
    nurbs *g = make(arch());
    CHECK_OK(nurbs_length_adjoint(g, NULL, 1e-10, 1, points, 0, 0, weights, 0, &error, 0));
    CHECK(error < 1e-8);
    CHECK(fabs(points[0] + points[2] + points[4] + points[6]) <= 1e-12);
    CHECK(fabs(points[1] + points[3] + points[5] + points[7]) <= 1e-12);
    CHECK(fabs(weights[0] + weights[1] + weights[2] + weights[3]) <= 1e-12);
    memcpy(whole, points, sizeof whole);
    CHECK_OK(nurbs_length_adjoint(g, NULL, 1e-10, -1, points, 0, 0, NULL, 0, NULL, NURBS_ACCUMULATE));
    CHECK_DOUBLES(points, ((const double[]){0, 0, 0, 0, 0, 0, 0, 0}), 8);
    CHECK_OK(nurbs_length_adjoint(g, NULL, 1e-10, 1, points, 3, 0, points + 2, 3, NULL, 0));
    CHECK_DOUBLE(points[9], whole[6]);
    CHECK_DOUBLE(points[11], weights[3]);
    nurbs_destroy(g);
}

/* Half of a segment, and a curve that is a point. */
static void length_of_a_segment(void) {
    static const double half[] = {0, 0.5}, still[] = {1, 1, 1, 1};
    SplineArgs a = segment();
    nurbs *g = make(a);
    CHECK_FAILS(nurbs_length_adjoint(g, NULL, 1e-12, NAN, points, 0, 0, weights, 0, NULL, 0),
                NURBS_ERROR_NOT_REPRESENTABLE, "cotangent");
    CHECK_OK(nurbs_length_adjoint(g, half, 1e-12, 2, points, 0, 0, weights, 0, NULL, 0));
    CHECK(fabs(points[0] + 1) <= 1e-14);
    CHECK(fabs(points[2] - 1) <= 1e-14);
    CHECK(fabs(points[1]) <= 1e-14);
    nurbs_destroy(g);
    a.points = still;
    g = make(a);
    CHECK_OK(nurbs_length_adjoint(g, NULL, 1e-12, 1, points, 0, 0, weights, 0, NULL, 0));
    CHECK_DOUBLES(points, ((const double[]){0, 0, 0, 0}), 4);
    nurbs_destroy(g);
}

typedef struct Length {
    const nurbs *g;
    const double *range;
    double tolerance;
    double *to_points;
    int64_t ps, pcs;
    double *to_weights;
    int64_t ws;
    double *error;
    uint32_t flags;
} Length;

#define BAD_LENGTH(field, value, expected, words)                                                            \
    do {                                                                                                     \
        Length a_ = {g, NULL, 1e-6, points, 0, 0, weights, 0, queries, 0};                                   \
        a_.field = (value);                                                                                  \
        FILL(points);                                                                                        \
        FILL(weights);                                                                                       \
        FILL(queries);                                                                                       \
        CHECK_FAILS(nurbs_length_adjoint(a_.g, a_.range, a_.tolerance, 1, a_.to_points, a_.ps, a_.pcs,       \
                                         a_.to_weights, a_.ws, a_.error, a_.flags),                          \
                    expected, words);                                                                        \
        CHECK_UNTOUCHED(points);                                                                             \
        CHECK_UNTOUCHED(weights);                                                                            \
        CHECK_UNTOUCHED(queries);                                                                            \
    } while (0)

/* A half circle of radius 1 whose middle control point is at infinity: the weight gradient of that one is
 * infinite, too. With the angle a, dL/dP_0 is the integral of sin(a) / 2 (sin(a), -cos(a)). */
static void length_of_a_half_circle(void) {
    static const double records[] = {1, 0, 1, 0, 1, 0, -1, 0, 1}, knots[] = {0, 0, 0, 1, 1, 1};
    static const double quarter = 0.78539816339744831,
                        expected[] = {0.78539816339744831, 0, 0, 0, -0.78539816339744831, 0};
    static const int32_t degree = 2;
    static const int64_t count = 3;
    double points[6], weights[3];
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 6, 2, records, 0, 0, 0, &g));
    CHECK_OK(nurbs_length_adjoint(g, NULL, 1e-12, 1, points, 0, 0, NULL, 0, NULL, 0));
    CHECK_NEAR(points, expected, 6, 1e-12 * quarter);
    FILL(weights);
    CHECK_FAILS(nurbs_length_adjoint(g, NULL, 1e-12, 1, points, 0, 0, weights, 0, NULL, 0),
                NURBS_ERROR_NOT_REPRESENTABLE, "gradient");
    CHECK_UNTOUCHED(weights);
    CHECK_OK(nurbs_length_adjoint(g, NULL, 1e-12, 1, NULL, 0, 0, NULL, 0, NULL, 0));
    nurbs_destroy(g);
}

static void bad_lengths(void) {
    static const double reversed[] = {0.5, 0.25}, beyond[] = {0, 2}, strange[] = {0, NAN};
    nurbs *g = make(arch());
    nurbs *surface = make(patch());
    BAD_LENGTH(g, NULL, NURBS_ERROR_NULL, "g");
    BAD_LENGTH(g, surface, NURBS_ERROR_AXES, "");
    BAD_LENGTH(tolerance, -1, NURBS_ERROR_TOLERANCE, "relative_tolerance|-1");
    BAD_LENGTH(tolerance, NAN, NURBS_ERROR_TOLERANCE, "relative_tolerance|nan");
    BAD_LENGTH(range, reversed, NURBS_ERROR_EMPTY_DOMAIN, "range");
    BAD_LENGTH(range, beyond, NURBS_ERROR_OUTSIDE_DOMAIN, "range");
    BAD_LENGTH(range, strange, NURBS_ERROR_PARAMETER_NOT_FINITE, "range");
    BAD_LENGTH(ps, 1, NURBS_ERROR_STRIDE, "grad_point");
    BAD_LENGTH(to_weights, points + 7, NURBS_ERROR_OVERLAP, "grad_points|grad_weights");
    BAD_LENGTH(error, points + 7, NURBS_ERROR_OVERLAP, "error");
    BAD_LENGTH(error, weights + 3, NURBS_ERROR_OVERLAP, "error");
    nurbs_destroy(surface);
    nurbs_destroy(g);
}

int main(void) {
    foot_of_a_segment();
    singular();
    points_that_are_no_numbers();
    bad_feet();
    length_of_an_arch();
    length_of_a_segment();
    length_of_a_half_circle();
    bad_lengths();
    return check_summary("query_gradients");
}
