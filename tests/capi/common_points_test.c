/* SPDX-License-Identifier: MIT */
/* The points of three surfaces: known shapes, what is left open, limits of work, bad input. */
#include "faces.h"

#include <math.h>
#include <string.h>

enum { most = 8 };

static nurbs *ball(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_sphere(NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &g));
    return g;
}

/* Through a point, 4 by 4 along two axes of space. */
static nurbs *flat(double x, double y, double z, const double *u, const double *v) {
    const double origin[] = {x - 2 * u[0] - 2 * v[0], y - 2 * u[1] - 2 * v[1], z - 2 * u[2] - 2 * v[2]};
    const double along[] = {4 * u[0], 4 * u[1], 4 * u[2]}, across[] = {4 * v[0], 4 * v[1], 4 * v[2]};
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_plane(3, origin, along, across, &g));
    return g;
}

static const double ex[] = {1, 0, 0}, ey[] = {0, 1, 0}, ez[] = {0, 0, 1};

static void a_ball_and_two_planes(void) {
    nurbs *a = ball(), *b = flat(0.48, 0, 0, ey, ez), *c = flat(0, 0, 0.64, ex, ey);
    double params[6 * most], points[3 * most], ranges[12 * most];
    int32_t kinds[most], complete = -1;
    int64_t count = -1;
    CHECK_OK(
        nurbs_surfaces_common_points(a, b, c, 0, most, params, points, kinds, ranges, &count, &complete));
    CHECK(count == 2 && complete == 1);
    for (int i = 0; i < 2; ++i) {
        const double *x = points + 3 * i, *at = params + 6 * i;
        double on[3][3];
        CHECK_INT(kinds[i], NURBS_HIT_CROSSING);
        CHECK(fabs(x[0] - 0.48) < 1e-14 && fabs(fabs(x[1]) - 0.6) < 1e-14 && fabs(x[2] - 0.64) < 1e-14);
        CHECK_OK(nurbs_eval(a, 1, at, 0, 0, on[0], 0, 0, 0));
        CHECK_OK(nurbs_eval(b, 1, at + 2, 0, 0, on[1], 0, 0, 0));
        CHECK_OK(nurbs_eval(c, 1, at + 4, 0, 0, on[2], 0, 0, 0));
        for (int s = 0; s < 3; ++s) {
            CHECK_NEAR(on[s], x, 3, 1e-14);
        }
        for (int k = 0; k < 6; ++k) {
            const double *range = ranges + 12 * i + 2 * k;
            CHECK(range[0] <= at[k] && at[k] <= range[1] && range[1] - range[0] < 1e-10);
        }
    }
    CHECK(params[0] < params[6]);
    CHECK_OK(nurbs_surfaces_common_points(a, b, c, 0, 0, NULL, NULL, NULL, NULL, &count, NULL));
    CHECK_INT(count, 2);
    CHECK_OK(nurbs_surfaces_common_points(c, b, b, 1e-3, 0, NULL, NULL, NULL, NULL, &count, &complete));
    CHECK(count >= 1 && complete == 0); /* two are one, and meet the third in a line */
    nurbs_destroy(c);
    c = flat(0, 0, 1.5, ex, ey);
    CHECK_OK(nurbs_surfaces_common_points(a, b, c, 0, 0, NULL, NULL, NULL, NULL, &count, &complete));
    CHECK(count == 0 && complete == 1);
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(c);
}

static int32_t stop(double done, void *user) {
    (void)done;
    ++*(int *)user;
    return 1;
}

static void watched(void) {
    nurbs *a = ball(), *b = flat(0.48, 0, 0, ey, ez), *c = flat(0, 0, 0.64, ex, ey);
    nurbs_call_options call;
    int64_t count = 0;
    int32_t complete = -1;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.work = 1;
    CHECK_OK(
        nurbs_surfaces_common_points_with(a, b, c, 0, 0, NULL, NULL, NULL, NULL, &count, &complete, &call));
    CHECK(count >= 1 && complete == 0);
    int asked = 0;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.progress = stop;
    call.user = &asked;
    CHECK_FAILS(
        nurbs_surfaces_common_points_with(a, a, a, 0, 0, NULL, NULL, NULL, NULL, &count, &complete, &call),
        NURBS_ERROR_CANCELLED, "");
    CHECK_INT(asked, 1);
    call.struct_size = 1;
    CHECK_FAILS(
        nurbs_surfaces_common_points_with(a, b, c, 0, 0, NULL, NULL, NULL, NULL, &count, &complete, &call),
        NURBS_ERROR_OPTIONS, "struct_size");
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(c);
}

static void refused(void) {
    nurbs *a = ball(), *b = flat(0.48, 0, 0, ey, ez), *c = flat(0, 0, 0.64, ex, ey), *level = NULL,
          *curve = segment(0, 0, 1, 1);
    const double drop[] = {1, 0, 0, 0, 1, 0};
    CHECK_OK(nurbs_transform(c, 2, drop, NULL, &level));
    double params[6 * most], points[3 * most], ranges[12 * most];
    int32_t kinds[most], complete = 0;
    int64_t count = 0;
    memset(params, 0x5a, sizeof params);
    memset(points, 0x5a, sizeof points);
    memset(ranges, 0x5a, sizeof ranges);
    memset(kinds, 0x5a, sizeof kinds);
#define REFUSED(a, b, c, tolerance, cap, points, status, words)                                              \
    CHECK_FAILS(nurbs_surfaces_common_points(a, b, c, tolerance, cap, params, points, kinds, ranges, &count, \
                                             &complete),                                                     \
                status, words)
    REFUSED(NULL, b, c, 0, most, points, NURBS_ERROR_NULL, "a is NULL");
    REFUSED(a, NULL, c, 0, most, points, NURBS_ERROR_NULL, "b is NULL");
    REFUSED(a, b, NULL, 0, most, points, NURBS_ERROR_NULL, "c is NULL");
    REFUSED(curve, b, c, 0, most, points, NURBS_ERROR_AXES, "a");
    REFUSED(a, curve, c, 0, most, points, NURBS_ERROR_AXES, "b");
    REFUSED(a, b, curve, 0, most, points, NURBS_ERROR_AXES, "c");
    REFUSED(a, b, level, 0, most, points, NURBS_ERROR_DIMENSION, "2");
    REFUSED(a, b, c, -1, most, points, NURBS_ERROR_TOLERANCE, "tolerance");
    REFUSED(a, b, c, NAN, most, points, NURBS_ERROR_TOLERANCE, "tolerance");
    REFUSED(a, b, c, 0, -1, points, NURBS_ERROR_COUNT, "cap = -1");
    REFUSED(a, b, c, 0, 1, points, NURBS_ERROR_SIZE, "cap = 1");
    REFUSED(a, b, c, 0, most, params, NURBS_ERROR_OVERLAP, "params");
    CHECK_UNTOUCHED(params);
    CHECK_UNTOUCHED(points);
    CHECK_UNTOUCHED(ranges);
    nurbs_destroy(curve);
    nurbs_destroy(level);
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(c);
}

int main(void) {
    a_ball_and_two_planes();
    watched();
    refused();
    return check_summary("common_points");
}
