/* SPDX-License-Identifier: MIT */
/* Where faces meet: neighbours in the edge that they share, others inside of both, limits of work, bad input. */
#include "faces.h"

#include <math.h>
#include <string.h>

enum { most = 8 };

static nurbs *parallelogram(const double *origin, const double *u, const double *v) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_plane(3, origin, u, v, &g));
    return g;
}

/* The whole of a plane, its sides in turn from (0, 0) on, with keys. */
static nurbs_face *bounded(const nurbs *g, const int64_t *keys) {
    static const int64_t four = 4;
    nurbs *sides[4] = {segment(0, 0, 1, 0), segment(1, 0, 1, 1), segment(1, 1, 0, 1), segment(0, 1, 0, 0)};
    const nurbs *curves[4] = {sides[0], sides[1], sides[2], sides[3]};
    nurbs_face *face = NULL;
    CHECK_OK(nurbs_face_create(g, 1, &four, curves, NULL, keys, 1e-9, 0, NULL, &face));
    for (int i = 0; i < 4; ++i) {
        nurbs_destroy(sides[i]);
    }
    return face;
}

/* The floor 0 <= x <= 2, 0 <= y <= 3, whose side x = 2 is edge 7. */
static nurbs_face *floor_face(void) {
    const int64_t keys[] = {0, 7, 0, 0};
    nurbs *g = plane();
    nurbs_face *face = bounded(g, keys);
    nurbs_destroy(g);
    return face;
}

/* From (2, 0, 0) along y, upwards by (x, 0, z), whose side below is edge 7. */
static nurbs_face *wall(double x, double z, int64_t key) {
    const double origin[] = {2, 0, 0}, along[] = {0, 3, 0}, up[] = {x, 0, z};
    const int64_t keys[] = {key, 0, 0, 0};
    nurbs *g = parallelogram(origin, along, up);
    nurbs_face *face = bounded(g, keys);
    nurbs_destroy(g);
    return face;
}

static nurbs_meet *met(nurbs_face *a, nurbs_face *b) {
    nurbs_meet *meet = NULL;
    CHECK_OK(nurbs_face_intersections(a, b, 1e-9, &meet));
    nurbs_face_destroy(a);
    nurbs_face_destroy(b);
    return meet;
}

/* Walls at any angle meet the floor in their edge alone; it is told from both sides. */
static void in_an_edge(void) {
    const double angles[][2] = {{0, 1}, {1, 1}, {-1, 1}, {-0.5, 0.1}};
    for (int i = 0; i < 4; ++i) {
        nurbs_meet *meet = met(floor_face(), wall(angles[i][0], angles[i][1], 7));
        int64_t branches = 0, nodes = 0, count = 0, ends[2] = {-1, -1};
        int32_t complete = 0, kinds[most], node_kinds[most];
        double deviation = 1, domain[2], x[3], params[2 * most], second[2 * most];
        CHECK_OK(nurbs_meet_counts(meet, &branches, &nodes, &complete));
        CHECK(branches == 1 && nodes == 2 && complete == 1);
        CHECK_OK(nurbs_meet_kinds(meet, most, kinds, &count));
        CHECK(count == 1 && kinds[0] == NURBS_BRANCH_EDGE);
        CHECK_OK(nurbs_meet_branches(meet, most, NULL, ends, NULL, &deviation, NULL));
        CHECK(deviation < 1e-12);
        CHECK_OK(nurbs_meet_nodes(meet, most, NULL, node_kinds, params, NULL, NULL));
        CHECK_OK(nurbs_meet_nodes_second(meet, most, second, NULL, NULL));
        nurbs *space = NULL, *on = NULL;
        CHECK_OK(nurbs_meet_branch(meet, 0, &space, &on));
        CHECK_OK(nurbs_domain(space, 0, domain));
        for (int k = 0; k < 2; ++k) {
            CHECK_OK(nurbs_eval(space, 1, domain + k, 0, 0, x, 0, 0, 0));
            const double *a = params + 2 * ends[k], *b = second + 2 * ends[k];
            CHECK_INT(node_kinds[ends[k]], NURBS_NODE_BORDER);
            CHECK(fabs(x[0] - 2) < 1e-12 && fabs(x[2]) < 1e-12);
            CHECK(a[0] == 1 && fabs(3 * a[1] - x[1]) < 1e-12 && b[1] == 0 && fabs(3 * b[0] - x[1]) < 1e-12);
        }
        nurbs_destroy(on);
        nurbs_destroy(space);
        nurbs_meet_destroy(meet);
    }
}

/* In one plane: contact, and nothing else. */
static void smooth(void) {
    nurbs_meet *meet = met(floor_face(), wall(1, 0, 7));
    int64_t branches = 0;
    int32_t complete = 0, kinds[most];
    CHECK_OK(nurbs_meet_counts(meet, &branches, NULL, &complete));
    CHECK(branches == 1 && complete == 1);
    CHECK_OK(nurbs_meet_kinds(meet, most, kinds, NULL));
    CHECK_INT(kinds[0], NURBS_BRANCH_CONTACT);
    nurbs_meet_destroy(meet);
}

/* On one plane: the part of the floor that is below the carpet, from (1, 1, 0) to (3, 2, 0), with a boundary of four curves. */
static void in_a_region(void) {
    const double origin[] = {1, 1, 0}, u[] = {2, 0, 0}, v[] = {0, 1, 0};
    const int64_t keys[] = {0, 0, 0, 0};
    nurbs *g = parallelogram(origin, u, v);
    nurbs_meet *meet = met(floor_face(), bounded(g, keys));
    nurbs_destroy(g);
    int64_t branches = 0, nodes = 0, levels[most], node_levels[most], loops[most], ends[2 * most], next[most];
    int32_t complete = 0, kinds[most], node_kinds[most];
    double params[2 * most], second[2 * most], ranges[4 * most], deviations[most], length = 0;
    CHECK_OK(nurbs_meet_counts(meet, &branches, &nodes, &complete));
    CHECK(branches == 4 && nodes == 5 && complete == 1);
    CHECK_OK(nurbs_meet_kinds(meet, most, kinds, NULL));
    CHECK_OK(nurbs_meet_branches(meet, most, levels, ends, loops, deviations, NULL));
    CHECK_OK(nurbs_meet_nodes(meet, most, node_levels, node_kinds, params, ranges, NULL));
    CHECK_OK(nurbs_meet_nodes_second(meet, most, second, NULL, NULL));
    CHECK_OK(nurbs_meet_joints(meet, most, next, NULL, NULL, NULL, NULL));
    for (int i = 0; i < 4; ++i) {
        double own = 0;
        nurbs *space = NULL, *on = NULL;
        CHECK(kinds[i] == NURBS_BRANCH_OVERLAP && levels[i] == 1 && loops[i] == 0 && deviations[i] < 1e-9);
        CHECK(next[ends[2 * i + 1]] == ends[2 * ((i + 1) % 4)]);
        CHECK_OK(nurbs_meet_branch(meet, i, &space, &on));
        CHECK_OK(nurbs_curve_length(space, NULL, 1e-12, &own, NULL));
        length += own;
        nurbs_destroy(on);
        nurbs_destroy(space);
    }
    CHECK(fabs(length - 4) < 1e-9);
    int regions = 0;
    for (int i = 0; i < 5; ++i) {
        CHECK(node_levels[i] == 1);
        if (node_kinds[i] == NURBS_NODE_OVERLAP) {
            ++regions;
            CHECK(fabs(ranges[4 * i] - 0.5) < 1e-9 && fabs(ranges[4 * i + 1] - 1) < 1e-9);
            CHECK(fabs(2 * params[2 * i] - 1 - 2 * second[2 * i]) < 1e-9);
            CHECK(fabs(3 * params[2 * i + 1] - 1 - second[2 * i + 1]) < 1e-9);
        } else {
            CHECK_INT(node_kinds[i], NURBS_NODE_BORDER);
        }
    }
    CHECK_INT(regions, 1);
    nurbs_meet_destroy(meet);
}

/* Edges that have one key by chance are no common one: this one begins at the edge and goes down, its key being that of its top. */
static void by_chance(void) {
    const double origin[] = {1, 0.5, -1}, u[] = {0, 2, 0}, v[] = {0, 0, 2};
    const int64_t keys[] = {7, 0, 0, 0};
    nurbs *g = parallelogram(origin, u, v);
    nurbs_meet *meet = met(floor_face(), bounded(g, keys));
    int64_t branches = 0;
    int32_t complete = 0, kinds[most];
    CHECK_OK(nurbs_meet_counts(meet, &branches, NULL, &complete));
    CHECK(branches == 1 && complete == 1);
    CHECK_OK(nurbs_meet_kinds(meet, most, kinds, NULL));
    CHECK_INT(kinds[0], NURBS_BRANCH_CROSSING);
    double length = 0;
    nurbs *space = NULL, *on = NULL;
    CHECK_OK(nurbs_meet_branch(meet, 0, &space, &on));
    CHECK_OK(nurbs_curve_length(space, NULL, 1e-9, &length, NULL));
    CHECK(fabs(length - 2) < 1e-9);
    nurbs_destroy(space);
    nurbs_destroy(on);
    nurbs_destroy(g);
    nurbs_meet_destroy(meet);
}

static int32_t stop(double done, void *user) {
    (void)done;
    ++*(int *)user;
    return 1;
}

static void watched(void) {
    nurbs_face *a = floor_face(), *b = wall(0, 1, 7), *round = NULL;
    nurbs *g = NULL; /* a ball, which takes long to be met with itself */
    CHECK_OK(nurbs_surface_sphere(NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &g));
    CHECK_OK(nurbs_face_create(g, 0, NULL, NULL, NULL, NULL, 1e-9, 0, NULL, &round));
    nurbs_destroy(g);
    nurbs_meet *meet = NULL;
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    for (call.work = 1; call.work <= 10000000; call.work *= 10) {
        const nurbs_status status = nurbs_face_intersections_with(a, b, 1e-9, &call, &meet);
        CHECK(status == NURBS_OK || status == NURBS_ERROR_WORK);
        CHECK((status == NURBS_OK) == (meet != NULL));
        nurbs_meet_destroy(meet);
        meet = NULL;
    }
    int asked = 0;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.progress = stop;
    call.user = &asked;
    CHECK_FAILS(nurbs_face_intersections_with(round, round, 1e-9, &call, &meet), NURBS_ERROR_CANCELLED, "");
    CHECK(asked == 1 && meet == NULL);
    call.struct_size = 1;
    CHECK_FAILS(nurbs_face_intersections_with(a, b, 1e-9, &call, &meet), NURBS_ERROR_OPTIONS, "struct_size");
    nurbs_face_destroy(a);
    nurbs_face_destroy(b);
    nurbs_face_destroy(round);
}

#define CHECK_NO_MEET(call, status, words)                                                                   \
    do {                                                                                                     \
        nurbs_meet *none = (nurbs_meet *)(void *)check_poison();                                             \
        CHECK_FAILS(call, status, words);                                                                    \
        CHECK(none == NULL);                                                                                 \
    } while (0)

static void refused(void) {
    nurbs_face *a = floor_face(), *b = wall(0, 1, 7);
    nurbs *g = plane(), *flat = NULL;
    const double drop[] = {1, 0, 0, 0, 1, 0};
    CHECK_OK(nurbs_transform(g, 2, drop, NULL, &flat));
    nurbs_face *in_plane = NULL;
    CHECK_OK(nurbs_face_create(flat, 0, NULL, NULL, NULL, NULL, 1e-9, 0, NULL, &in_plane));
    CHECK_NO_MEET(nurbs_face_intersections(NULL, b, 1e-6, &none), NURBS_ERROR_NULL, "a is NULL");
    CHECK_NO_MEET(nurbs_face_intersections(a, NULL, 1e-6, &none), NURBS_ERROR_NULL, "b is NULL");
    CHECK_FAILS(nurbs_face_intersections(a, b, 1e-6, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_MEET(nurbs_face_intersections(in_plane, b, 1e-6, &none), NURBS_ERROR_DIMENSION, "");
    CHECK_NO_MEET(nurbs_face_intersections(a, in_plane, 1e-6, &none), NURBS_ERROR_DIMENSION, "");
    const double bad[] = {0, -1, NAN};
    for (int i = 0; i < 3; ++i) {
        CHECK_NO_MEET(nurbs_face_intersections(a, b, bad[i], &none), NURBS_ERROR_TOLERANCE, "tolerance");
    }
    nurbs_meet *meet = NULL;
    int32_t kinds[most];
    int64_t count = -1;
    memset(kinds, 0x5a, sizeof kinds);
    CHECK_OK(nurbs_face_intersections(a, b, 1e-6, &meet));
    CHECK_FAILS(nurbs_meet_kinds(NULL, most, kinds, &count), NURBS_ERROR_NULL, "meet is NULL");
    CHECK_FAILS(nurbs_meet_kinds(meet, -1, kinds, &count), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_meet_kinds(meet, most, kinds, (int64_t *)(void *)kinds), NURBS_ERROR_OVERLAP, "kinds");
    CHECK_UNTOUCHED(kinds);
    CHECK(count == -1);
    CHECK_OK(nurbs_meet_kinds(meet, 0, NULL, &count));
    CHECK_INT(count, 1);
    nurbs_meet_destroy(meet);
    nurbs_face_destroy(in_plane);
    nurbs_face_destroy(a);
    nurbs_face_destroy(b);
    nurbs_destroy(flat);
    nurbs_destroy(g);
}

int main(void) {
    in_an_edge();
    smooth();
    in_a_region();
    by_chance();
    watched();
    refused();
    return check_summary("face_intersections");
}
