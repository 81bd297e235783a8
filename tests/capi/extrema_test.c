/* SPDX-License-Identifier: MIT */
/* Extrema of scalar splines: known ones, the query of lengths, and what is refused. */
#include "shapes.h"

static const uint32_t all = NURBS_EXTREMUM_MINIMUM | NURBS_EXTREMUM_MAXIMUM | NURBS_EXTREMUM_SADDLE |
                            NURBS_EXTREMUM_PLATEAU | NURBS_EXTREMUM_UNDECIDED;

static nurbs *bezier(int32_t axes, const int32_t *degrees, int32_t dim, const double *points) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(axes, degrees, dim, points, 0, 0, NULL, 0, &g));
    return g;
}

/* 4 t (1 - t): a maximum between two minima. */
static void a_hill(void) {
    const int32_t degree = 2;
    const double points[] = {0, 2, 0};
    nurbs *g = bezier(1, &degree, 1, points);
    double params[3], values[3], ranges[6];
    int32_t found[3], complete = -1;
    int64_t count = -1;
    CHECK_OK(nurbs_extrema(g, all, 0, NULL, NULL, NULL, NULL, &count, &complete));
    CHECK_INT(count, 3);
    CHECK_INT(complete, 1);
    CHECK_OK(nurbs_extrema(g, all, 3, params, values, found, ranges, &count, NULL));
    CHECK(params[0] == 0 && fabs(params[1] - 0.5) < 1e-15 && params[2] == 1);
    CHECK(values[0] == 0 && fabs(values[1] - 1) < 1e-15 && values[2] == 0);
    CHECK_INT(found[0], NURBS_EXTREMUM_MINIMUM);
    CHECK_INT(found[1], NURBS_EXTREMUM_MAXIMUM);
    CHECK_INT(found[2], NURBS_EXTREMUM_MINIMUM);
    CHECK(ranges[0] == 0 && ranges[1] == 0 && ranges[2] <= 0.5 && ranges[3] >= 0.5 && ranges[4] == 1);
    CHECK_OK(nurbs_extrema(g, NURBS_EXTREMUM_MAXIMUM, 1, params, NULL, NULL, NULL, &count, NULL));
    CHECK(count == 1 && fabs(params[0] - 0.5) < 1e-15);
    CHECK_OK(nurbs_extrema(g, 0, 0, NULL, NULL, NULL, NULL, &count, &complete));
    CHECK(count == 0 && complete == 1);
    nurbs_destroy(g);
}

/* (1 - 2 u) (1 - 2 v): a saddle in the middle, extrema at the corners. */
static void a_saddle(void) {
    const int32_t degrees[] = {1, 1};
    const double points[] = {1, -1, -1, 1};
    nurbs *g = bezier(2, degrees, 1, points);
    double params[10], values[5], ranges[20];
    int32_t found[5], complete = -1;
    int64_t count = -1;
    CHECK_OK(nurbs_extrema(g, all, 5, params, values, found, ranges, &count, &complete));
    CHECK_INT(count, 5);
    CHECK_INT(complete, 1);
    CHECK(found[0] == NURBS_EXTREMUM_MAXIMUM && values[0] == 1 && params[0] == 0 && params[1] == 0);
    CHECK(found[1] == NURBS_EXTREMUM_MINIMUM && values[1] == -1 && params[2] == 0 && params[3] == 1);
    CHECK(found[2] == NURBS_EXTREMUM_SADDLE && fabs(params[4] - 0.5) < 1e-15 &&
          fabs(params[5] - 0.5) < 1e-15);
    CHECK(ranges[8] <= 0.5 && ranges[9] >= 0.5 && ranges[10] <= 0.5 && ranges[11] >= 0.5);
    nurbs_destroy(g);
}

/* u over a volume: two sides of one height. */
static void a_ramp(void) {
    const int32_t degrees[] = {1, 1, 1};
    const double points[] = {0, 0, 0, 0, 1, 1, 1, 1};
    nurbs *g = bezier(3, degrees, 1, points);
    double params[6], values[2];
    int32_t found[2], complete = -1;
    int64_t count = -1;
    CHECK_OK(nurbs_extrema(g, all, 2, params, values, found, NULL, &count, &complete));
    CHECK_INT(count, 2);
    CHECK_INT(complete, 1);
    CHECK_INT(found[0], NURBS_EXTREMUM_PLATEAU | NURBS_EXTREMUM_MINIMUM);
    CHECK_INT(found[1], NURBS_EXTREMUM_PLATEAU | NURBS_EXTREMUM_MAXIMUM);
    CHECK(params[0] == 0 && params[1] == 0.5 && params[2] == 0.5 && params[3] == 1);
    nurbs_destroy(g);
}

/* (1 - 2 u)^2: the valley is degenerate. */
static void a_valley(void) {
    const int32_t degrees[] = {2, 1};
    const double points[] = {1, 1, -1, -1, 1, 1};
    nurbs *g = bezier(2, degrees, 1, points);
    int32_t complete = -1;
    int64_t count = -1;
    CHECK_OK(nurbs_extrema(g, NURBS_EXTREMUM_UNDECIDED, 0, NULL, NULL, NULL, NULL, &count, &complete));
    CHECK(count >= 1 && complete == 0);
    nurbs_destroy(g);
}

static int32_t stop(double done, void *user) {
    (void)done;
    (void)user;
    return 1;
}

static void watched(void) {
    const int32_t degrees[] = {1, 1};
    const double points[] = {1, -1, -1, 1};
    nurbs *g = bezier(2, degrees, 1, points);
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    int32_t complete = -1;
    int64_t count = -1;
    CHECK_OK(nurbs_extrema_with(g, all, 0, NULL, NULL, NULL, NULL, &count, &complete, NULL));
    CHECK(count == 5 && complete == 1);
    call.work = 1;
    CHECK_OK(nurbs_extrema_with(g, all, 0, NULL, NULL, NULL, NULL, &count, &complete, &call));
    CHECK(count >= 1 && complete == 0);
    call.work = -1;
    CHECK_FAILS(nurbs_extrema_with(g, all, 0, NULL, NULL, NULL, NULL, &count, &complete, &call),
                NURBS_ERROR_OPTIONS, "work");
    call.work = 0;
    call.progress = stop;
    const nurbs_status status =
        nurbs_extrema_with(g, all, 0, NULL, NULL, NULL, NULL, &count, &complete, &call);
    CHECK(status == NURBS_OK || status == NURBS_ERROR_CANCELLED);
    nurbs_destroy(g);
}

static void refused(void) {
    const int32_t degrees[] = {1, 1};
    const double points[] = {1, -1, -1, 1, 0, 0, 0, 0};
    nurbs *g = bezier(2, degrees, 1, points), *plane = bezier(2, degrees, 2, points);
    double a[10] = {0}, b[5], r[20];
    int32_t i[5], complete = -1;
    int64_t count = -1;
    CHECK_FAILS(nurbs_extrema(NULL, all, 5, a, b, i, r, &count, &complete), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_extrema(plane, all, 5, a, b, i, r, &count, &complete), NURBS_ERROR_DIMENSION,
                "dimension 2");
    CHECK_FAILS(nurbs_extrema(g, 0x20, 5, a, b, i, r, &count, &complete), NURBS_ERROR_FLAGS, "0x20");
    CHECK_FAILS(nurbs_extrema(g, all, -1, a, b, i, r, &count, &complete), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_extrema(g, all, 4, a, b, i, r, &count, &complete), NURBS_ERROR_SIZE, "cap = 4|5");
    CHECK_FAILS(nurbs_extrema(g, all, 5, a, a + 9, i, r, &count, &complete), NURBS_ERROR_OVERLAP,
                "values|params");
    CHECK(count == -1 && complete == -1 && a[0] == 0);
    nurbs_destroy(g);
    nurbs_destroy(plane);
}

/* Sizes at the ends of the range of doubles, which differences of control points leave. */
static void enormous(void) {
    const int32_t degree = 2;
    const double points[] = {-1.7e308, 1.7e308, -1.7e308};
    nurbs *g = bezier(1, &degree, 1, points);
    int64_t count = -1;
    const nurbs_status status = nurbs_extrema(g, all, 0, NULL, NULL, NULL, NULL, &count, NULL);
    CHECK(status == NURBS_OK || status == NURBS_ERROR_NOT_REPRESENTABLE);
    nurbs_destroy(g);
}

int main(void) {
    a_hill();
    a_saddle();
    a_ramp();
    a_valley();
    watched();
    refused();
    enormous();
    return check_summary("extrema");
}
