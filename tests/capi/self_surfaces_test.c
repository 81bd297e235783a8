/* SPDX-License-Identifier: MIT */
/* Where a surface meets itself: known shapes, both curves in its domain, limits of work, bad input. */
#include "shapes.h"

#include <math.h>

enum { most = 8 };

static const double turn = 6.283185307179586;

/* (t^2, t^3 - t, v), -1.5 <= t <= 1.5 and 0 <= v <= 1: it meets itself for t = 1 and t = -1 along (1, 0, v). */
static nurbs *noose(void) {
    const int32_t degrees[] = {3, 1};
    const int64_t counts[] = {4, 2};
    const double a = 1.5, knots[] = {-a, -a, -a, -a, a, a, a, a, 0, 0, 1, 1},
                 x[] = {a * a, -a * a, -a * a, a * a}, far = a * a * a,
                 y[] = {a - far, a / 3 + far, -a / 3 - far, far - a};
    double points[24];
    nurbs *g = NULL;
    for (int i = 0; i < 8; ++i) {
        points[3 * i] = x[i / 2] / (i / 2 == 1 || i / 2 == 2 ? 3 : 1);
        points[3 * i + 1] = y[i / 2];
        points[3 * i + 2] = i % 2;
    }
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 12, 3, points, 0, 0, NULL, 0, 0, &g));
    return g;
}

static nurbs *tube(void) {
    const double center[] = {0, 0, 0}, axis[] = {0, 0, 1};
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_cylinder(center, axis, NULL, 1, 3, 0, turn, NURBS_ARC_QUARTERS, &g));
    return g;
}

/* One branch from border to border, with t = 1 and t = -1 in either order all along. */
static void a_noose(void) {
    nurbs *g = noose(), *space = NULL, *on = NULL, *on_second = NULL;
    nurbs_meet *meet = NULL;
    CHECK_OK(nurbs_surface_self_intersections(g, 1e-9, &meet));
    int64_t branches = 0, nodes = 0;
    int32_t complete = 0, kinds[most];
    double deviation = 1;
    CHECK_OK(nurbs_meet_counts(meet, &branches, &nodes, &complete));
    CHECK(branches == 1 && nodes == 2 && complete == 1);
    CHECK_OK(nurbs_meet_branches(meet, 1, NULL, NULL, NULL, &deviation, NULL));
    CHECK(deviation > 0 && deviation <= 1e-9);
    CHECK_OK(nurbs_meet_nodes(meet, most, NULL, kinds, NULL, NULL, NULL));
    CHECK(kinds[0] == NURBS_NODE_BORDER && kinds[1] == NURBS_NODE_BORDER);
    CHECK_OK(nurbs_meet_kinds(meet, most, kinds, NULL));
    CHECK_INT(kinds[0], NURBS_BRANCH_CROSSING);
    CHECK_OK(nurbs_meet_branch(meet, 0, &space, &on));
    CHECK_OK(nurbs_meet_branch_second(meet, 0, &on_second));
    double domain[2];
    CHECK_OK(nurbs_domain(space, 0, domain));
    for (int i = 0; i <= 10; ++i) {
        const double t = i == 10 ? domain[1] : domain[0] + i * (domain[1] - domain[0]) / 10;
        double x[3], uv[2], st[2];
        CHECK_OK(nurbs_eval(space, 1, &t, 0, 0, x, 0, 0, 0));
        CHECK_OK(nurbs_eval(on, 1, &t, 0, 0, uv, 0, 0, 0));
        CHECK_OK(nurbs_eval(on_second, 1, &t, 0, 0, st, 0, 0, 0));
        CHECK(fabs(x[0] - 1) < 1e-9 && fabs(x[1]) < 1e-9 && x[2] >= 0 && x[2] <= 1);
        CHECK(fabs(fabs(uv[0]) - 1) < 1e-9 && fabs(uv[0] + st[0]) < 1e-9 && fabs(uv[1] - x[2]) < 1e-9);
    }
    nurbs_destroy(space);
    nurbs_destroy(on);
    nurbs_destroy(on_second);
    nurbs_meet_destroy(meet);
    nurbs_destroy(g);
}

/* What closes is simple. */
static void a_tube(void) {
    nurbs *g = tube();
    nurbs_meet *meet = NULL;
    int64_t branches = -1, nodes = -1;
    int32_t complete = -1;
    CHECK_OK(nurbs_surface_self_intersections_with(g, 1e-9, NULL, &meet));
    CHECK_OK(nurbs_meet_counts(meet, &branches, &nodes, &complete));
    CHECK(branches == 0 && nodes == 0 && complete == 1);
    nurbs_meet_destroy(meet);
    nurbs_destroy(g);
}

/* What of the branch lies in the lower half of the surface, as a face. */
static void in_a_face(void) {
    const int32_t degree = 1;
    const int64_t count = 5, one = 1;
    const double knots[] = {0, 0, 1, 2, 3, 4, 4}, points[] = {-1.5, 0, 1.5, 0, 1.5, 0.5, -1.5, 0.5, -1.5, 0};
    nurbs *g = noose(), *around = NULL, *space = NULL, *on = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 7, 2, points, 0, 0, NULL, 0, 0, &around));
    const nurbs *curves[] = {around};
    nurbs_face *face = NULL;
    CHECK_OK(nurbs_face_create(g, 1, &one, curves, NULL, NULL, 1e-9, 0, NULL, &face));
    nurbs_meet *meet = NULL, *first = NULL, *both = NULL;
    CHECK_OK(nurbs_surface_self_intersections(g, 1e-9, &meet));
    CHECK_OK(nurbs_meet_trim(meet, face, &first));
    CHECK_OK(nurbs_meet_trim_second(first, face, &both));
    int64_t branches = 0;
    double length = 0;
    CHECK_OK(nurbs_meet_counts(both, &branches, NULL, NULL));
    CHECK_INT(branches, 1);
    CHECK_OK(nurbs_meet_branch(both, 0, &space, &on));
    CHECK_OK(nurbs_curve_length(space, NULL, 1e-10, &length, NULL));
    CHECK(fabs(length - 0.5) < 1e-8);
    nurbs_destroy(space);
    nurbs_destroy(on);
    nurbs_meet_destroy(both);
    nurbs_meet_destroy(first);
    nurbs_meet_destroy(meet);
    nurbs_face_destroy(face);
    nurbs_destroy(around);
    nurbs_destroy(g);
}

static int32_t stop(double done, void *user) {
    (void)done;
    ++*(int *)user;
    return 1;
}

/* A limit of work leaves open what was not looked at; progress ends the call. */
static void watched(void) {
    nurbs *g = noose();
    nurbs_meet *meet = NULL;
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    int32_t complete = -1;
    int64_t branches = -1;
    for (call.work = 1; call.work <= 1000; call.work *= 10) {
        CHECK_OK(nurbs_surface_self_intersections_with(g, 1e-9, &call, &meet));
        CHECK_OK(nurbs_meet_counts(meet, &branches, NULL, &complete));
        CHECK(branches == 0 && complete == 0);
        nurbs_meet_destroy(meet);
    }
    int asked = 0;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.progress = stop;
    call.user = &asked;
    nurbs_destroy(g);
    const double none[] = {0, 0, 0}, axis[] = {0, 0, 1};
    CHECK_OK(nurbs_surface_torus(none, axis, NULL, 0.5, 1, 0, turn, 0, turn, NURBS_ARC_QUARTERS, &g));
    CHECK_FAILS(nurbs_surface_self_intersections_with(g, 1e-9, &call, &meet), NURBS_ERROR_CANCELLED, "");
    CHECK(asked == 1 && meet == NULL);
    call.struct_size = 1;
    CHECK_FAILS(nurbs_surface_self_intersections_with(g, 1e-9, &call, &meet), NURBS_ERROR_OPTIONS,
                "struct_size");
    nurbs_destroy(g);
}

#define CHECK_NO_MEET(call, status, words)                                                                   \
    do {                                                                                                     \
        nurbs_meet *none = (nurbs_meet *)(void *)check_poison();                                             \
        CHECK_FAILS(call, status, words);                                                                    \
        CHECK(none == NULL);                                                                                 \
    } while (0)

static void refused(void) {
    nurbs *g = noose(), *curve = NULL, *plane = NULL;
    CHECK_OK(nurbs_iso(g, 0, 0.5, 0, &curve));
    const double drop[] = {1, 0, 0, 0, 1, 0};
    CHECK_OK(nurbs_transform(g, 2, drop, NULL, &plane));
    CHECK_NO_MEET(nurbs_surface_self_intersections(NULL, 1e-6, &none), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_surface_self_intersections(g, 1e-6, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_MEET(nurbs_surface_self_intersections(curve, 1e-6, &none), NURBS_ERROR_AXES, "g");
    CHECK_NO_MEET(nurbs_surface_self_intersections(plane, 1e-6, &none), NURBS_ERROR_DIMENSION, "");
    const double bad[] = {0, -1, NAN};
    for (int i = 0; i < 3; ++i) {
        CHECK_NO_MEET(nurbs_surface_self_intersections(g, bad[i], &none), NURBS_ERROR_TOLERANCE, "tolerance");
    }
    nurbs_destroy(plane);
    nurbs_destroy(curve);
    nurbs_destroy(g);
}

int main(void) {
    a_noose();
    a_tube();
    in_a_face();
    watched();
    refused();
    return check_summary("self_surfaces");
}
