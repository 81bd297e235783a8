/* SPDX-License-Identifier: MIT */
/* Rays and surfaces: known places, strides, bad input. */
#include "shapes.h"

#include <math.h>

enum { most = 16 };

/* z = 0 over [0, 2] x [0, 1], u along x. */
static nurbs *plate(void) {
    const int32_t degrees[] = {1, 1};
    const int64_t counts[] = {2, 2};
    const double knots[] = {0, 0, 1, 1, 0, 0, 1, 1}, points[] = {0, 0, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 8, 3, points, 0, 0, NULL, 0, 0, &g));
    return g;
}

static void a_plate(void) {
    nurbs *g = plate();
    const double from[] = {0.5, 0.25, 3, 0.5, 0.25, -3, 5, 5, 3, 2, 1, 3},
                 along[] = {0, 0, -2, 0, 0, 1, 0, 0, -1, 0, 0, -1};
    double uv[8], t[4];
    int32_t status[4];
    CHECK_OK(nurbs_surface_rays(g, 4, from, 0, 0, along, 0, 0, uv, t, status));
    CHECK_INT(status[0], NURBS_RAY_HIT | NURBS_RAY_CERTIFIED);
    CHECK(uv[0] == 0.25 && uv[1] == 0.25 && t[0] == 1.5);
    CHECK_INT(status[1], NURBS_RAY_HIT | NURBS_RAY_CERTIFIED | NURBS_RAY_BACK);
    CHECK(t[1] == 3);
    CHECK_INT(status[2], NURBS_RAY_CERTIFIED);
    CHECK(isnan(uv[4]) && isnan(uv[5]) && isnan(t[2]));
    CHECK_INT(status[3], NURBS_RAY_HIT | NURBS_RAY_CERTIFIED); /* the corner */
    CHECK(uv[6] == 1 && uv[7] == 1);
    const double behind[] = {-INFINITY, 0}, near[] = {0, 1};
    int64_t count = 0;
    CHECK_OK(nurbs_surface_ray_hits(g, from, along + 3, behind, 4, uv, t, status, &count, NULL));
    CHECK(count == 1 && t[0] == -3 && status[0] == (NURBS_RAY_HIT | NURBS_RAY_BACK));
    CHECK_OK(nurbs_surface_ray_hits(g, from, along, near, 4, uv, t, status, &count, NULL));
    CHECK_INT(count, 0);
    /* in the plane of the plate: nothing can be proven */
    const double beside[] = {-1, 0.5, 0}, across[] = {1, 0, 0};
    CHECK_OK(nurbs_surface_rays(g, 1, beside, 0, 0, across, 0, 0, uv, t, status));
    CHECK((status[0] & NURBS_RAY_CERTIFIED) == 0);
    CHECK_OK(nurbs_surface_rays(g, 0, NULL, 0, 0, NULL, 0, 0, NULL, NULL, NULL));
    nurbs_destroy(g);
}

/* A sphere is met twice, at known distances; its poles and its seam are no exceptions. */
static void a_sphere(void) {
    const double centre[] = {1, 2, 3};
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_sphere(centre, NULL, NULL, 2, NURBS_ARC_QUARTERS, &g));
    const double directions[][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 1, 1}, {-1, 0.5, 0.25}};
    for (size_t i = 0; i < sizeof directions / sizeof *directions; ++i) {
        const double *d = directions[i], length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        const double from[] = {1 - 5 * d[0], 2 - 5 * d[1], 3 - 5 * d[2]};
        double uv[2 * most], t[most];
        int32_t kinds[most], complete = 0, status = 0;
        int64_t count = 0;
        CHECK_OK(nurbs_surface_ray_hits(g, from, d, NULL, most, uv, t, kinds, &count, &complete));
        CHECK(count >= 2);
        CHECK(fabs(t[0] - (5 - 2 / length)) < 1e-12 && fabs(t[count - 1] - (5 + 2 / length)) < 1e-12);
        CHECK_OK(nurbs_surface_rays(g, 1, centre, 0, 0, d, 0, 0, uv, t, &status));
        CHECK(fabs(t[0] - 2 / length) < 1e-12);
        CHECK((status & (NURBS_RAY_HIT | NURBS_RAY_TOUCH)) != 0);
    }
    nurbs_destroy(g);
}

static void strided(void) {
    nurbs *g = plate();
    const double from[] = {0.5, 1.5, 0.25, 0.75, 3, 3};
    double uv[4], t[2];
    const double both[] = {0, 0, -1, 0, 0, -1};
    CHECK_OK(nurbs_surface_rays(g, 2, from, 1, 2, both, 0, 0, uv, t, NULL));
    CHECK(uv[0] == 0.25 && uv[1] == 0.25 && uv[2] == 0.75 && uv[3] == 0.75);
    CHECK(t[0] == 3 && t[1] == 3);
    nurbs_destroy(g);
}

static void watched(void) {
    nurbs *g = plate();
    const double from[] = {0.5, 0.25, 3, 0.5, 0.25, 3}, down[] = {0, 0, -1, 0, 0, -1};
    double t[2];
    int32_t status[2];
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    CHECK_OK(nurbs_surface_rays_with(g, 2, from, 0, 0, down, 0, 0, NULL, t, status, &call));
    CHECK(t[0] == 3 && t[1] == 3 && status[1] == (NURBS_RAY_HIT | NURBS_RAY_CERTIFIED));
    call.work = 1;
    CHECK_OK(nurbs_surface_rays_with(g, 2, from, 0, 0, down, 0, 0, NULL, t, status, &call));
    CHECK(isnan(t[1]) && status[1] == 0);
    call.struct_size = 1;
    CHECK_FAILS(nurbs_surface_rays_with(g, 2, from, 0, 0, down, 0, 0, NULL, t, status, &call),
                NURBS_ERROR_OPTIONS, "struct_size");
    nurbs_destroy(g);
}

static void refused(void) {
    nurbs *g = plate(), *curve = make(arch());
    double from[] = {0.5, 0.25, 3, 1, 1, NAN}, down[] = {0, 0, -1, 0, 0, 0};
    const double turned[] = {1, 0}, unknown[] = {0, NAN};
    double uv[2 * most], t[most];
    int32_t status[most], complete = 0;
    int64_t count = 0;
    FILL(uv);
    FILL(t);
    FILL(status);
    CHECK_FAILS(nurbs_surface_rays(NULL, 1, from, 0, 0, down, 0, 0, uv, t, status), NURBS_ERROR_NULL,
                "g is NULL");
    CHECK_FAILS(nurbs_surface_rays(curve, 1, from, 0, 0, down, 0, 0, uv, t, status), NURBS_ERROR_AXES,
                "surface");
    CHECK_FAILS(nurbs_surface_rays(g, -1, from, 0, 0, down, 0, 0, uv, t, status), NURBS_ERROR_COUNT,
                "n = -1");
    CHECK_FAILS(nurbs_surface_rays(g, 1, NULL, 0, 0, down, 0, 0, uv, t, status), NURBS_ERROR_NULL, "origins");
    CHECK_FAILS(nurbs_surface_rays(g, 1, from, 0, 0, NULL, 0, 0, uv, t, status), NURBS_ERROR_NULL,
                "directions");
    CHECK_FAILS(nurbs_surface_rays(g, 2, from, 0, 0, down, 0, 0, uv, t, status), NURBS_ERROR_POINT_NOT_FINITE,
                "origins[1][2]");
    from[5] = 1;
    CHECK_FAILS(nurbs_surface_rays(g, 2, from, 0, 0, down, 0, 0, uv, t, status), NURBS_ERROR_DIRECTION,
                "directions[1]");
    CHECK_FAILS(nurbs_surface_rays(g, 1, from, -1, 0, down, 0, 0, uv, t, status), NURBS_ERROR_STRIDE,
                "origin");
    CHECK_FAILS(nurbs_surface_rays(g, 1, from, 0, 0, down, 0, 0, uv, uv + 1, status), NURBS_ERROR_OVERLAP,
                "distances|params");
    CHECK_FAILS(nurbs_surface_ray_hits(NULL, from, down, NULL, most, uv, t, status, &count, &complete),
                NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_surface_ray_hits(g, NULL, down, NULL, most, uv, t, status, &count, &complete),
                NURBS_ERROR_NULL, "origin");
    CHECK_FAILS(nurbs_surface_ray_hits(g, from, NULL, NULL, most, uv, t, status, &count, &complete),
                NURBS_ERROR_NULL, "direction");
    CHECK_FAILS(nurbs_surface_ray_hits(g, from, down + 3, NULL, most, uv, t, status, &count, &complete),
                NURBS_ERROR_DIRECTION, "direction is 0");
    CHECK_FAILS(nurbs_surface_ray_hits(g, from, down, unknown, most, uv, t, status, &count, &complete),
                NURBS_ERROR_EMPTY_DOMAIN, "range");
    CHECK_FAILS(nurbs_surface_ray_hits(g, from, down, turned, most, uv, t, status, &count, &complete),
                NURBS_ERROR_EMPTY_DOMAIN, "range");
    CHECK_FAILS(nurbs_surface_ray_hits(g, from, down, NULL, -1, uv, t, status, &count, &complete),
                NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_surface_ray_hits(g, from, down, NULL, most, uv, uv, status, &count, &complete),
                NURBS_ERROR_OVERLAP, "distances|params");
    CHECK_UNTOUCHED(uv);
    CHECK_UNTOUCHED(t);
    CHECK_UNTOUCHED(status);
    nurbs_destroy(curve);
    nurbs_destroy(g);
}

int main(void) {
    a_plate();
    a_sphere();
    strided();
    watched();
    refused();
    return check_summary("rays");
}
