/* SPDX-License-Identifier: MIT */
/* Sections of surfaces: known planes, what handles of meets tell, bad input. */
#include "shapes.h"

#include <math.h>

enum { most = 8 };

/* A ruled surface over the unit square: z = u. */
static nurbs *ramp(void) {
    const int32_t degrees[] = {1, 1};
    const int64_t counts[] = {2, 2};
    const double knots[] = {0, 0, 1, 1, 0, 0, 1, 1}, points[] = {0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1, 1};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 8, 3, points, 0, 0, NULL, 0, 0, &g));
    return g;
}

static const double up[] = {0, 0, 2}, heights[] = {1, -1, 0.5};

static nurbs_meet *of_the_ramp(void) {
    nurbs *g = ramp();
    nurbs_meet *meet = NULL;
    CHECK_OK(nurbs_surface_sections(g, up, 3, heights, 1e-9, &meet));
    nurbs_destroy(g);
    return meet;
}

/* Lines at z = 1/2 and 1/4, along normal x N; the plane between them in the list meets nothing. */
static void a_ramp(void) {
    nurbs_meet *meet = of_the_ramp();
    int64_t branches = 0, nodes = 0, levels[most], ends[2 * most], loops[most], count = 0;
    int32_t complete = 0, kinds[most];
    double deviations[most], params[2 * most], ranges[4 * most];
    CHECK_OK(nurbs_meet_counts(meet, &branches, &nodes, &complete));
    CHECK(branches == 2 && nodes == 4 && complete == 1);
    CHECK_OK(nurbs_meet_branches(meet, most, levels, ends, loops, deviations, &count));
    CHECK(count == 2 && levels[0] == 0 && levels[1] == 2 && loops[0] == -1);
    CHECK(deviations[0] > 0 && deviations[0] < 1e-12);
    CHECK_OK(nurbs_meet_nodes(meet, most, levels, kinds, params, ranges, &count));
    CHECK(count == 4 && levels[0] == 0 && levels[3] == 2);
    for (int i = 0; i < 4; ++i) {
        CHECK_INT(kinds[i], NURBS_NODE_BORDER);
        CHECK(ranges[4 * i] == params[2 * i] && ranges[4 * i + 1] == params[2 * i]);
        CHECK(ranges[4 * i + 2] == params[2 * i + 1] && ranges[4 * i + 3] == params[2 * i + 1]);
    }
    nurbs *space = NULL, *on = NULL;
    CHECK_OK(nurbs_meet_branch(meet, 0, &space, &on));
    double domain[2], x[3], uv[2];
    CHECK_OK(nurbs_domain(space, 0, domain));
    CHECK_OK(nurbs_eval(space, 1, domain, 0, 0, x, 0, 0, 0));
    CHECK_OK(nurbs_eval(on, 1, domain, 0, 0, uv, 0, 0, 0));
    const double *from = params + 2 * ends[0], *to = params + 2 * ends[1];
    CHECK(uv[0] == from[0] && uv[1] == from[1]);
    CHECK(fabs(x[0] - 0.5) < 1e-12 && fabs(x[2] - 0.5) < 1e-12 && fabs(domain[1] - domain[0] - 1) < 1e-12);
    CHECK(from[1] == 1 && to[1] == 0); /* z > 1/2, at larger u, is on the left */
    nurbs_destroy(on);
    nurbs_destroy(space);
    nurbs_meet_destroy(meet);
}

static void counted(void) {
    nurbs_meet *meet = of_the_ramp(), *copy = NULL;
    CHECK_OK(nurbs_meet_clone(meet, &copy));
    nurbs_meet_destroy(meet);
    int64_t count = 0;
    CHECK_OK(nurbs_meet_branches(copy, 0, NULL, NULL, NULL, NULL, &count));
    CHECK_INT(count, 2);
    CHECK_OK(nurbs_meet_nodes(copy, 0, NULL, NULL, NULL, NULL, &count));
    CHECK_INT(count, 4);
    CHECK_OK(nurbs_meet_branches(copy, 2, NULL, NULL, NULL, NULL, NULL));
    CHECK_OK(nurbs_meet_counts(copy, NULL, NULL, NULL));
    nurbs_meet_destroy(copy);
    nurbs_meet_destroy(NULL);
}

static void no_planes(void) {
    nurbs *g = ramp();
    nurbs_meet *meet = NULL;
    CHECK_OK(nurbs_surface_sections(g, up, 0, NULL, 1e-9, &meet));
    int64_t branches = -1;
    int32_t complete = 0;
    CHECK_OK(nurbs_meet_counts(meet, &branches, NULL, &complete));
    CHECK(branches == 0 && complete == 1);
    nurbs_meet_destroy(meet);
    nurbs_destroy(g);
}

static int32_t stop(double done, void *user) {
    (void)done;
    ++*(int *)user;
    return 1;
}

/* A limit of work leaves open what was not looked at; progress ends the call. */
static void watched(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_torus(NULL, NULL, NULL, 3, 1, 0, 6.283185307179586, 0, 6.283185307179586,
                                 NURBS_ARC_QUARTERS, &g));
    nurbs_meet *meet = NULL;
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    CHECK_OK(nurbs_surface_sections_with(g, up, 3, heights, 1e-9, &call, &meet));
    int32_t complete = 0;
    CHECK_OK(nurbs_meet_counts(meet, NULL, NULL, &complete));
    CHECK_INT(complete, 1);
    nurbs_meet_destroy(meet);
    CHECK_OK(nurbs_surface_sections_with(g, up, 3, heights, 1e-9, NULL, &meet));
    nurbs_meet_destroy(meet);
    for (call.work = 1; call.work <= 100; call.work *= 10) {
        CHECK_OK(nurbs_surface_sections_with(g, up, 3, heights, 1e-9, &call, &meet));
        CHECK_OK(nurbs_meet_counts(meet, NULL, NULL, &complete));
        CHECK_INT(complete, 0);
        nurbs_meet_destroy(meet);
    }
    double many[2000];
    for (int i = 0; i < 2000; ++i) {
        many[i] = 0.001 * (i - 1000);
    }
    int asked = 0;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.progress = stop;
    call.user = &asked;
    CHECK_FAILS(nurbs_surface_sections_with(g, up, 2000, many, 1e-9, &call, &meet), NURBS_ERROR_CANCELLED,
                "");
    CHECK(asked == 1 && meet == NULL);
    call.struct_size = 1;
    CHECK_FAILS(nurbs_surface_sections_with(g, up, 3, heights, 1e-9, &call, &meet), NURBS_ERROR_OPTIONS,
                "struct_size");
    nurbs_destroy(g);
}

#define REFUSED(g, normal, n, offsets, tolerance, status, text)                                              \
    do {                                                                                                     \
        nurbs_meet *none = (nurbs_meet *)(void *)check_poison();                                             \
        CHECK_FAILS(nurbs_surface_sections(g, normal, n, offsets, tolerance, &none), status, text);          \
        CHECK(none == NULL);                                                                                 \
    } while (0)

static void refused(void) {
    nurbs *g = ramp(), *curve = make(arch());
    const double no_direction[] = {0, 0, 0}, unknown[] = {0, NAN, 1}, bad[] = {1, INFINITY};
    REFUSED(NULL, up, 1, heights, 1e-3, NURBS_ERROR_NULL, "g is NULL");
    REFUSED(curve, up, 1, heights, 1e-3, NURBS_ERROR_AXES, "surface");
    REFUSED(g, NULL, 1, heights, 1e-3, NURBS_ERROR_NULL, "normal");
    REFUSED(g, no_direction, 1, heights, 1e-3, NURBS_ERROR_DIRECTION, "normal is 0");
    REFUSED(g, unknown, 1, heights, 1e-3, NURBS_ERROR_DIRECTION, "normal[1]");
    REFUSED(g, up, -1, heights, 1e-3, NURBS_ERROR_COUNT, "n = -1");
    REFUSED(g, up, INT64_MAX, heights, 1e-3, NURBS_ERROR_OVERFLOW, "offsets");
    REFUSED(g, up, 1, NULL, 1e-3, NURBS_ERROR_NULL, "offsets");
    REFUSED(g, up, 2, bad, 1e-3, NURBS_ERROR_POINT_NOT_FINITE, "offsets[1]");
    REFUSED(g, up, 1, heights, 0, NURBS_ERROR_TOLERANCE, "tolerance");
    REFUSED(g, up, 1, heights, -1, NURBS_ERROR_TOLERANCE, "tolerance");
    REFUSED(g, up, 1, heights, NAN, NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_surface_sections(g, up, 1, heights, 1e-3, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(curve);
    nurbs_destroy(g);
}

static void a_surface_of_the_plane(void) {
    const int32_t degrees[] = {1, 1};
    const int64_t counts[] = {2, 2};
    const double knots[] = {0, 0, 1, 1, 0, 0, 1, 1}, points[] = {0, 0, 0, 1, 1, 0, 1, 1};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 8, 2, points, 0, 0, NULL, 0, 0, &g));
    REFUSED(g, up, 1, heights, 1e-3, NURBS_ERROR_DIMENSION, "3");
    nurbs_destroy(g);
}

static void refused_by_meets(void) {
    nurbs_meet *meet = of_the_ramp(), *out = NULL;
    int64_t levels[most], ends[2 * most], loops[most], count = 0;
    int32_t kinds[most];
    double values[4 * most], params[2 * most];
    FILL(levels);
    FILL(ends);
    FILL(values);
    FILL(kinds);
    CHECK_FAILS(nurbs_meet_clone(NULL, &out), NURBS_ERROR_NULL, "meet is NULL");
    CHECK_FAILS(nurbs_meet_clone(meet, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_meet_counts(NULL, &count, NULL, NULL), NURBS_ERROR_NULL, "meet is NULL");
    CHECK_FAILS(nurbs_meet_counts(meet, &count, &count, NULL), NURBS_ERROR_OVERLAP, "nodes|branches");
    CHECK_FAILS(nurbs_meet_branches(NULL, most, levels, ends, loops, values, &count), NURBS_ERROR_NULL,
                "meet");
    CHECK_FAILS(nurbs_meet_branches(meet, -1, levels, ends, loops, values, &count), NURBS_ERROR_COUNT,
                "cap = -1");
    CHECK_FAILS(nurbs_meet_branches(meet, 1, levels, ends, loops, values, &count), NURBS_ERROR_SIZE,
                "cap = 1");
    CHECK_FAILS(nurbs_meet_branches(meet, most, levels, levels, loops, values, &count), NURBS_ERROR_OVERLAP,
                "end_nodes|levels");
    CHECK_FAILS(nurbs_meet_nodes(NULL, most, levels, kinds, params, values, &count), NURBS_ERROR_NULL,
                "meet");
    CHECK_FAILS(nurbs_meet_nodes(meet, -1, levels, kinds, params, values, &count), NURBS_ERROR_COUNT,
                "cap = -1");
    CHECK_FAILS(nurbs_meet_nodes(meet, 3, levels, kinds, params, values, &count), NURBS_ERROR_SIZE,
                "cap = 3");
    CHECK_FAILS(nurbs_meet_nodes(meet, most, levels, kinds, values, values, &count), NURBS_ERROR_OVERLAP,
                "ranges|params");
    CHECK_UNTOUCHED(levels);
    CHECK_UNTOUCHED(ends);
    CHECK_UNTOUCHED(values);
    CHECK_UNTOUCHED(kinds);
    for (int64_t index = -1; index <= 2; index += 3) {
        nurbs *space = check_poison(), *on = check_poison();
        CHECK_FAILS(nurbs_meet_branch(meet, index, &space, &on), NURBS_ERROR_INDEX, "index");
        CHECK(space == NULL && on == NULL);
    }
    nurbs *both = check_poison(), *other = check_poison();
    CHECK_FAILS(nurbs_meet_branch(NULL, 0, &both, &other), NURBS_ERROR_NULL, "meet");
    CHECK(both == NULL && other == NULL);
    CHECK_FAILS(nurbs_meet_branch(meet, 0, &both, NULL), NURBS_ERROR_NULL, "on_surface");
    CHECK_FAILS(nurbs_meet_branch(meet, 0, NULL, &other), NURBS_ERROR_NULL, "space");
    CHECK_FAILS(nurbs_meet_branch(meet, 0, &both, &both), NURBS_ERROR_OVERLAP, "on_surface|space");
    CHECK(both == NULL);
    nurbs_meet_destroy(meet);
}

int main(void) {
    a_ramp();
    counted();
    no_planes();
    watched();
    refused();
    a_surface_of_the_plane();
    refused_by_meets();
    return check_summary("sections");
}
