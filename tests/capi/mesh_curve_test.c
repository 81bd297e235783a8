/* SPDX-License-Identifier: MIT */
/* Polylines in place of curves: known ones, the query of lengths, what is refused, and what ends a long call. */
#include "shapes.h"

static double apart(const double *a, const double *b) {
    return hypot(a[0] - b[0], a[1] - b[1]);
}

/* Chords of the unit circle: the bound is 1 - cos(turn / 2) of the longest one. */
static void a_circle(void) {
    nurbs *g = make(circle());
    double params[100], points[200], bound = -1;
    int32_t reached = -1;
    int64_t count = -1;
    CHECK_OK(nurbs_mesh_curve(g, 0.01, 0, 0, 0, NULL, NULL, &bound, &reached, &count));
    CHECK_INT(reached, 1);
    CHECK(count >= 24 && count <= 25); /* pi / acos(0.99) = 22.2 */
    CHECK_OK(nurbs_mesh_curve(g, 0.01, 0, 0, 100, params, points, NULL, NULL, NULL));
    double longest = 0;
    for (int64_t i = 0; i < count; ++i) {
        double x[2];
        CHECK_OK(nurbs_eval(g, 1, params + i, 0, 0, x, 0, 0, 0));
        CHECK(x[0] == points[2 * i] && x[1] == points[2 * i + 1]);
        longest = i > 0 ? fmax(longest, apart(points + 2 * i, points + 2 * i - 2)) : longest;
    }
    const double sagitta = 1 - sqrt(1 - longest * longest / 4);
    CHECK(bound >= sagitta && bound <= 1.02 * sagitta && bound <= 0.01);
    CHECK(points[0] == points[2 * count - 2] && points[1] == points[2 * count - 1]);
    nurbs_destroy(g);
}

static void limits(void) {
    nurbs *g = make(circle());
    double points[200], bound = -1;
    int32_t reached = -1;
    int64_t count = -1;
    CHECK_OK(nurbs_mesh_curve(g, INFINITY, 1.6, 0, 100, NULL, points, &bound, &reached, &count));
    CHECK(reached == 1 && count == 5 && bound < 0.3); /* quarters: 1 - sqrt(1/2) */
    CHECK_OK(nurbs_mesh_curve(g, 10, 0, 0, 0, NULL, NULL, &bound, &reached, &count));
    CHECK(reached == 1 && count == 4 && bound > 0.4 && bound < 1.5); /* a triangle at least */
    CHECK_OK(nurbs_mesh_curve(g, INFINITY, 0, 0.5, 100, NULL, points, &bound, &reached, &count));
    CHECK(reached == 1 && count >= 14 && count <= 17);
    for (int64_t i = 1; i < count; ++i) {
        CHECK(apart(points + 2 * i, points + 2 * i - 2) <= 0.5);
    }
    nurbs_destroy(g);
}

/* A curve of degree 1 is its polyline; one of degree 0 jumps. */
static void corners_and_jumps(void) {
    const int32_t one = 1, zero = 0;
    const int64_t four = 4, two = 2;
    const double knots[] = {0, 0, 1, 2, 3, 3}, points[] = {0, 0, 1, 0, 1, 1, 2, 1};
    SplineArgs args = {1, &one, &four, knots, 6, 2, points, 0, 0, NULL, 0, 0};
    nurbs *g = make(args);
    double params[8], found[8];
    int64_t count = -1;
    int32_t reached = -1;
    CHECK_OK(nurbs_mesh_curve(g, 1e-12, 0, 0, 4, params, found, NULL, &reached, &count));
    CHECK(count == 4 && reached == 1);
    for (int i = 0; i < 8; ++i) {
        CHECK(found[i] == points[i] && (i > 3 || params[i] == i));
    }
    nurbs_destroy(g);
    const double steps[] = {0, 1, 2}, heights[] = {3, 5};
    SplineArgs jump = {1, &zero, &two, steps, 3, 1, heights, 0, 0, NULL, 0, 0};
    g = make(jump);
    CHECK_OK(nurbs_mesh_curve(g, 1e-12, 0, 0, 4, params, found, NULL, &reached, &count));
    CHECK(count == 4 && reached == 1 && params[1] == 1 && params[2] == 1);
    CHECK(found[0] == 3 && found[1] == 3 && found[2] == 5 && found[3] == 5);
    nurbs_destroy(g);
}

static int32_t stop(double done, void *user) {
    (void)done;
    (void)user;
    return 1;
}

static void watched(void) {
    nurbs *g = make(arch());
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    double bound = -1;
    int32_t reached = -1;
    int64_t count = -1, again = -1;
    CHECK_OK(nurbs_mesh_curve(g, 1e-4, 0, 0, 0, NULL, NULL, NULL, NULL, &count));
    CHECK_OK(nurbs_mesh_curve_with(g, 1e-4, 0, 0, 0, NULL, NULL, &bound, &reached, &again, NULL));
    CHECK(again == count && reached == 1 && bound <= 1e-4);
    call.work = 5000;
    CHECK_OK(nurbs_mesh_curve_with(g, 1e-4, 0, 0, 0, NULL, NULL, &bound, &reached, &again, &call));
    CHECK(again < count && reached == 0 && bound > 1e-4);
    call.work = -1;
    CHECK_FAILS(nurbs_mesh_curve_with(g, 1, 0, 0, 0, NULL, NULL, &bound, &reached, &count, &call),
                NURBS_ERROR_OPTIONS, "work");
    call.work = 0;
    call.progress = stop;
    CHECK_FAILS(nurbs_mesh_curve_with(g, 1e-15, 0, 1e-9, 0, NULL, NULL, &bound, &reached, &again, &call),
                NURBS_ERROR_CANCELLED, "");
    nurbs_destroy(g);
}

static void refused(void) {
    nurbs *g = make(arch()), *sphere = NULL;
    const double center[] = {0, 0, 0};
    CHECK_OK(nurbs_surface_sphere(center, NULL, NULL, 1, NURBS_ARC_QUARTERS, &sphere));
    double a[100] = {0}, b[100], r = -1;
    int32_t reached = -1;
    int64_t count = -1;
    CHECK_FAILS(nurbs_mesh_curve(NULL, 1, 0, 0, 9, a, b, &r, &reached, &count), NURBS_ERROR_NULL,
                "g is NULL");
    CHECK_FAILS(nurbs_mesh_curve(sphere, 1, 0, 0, 9, a, b, &r, &reached, &count), NURBS_ERROR_AXES, "");
    CHECK_FAILS(nurbs_mesh_curve(g, 0, 0, 0, 9, a, b, &r, &reached, &count), NURBS_ERROR_TOLERANCE,
                "chord = 0");
    CHECK_FAILS(nurbs_mesh_curve(g, NAN, 1, 0, 9, a, b, &r, &reached, &count), NURBS_ERROR_TOLERANCE,
                "chord");
    CHECK_FAILS(nurbs_mesh_curve(g, INFINITY, 0, 0, 9, a, b, &r, &reached, &count), NURBS_ERROR_TOLERANCE,
                "chord = inf");
    CHECK_FAILS(nurbs_mesh_curve(g, 1, 3.15, 0, 9, a, b, &r, &reached, &count), NURBS_ERROR_ANGLE, "3.15");
    CHECK_FAILS(nurbs_mesh_curve(g, 1, -1, 0, 9, a, b, &r, &reached, &count), NURBS_ERROR_ANGLE,
                "angle = -1");
    CHECK_FAILS(nurbs_mesh_curve(g, 1, NAN, 0, 9, a, b, &r, &reached, &count), NURBS_ERROR_ANGLE, "angle");
    CHECK_FAILS(nurbs_mesh_curve(g, 1, 0, -1, 9, a, b, &r, &reached, &count), NURBS_ERROR_LENGTH,
                "longest = -1");
    CHECK_FAILS(nurbs_mesh_curve(g, 1, 0, INFINITY, 9, a, b, &r, &reached, &count), NURBS_ERROR_LENGTH,
                "longest");
    CHECK_FAILS(nurbs_mesh_curve(g, 1, 0, 0, -1, a, b, &r, &reached, &count), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_mesh_curve(g, 0.01, 0, 0, 2, a, b, &r, &reached, &count), NURBS_ERROR_SIZE, "cap = 2");
    CHECK_FAILS(nurbs_mesh_curve(g, 0.01, 0, 0, 99, a, a + 1, &r, &reached, &count), NURBS_ERROR_OVERLAP,
                "points|params");
    CHECK(count == -1 && reached == -1 && r == -1 && a[0] == 0);
    nurbs_destroy(g);
    nurbs_destroy(sphere);
}

/* Sizes at both ends of the range of doubles. */
static void enormous(void) {
    const double sizes[] = {1.7e308, 1e150, 1e-150, 1e-300};
    for (int i = 0; i < 4; ++i) {
        const double s = sizes[i], points[] = {-s, -s, 0, s, s, -s};
        const int32_t degree = 2;
        nurbs *g = NULL;
        double bound = -1;
        int32_t reached = -1;
        int64_t count = -1;
        CHECK_OK(nurbs_create_bezier(1, &degree, 2, points, 0, 0, NULL, 0, &g));
        CHECK_OK(nurbs_mesh_curve(g, 1e-3 * s, 0, 0, 0, NULL, NULL, &bound, &reached, &count));
        if (s > 1e308) { /* distances overflow */
            CHECK(reached == 0 && count == 2 && isinf(bound));
        } else {
            CHECK(reached == 1 && count >= 12 && count <= 30 && bound <= 1e-3 * s);
        }
        nurbs_destroy(g);
    }
}

int main(void) {
    a_circle();
    limits();
    corners_and_jumps();
    watched();
    refused();
    enormous();
    return check_summary("mesh_curve");
}
