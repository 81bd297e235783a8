/* SPDX-License-Identifier: MIT */
/* nurbs_points(), nurbs_weights() and nurbs_homogeneous_points(): stored values bit for bit, in any layout.
 */
#include "check.h"

#include "shapes.h"

#include <stdint.h>

/* Weights of 0 keep their point, signed zeros their sign, and nothing is rounded on the way. */
static SplineArgs odd_values(void) {
    static const double points[] = {-0.0, 0.1, 1e300, -3e-310, 7, 11, 4, -0.0};
    static const double weights[] = {1.0 / 3, 0, -0.0, 3e200};
    SplineArgs a = arch();
    a.points = points;
    a.weights = weights;
    return a;
}

static void stored_bits(SplineArgs a, int64_t n) {
    double points[64], weights[16];
    nurbs *g = make(a);
    CHECK_OK(nurbs_points(g, n, points, 0, 0));
    CHECK_BITS(points, a.points, (size_t)n * (size_t)a.dim * sizeof *points);
    CHECK_OK(nurbs_weights(g, n, weights, 0));
    for (int64_t i = 0; i < n; ++i) {
        CHECK_DOUBLE(weights[i], a.weights == NULL ? 1 : a.weights[i]);
    }
    nurbs_destroy(g);
}

static void homogeneous(void) {
    static const double expected[] = {0, 0, 1, 1, 2, 1, 3, 2, 1, 4, 0, 1}, weights[] = {1, 2, 0, 0.5};
    static const double rational[] = {0, 0, 1, 2, 4, 2, 0, 0, 0, 2, 0, 0.5};
    double records[12];
    nurbs *g = make(arch());
    CHECK_OK(nurbs_homogeneous_points(g, 4, records, 0, 0));
    CHECK_DOUBLES(records, expected, 12);
    nurbs_destroy(g);
    SplineArgs a = arch();
    a.weights = weights;
    g = make(a);
    CHECK_OK(nurbs_homogeneous_points(g, 4, records, 0, 0));
    CHECK_DOUBLES(records, rational, 12);
    nurbs_destroy(g);
}

/* Only the places that the strides name are written. */
static void layouts(void) {
    static const double fortran[] = {0, 1, 3, 4, 0, 2, 2, 0};
    double points[16], gap;
    nurbs *g = make(arch());
    memset(&gap, 0x5a, sizeof gap);
    CHECK_OK(nurbs_points(g, 4, points, 1, 4));
    CHECK_DOUBLES(points, fortran, 8);
    FILL(points);
    CHECK_OK(nurbs_points(g, 4, points, 3, 1));
    for (int i = 0; i < 4; ++i) {
        CHECK_DOUBLES(points + 3 * i, arch().points + 2 * i, 2);
        CHECK_BITS(points + 3 * i + 2, &gap, sizeof gap);
    }
    FILL(points);
    CHECK_OK(nurbs_points(g, 4, points, 0, 2));
    for (int i = 0; i < 8; ++i) {
        CHECK_DOUBLE(points[2 * i], arch().points[i]);
    }
    FILL(points);
    CHECK_OK(nurbs_weights(g, 4, points, 2));
    for (int i = 0; i < 4; ++i) {
        CHECK_DOUBLE(points[2 * i], 1);
        CHECK(i == 3 || memcmp(points + 2 * i + 1, &gap, sizeof gap) == 0);
    }
    FILL(points);
    CHECK_OK(nurbs_homogeneous_points(g, 4, points, 1, 4));
    CHECK_DOUBLES(points, fortran, 8);
    CHECK_DOUBLE(points[8], 1);
    nurbs_destroy(g);
}

static void bad_arguments(void) {
    double values[64];
    nurbs *g = make(arch());
    static const int64_t lengths[] = {3, 5, 0, -1, INT64_MAX};
    FILL(values);
    CHECK_FAILS(nurbs_points(NULL, 4, values, 0, 0), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_points(g, 4, NULL, 0, 0), NURBS_ERROR_NULL, "points");
    CHECK_FAILS(nurbs_weights(NULL, 4, values, 0), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_weights(g, 4, NULL, 0), NURBS_ERROR_NULL, "weights");
    CHECK_FAILS(nurbs_homogeneous_points(NULL, 4, values, 0, 0), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_homogeneous_points(g, 4, NULL, 0, 0), NURBS_ERROR_NULL, "points");
    for (int i = 0; i < 5; ++i) {
        CHECK_FAILS(nurbs_points(g, lengths[i], values, 0, 0), NURBS_ERROR_SIZE, "count|4");
        CHECK_FAILS(nurbs_weights(g, lengths[i], values, 0), NURBS_ERROR_SIZE, "count|4");
        CHECK_FAILS(nurbs_homogeneous_points(g, lengths[i], values, 0, 0), NURBS_ERROR_SIZE, "count|4");
    }
    CHECK_FAILS(nurbs_points(g, 4, values, -1, 0), NURBS_ERROR_STRIDE, "point|-1");
    CHECK_FAILS(nurbs_points(g, 4, values, 0, -1), NURBS_ERROR_STRIDE, "point|-1");
    CHECK_FAILS(nurbs_points(g, 4, values, 1, 1), NURBS_ERROR_STRIDE, "point|1");
    CHECK_FAILS(nurbs_points(g, 4, values, 1, 3), NURBS_ERROR_STRIDE, "point|3");
    CHECK_FAILS(nurbs_points(g, 4, values, 3, 3), NURBS_ERROR_STRIDE, "point|3");
    CHECK_FAILS(nurbs_weights(g, 4, values, -1), NURBS_ERROR_STRIDE, "weight|-1");
    CHECK_FAILS(nurbs_homogeneous_points(g, 4, values, 2, 1), NURBS_ERROR_STRIDE, "point|2");
    CHECK_FAILS(nurbs_homogeneous_points(g, 4, values, 0, INT64_MIN), NURBS_ERROR_STRIDE, "point");
    CHECK_UNTOUCHED(values);
    nurbs_destroy(g);
}

/* The header lists no overflow status here; whichever is given, nothing is written. */
static void huge_strides(void) {
    double values[64];
    nurbs *g = make(arch());
    FILL(values);
    CHECK(nurbs_points(g, 4, values, INT64_MAX, 0) != NURBS_OK);
    CHECK(nurbs_points(g, 4, values, 0, INT64_MAX) != NURBS_OK);
    CHECK(nurbs_points(g, 4, values, INT64_MAX / 2, 1) != NURBS_OK);
    CHECK(nurbs_weights(g, 4, values, INT64_MAX / 2) != NURBS_OK);
    CHECK(nurbs_homogeneous_points(g, 4, values, INT64_MAX / 4 + 1, 0) != NURBS_OK);
    CHECK_UNTOUCHED(values);
    nurbs_destroy(g);
}

int main(void) {
    stored_bits(odd_values(), 4);
    stored_bits(arch(), 4);
    stored_bits(circle(), 9);
    stored_bits(trough(), 12);
    stored_bits(cube(), 8);
    stored_bits(loop(), 6);
    homogeneous();
    layouts();
    bad_arguments();
    huge_strides();
    return check_summary("points");
}
