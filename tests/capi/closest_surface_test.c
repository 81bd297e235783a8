/* SPDX-License-Identifier: MIT */
/* nurbs_closest_points() and its neighbours for surfaces and volumes. */
#include "shapes.h"

static const double corners[] = {0, 0, 0, 0, 2, 0, 4, 0, 0, 4, 2, 0};

static nurbs *bezier(int32_t axes, const int32_t *degrees, int32_t dim, const double *points) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(axes, degrees, dim, points, 0, 0, NULL, 0, &g));
    return g;
}

/* [0, 4] x [0, 2] in the plane z = 0. */
static nurbs *rectangle(void) {
    return bezier(2, (const int32_t[]){1, 1}, 3, corners);
}

/* The unit cube. */
static nurbs *unit_cube(void) {
    double points[24];
    for (int i = 0; i < 8; ++i) {
        points[3 * i] = i / 4;
        points[3 * i + 1] = i / 2 % 2;
        points[3 * i + 2] = i % 2;
    }
    return bezier(3, (const int32_t[]){1, 1, 1}, 3, points);
}

static void nearest_points(void) {
    nurbs *g = rectangle();
    const double points[] = {1, 1, 3, 5, -1, 0, 2, 1, 0, 4, 2, 7};
    const double expected[] = {0.25, 0.5, 1, 0, 0.5, 0.5, 1, 1}, away[] = {3, 1.4142135623730951, 0, 7};
    double params[8], feet[12], distances[4];
    int32_t status[4];
    CHECK_OK(nurbs_closest_points(g, 4, points, 0, 0, NULL, 0, 0, params, 0, 0, feet, 0, 0, distances, 0,
                                  status, 0));
    CHECK_NEAR(params, expected, 8, 1e-14);
    CHECK_NEAR(distances, away, 4, 1e-14);
    for (int i = 0; i < 4; ++i) {
        CHECK_NEAR(feet + 3 * i, ((const double[]){4 * expected[2 * i], 2 * expected[2 * i + 1], 0}), 3,
                   1e-14);
        CHECK_INT(status[i], NURBS_CLOSEST_CERTIFIED | (i % 2 == 1 ? NURBS_CLOSEST_BOUNDARY : 0));
    }
    const double range[] = {0.5, 1, 0, 0.25};
    CHECK_OK(nurbs_closest_points(g, 1, points, 0, 0, range, 0, 0, params, 0, 0, NULL, 0, 0, distances, 0,
                                  status, 0));
    CHECK_NEAR(params, ((const double[]){0.5, 0.25}), 2, 1e-14);
    CHECK_INT(status[0], NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_BOUNDARY);
    CHECK_OK(nurbs_farthest_points(g, 1, points, 0, 0, NULL, 0, 0, params, 0, 0, NULL, 0, 0, distances, 0,
                                   status, 0));
    CHECK_NEAR(params, ((const double[]){1, 0}), 1, 1e-14);
    CHECK_NEAR(distances, ((const double[]){sqrt(19)}), 1, 1e-14);
    CHECK_INT(status[0], NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_BOUNDARY | NURBS_CLOSEST_NOT_UNIQUE);
    const double guess[] = {0.9, 0.9};
    CHECK_OK(nurbs_closest_local(g, 1, points, 0, 0, guess, 0, 0, params, 0, 0, feet, 0, 0, distances, 0,
                                 status, 0));
    CHECK_NEAR(params, expected, 2, 1e-14);
    CHECK_INT(status[0], 0);
    nurbs_destroy(g);
}

/* A wall over the loop of shapes.h, periodic in u over [2, 6]: its seam is no boundary, the ends of a range
 * are. */
static void around(void) {
    static const int32_t degrees[] = {2, 1};
    static const int64_t counts[] = {6, 2};
    static const double knots[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 0, 0, 1, 1};
    static const double corners_of_u[] = {1, 1, -1, 1, -1, -1, 1, -1, 1, 1, -1, 1};
    const double far[] = {0, 5, 0.5},
                 range[] = {3, 5, 0, 1}; /* C(2) = (0, 1), C(3) = (-1, 0), C(5) = (1, 0) */
    double points[36], params[2];
    int32_t status = 0;
    nurbs *g = NULL;
    for (int i = 0; i < 12; ++i) {
        points[3 * i] = corners_of_u[i / 2 * 2];
        points[3 * i + 1] = corners_of_u[i / 2 * 2 + 1];
        points[3 * i + 2] = i % 2;
    }
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 13, 3, points, 0, 0, NULL, 0, NURBS_PERIODIC, &g));
    CHECK_OK(
        nurbs_closest_points(g, 1, far, 0, 0, NULL, 0, 0, params, 0, 0, NULL, 0, 0, NULL, 0, &status, 0));
    CHECK(params[0] == 2 || params[0] == 6);
    CHECK_INT(status & NURBS_CLOSEST_BOUNDARY, 0);
    CHECK_OK(
        nurbs_closest_points(g, 1, far, 0, 0, range, 0, 0, params, 0, 0, NULL, 0, 0, NULL, 0, &status, 0));
    CHECK(params[0] == 3 || params[0] == 5);
    CHECK_INT(status & NURBS_CLOSEST_BOUNDARY, NURBS_CLOSEST_BOUNDARY);
    nurbs_destroy(g);
}

static void volumes(void) {
    nurbs *g = unit_cube();
    const double points[] = {0.25, 0.5, 0.75, 2, 0.5, -1}, expected[] = {0.25, 0.5, 0.75, 1, 0.5, 0};
    double params[6], distances[2];
    int32_t status[2];
    CHECK_OK(nurbs_closest_points(g, 2, points, 0, 0, NULL, 0, 0, params, 0, 0, NULL, 0, 0, distances, 0,
                                  status, 0));
    CHECK_NEAR(params, expected, 6, 1e-14);
    CHECK_NEAR(distances, ((const double[]){0, sqrt(2)}), 2, 1e-15);
    CHECK_INT(status[0], NURBS_CLOSEST_CERTIFIED);
    CHECK_INT(status[1], NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_BOUNDARY);
    nurbs_destroy(g);
}

/* Over the rectangle: the foot, the four corners as maxima, and on each edge the foot along it. */
static void critical_points(void) {
    nurbs *g = rectangle();
    const double x[] = {1, 1, 3};
    const double expected[] = {0, 0, 0, 0.5, 0, 1, 0.25, 0, 0.25, 0.5, 0.25, 1, 1, 0, 1, 0.5, 1, 1};
    const int32_t max = NURBS_CRITICAL_MAXIMUM, mid = NURBS_CRITICAL_SADDLE;
    const int32_t kind[] = {max, mid, max, mid, NURBS_CRITICAL_MINIMUM, mid, max, mid, max};
    double params[18], distances[9];
    int32_t kinds[9], status = 0;
    int64_t count = 0;
    CHECK_OK(nurbs_critical_points(g, x, NULL, 0, 0, 9, params, distances, kinds, &count, &status));
    CHECK_INT(count, 9);
    CHECK_INT(status, NURBS_CLOSEST_CERTIFIED);
    CHECK_NEAR(params, expected, 18, 1e-12);
    for (int i = 0; i < 9; ++i) {
        CHECK_INT(kinds[i], kind[i]);
        const double dx = 4 * expected[2 * i] - 1, dy = 2 * expected[2 * i + 1] - 1;
        CHECK_NEAR(distances + i, ((const double[]){sqrt(dx * dx + dy * dy + 9)}), 1, 1e-14);
    }
    CHECK_OK(nurbs_closest_all(g, x, NULL, 0, 0, 9, params, distances, &count, &status));
    CHECK_INT(count, 1);
    CHECK_NEAR(params, ((const double[]){0.25, 0.5}), 2, 1e-14);
    CHECK_INT(status, NURBS_CLOSEST_CERTIFIED);
    nurbs_destroy(g);
}

static void bad_input(void) {
    nurbs *g = rectangle();
    const double x[] = {1, 1, NAN}, fine[] = {1, 1, 1}, outside[] = {0, 1, 0, 1.5},
                 empty[] = {0, 1, 0.5, 0.5};
    double params[2] = {7, 7};
    int32_t status = 7;
    CHECK_FAILS(nurbs_closest_points(g, 1, x, 0, 0, NULL, 0, 0, params, 0, 0, NULL, 0, 0, NULL, 0, NULL, 0),
                NURBS_ERROR_POINT_NOT_FINITE, "points");
    CHECK_FAILS(
        nurbs_closest_points(g, 1, fine, 0, 0, outside, 0, 0, params, 0, 0, NULL, 0, 0, NULL, 0, NULL, 0),
        NURBS_ERROR_OUTSIDE_DOMAIN, "range");
    CHECK_FAILS(
        nurbs_closest_points(g, 1, fine, 0, 0, empty, 0, 0, params, 0, 0, NULL, 0, 0, NULL, 0, NULL, 0),
        NURBS_ERROR_EMPTY_DOMAIN, "range");
    CHECK_FAILS(
        nurbs_closest_points(g, 1, fine, 0, 0, NULL, -1, 0, params, 0, 0, NULL, 0, 0, NULL, 0, NULL, 0),
        NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(
        nurbs_closest_local(g, 1, fine, 0, 0, outside + 2, 0, 0, params, 0, 0, NULL, 0, 0, NULL, 0, NULL, 0),
        NURBS_ERROR_OUTSIDE_DOMAIN, "guesses");
    CHECK(params[0] == 7 && params[1] == 7);
    CHECK_OK(nurbs_closest_points(g, 1, x, 0, 0, NULL, 0, 0, params, 0, 0, NULL, 0, 0, NULL, 0, &status,
                                  NURBS_NAN_POINTS));
    CHECK_INT(status, NURBS_CLOSEST_INVALID);
    CHECK(isnan(params[0]) && isnan(params[1]));
    nurbs_destroy(g);
}

int main(void) {
    nearest_points();
    around();
    volumes();
    critical_points();
    bad_input();
    return check_summary("closest_surface");
}
