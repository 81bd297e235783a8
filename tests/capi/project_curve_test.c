/* SPDX-License-Identifier: MIT */
/* Curves projected onto surfaces and faces along a direction, and normally: known shapes, folds, limits of work, bad input. */
#include "faces.h"

#include <math.h>
#include <string.h>

enum { most = 16 };

static const double down[] = {0, 0, -2}; /* of any length */

/* From (x0, y, z) to (x1, y, z), by the x of points as its parameter. */
static nurbs *line_along_x(double x0, double x1, double y, double z) {
    const int32_t degree = 1;
    const int64_t count = 2;
    const double knots[] = {x0, x0, x1, x1}, points[] = {x0, y, z, x1, y, z};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 4, 3, points, 0, 0, NULL, 0, 0, &g));
    return g;
}

static nurbs *ball(void) {
    nurbs *g = NULL;
    const double center[] = {0, 0, 0}, axis[] = {0, 1, 0}; /* poles beside the lines */
    CHECK_OK(nurbs_surface_sphere(center, axis, NULL, 1, NURBS_ARC_QUARTERS, &g));
    return g;
}

typedef struct Found {
    int64_t branches, nodes, ends[2 * most], next[most];
    int32_t complete, kinds[most];
    double deviations[most], second[2 * most], t[2 * most],
        h[2 * most]; /* t and h: where branches begin and end */
} Found;

static int64_t count_of(const Found *f, int32_t kind) {
    int64_t n = 0;
    for (int64_t i = 0; i < f->nodes; ++i) {
        n += f->kinds[i] == kind ? 1 : 0;
    }
    return n;
}

/* Looks at a meet, and frees it. */
static Found found_in(nurbs_meet *meet) {
    Found f;
    memset(&f, 0, sizeof f);
    CHECK_OK(nurbs_meet_counts(meet, &f.branches, &f.nodes, &f.complete));
    CHECK_OK(nurbs_meet_branches(meet, most, NULL, f.ends, NULL, f.deviations, NULL));
    CHECK_OK(nurbs_meet_nodes(meet, most, NULL, f.kinds, NULL, NULL, NULL));
    CHECK_OK(nurbs_meet_nodes_second(meet, most, f.second, NULL, NULL));
    CHECK_OK(nurbs_meet_joints(meet, most, f.next, NULL, NULL, NULL, NULL));
    for (int64_t i = 0; i < f.branches; ++i) {
        nurbs *lines = NULL;
        double domain[2], x[4];
        CHECK_OK(nurbs_meet_branch_second(meet, i, &lines));
        CHECK_OK(nurbs_domain(lines, 0, domain));
        CHECK_OK(nurbs_eval(lines, 2, domain, 0, 0, x, 0, 0, 0));
        f.t[2 * i] = x[0];
        f.t[2 * i + 1] = x[2];
        f.h[2 * i] = x[1];
        f.h[2 * i + 1] = x[3];
        CHECK(x[0] < x[2] && f.deviations[i] < 1e-6);
        nurbs_destroy(lines);
    }
    nurbs_meet_destroy(meet);
    return f;
}

static Found projected(nurbs *g, nurbs *curve, const double *direction, double tolerance) {
    nurbs_meet *meet = NULL;
    CHECK_OK(nurbs_surface_project_curve(g, curve, direction, tolerance, &meet));
    nurbs_destroy(g);
    nurbs_destroy(curve);
    return found_in(meet);
}

/* A line above a plane of 2 by 3 that it leaves at both ends. */
static void onto_a_plane(void) {
    const Found f = projected(plane(), line_along_x(-1, 5, 1, 4), down, 1e-9);
    CHECK(f.branches == 1 && f.nodes == 2 && f.complete == 1);
    CHECK_INT(count_of(&f, NURBS_NODE_BORDER), 2);
    CHECK_NEAR(f.t, VALUES(0, 2), 2, 1e-9);
    CHECK_NEAR(f.h, VALUES(4, 4), 2, 1e-9);
    const Found slanted = projected(plane(), line_along_x(-1, 5, 1, 4), VALUES(3, 0, 4), 1e-9);
    CHECK_INT(slanted.branches, 1); /* against the direction */
    CHECK_NEAR(slanted.t, VALUES(3, 5), 2, 1e-9);
    CHECK_NEAR(slanted.h, VALUES(-5, -5), 2, 1e-9);
}

/* Lines above the ball: the upper and the lower half, between folds. */
static void over_a_fold(void) {
    const double y = 0.28, half = 0.96; /* of the circle that the lines meet */
    const Found f = projected(ball(), line_along_x(-2, 2, y, 3), down, 1e-9);
    CHECK_INT(f.complete, 1);
    CHECK_INT(count_of(&f, NURBS_NODE_FOLD), 4);
    CHECK_INT(count_of(&f, NURBS_NODE_BORDER), 0);
    int64_t begun = 0, ended = 0;
    for (int64_t i = 0; i < f.nodes; ++i) {
        if (f.kinds[i] == NURBS_NODE_FOLD) {
            CHECK(fabs(fabs(f.second[2 * i]) - half) < 1e-7 && fabs(f.second[2 * i + 1] - 3) < 1e-3);
            CHECK(f.next[i] >= 0 && f.kinds[f.next[i]] == NURBS_NODE_FOLD && f.next[f.next[i]] == i);
        }
    }
    for (int64_t i = 0; i < f.branches; ++i) {
        begun += f.kinds[f.ends[2 * i]] == NURBS_NODE_FOLD && f.t[2 * i] < 0 ? 1 : 0;
        ended += f.kinds[f.ends[2 * i + 1]] == NURBS_NODE_FOLD && f.t[2 * i + 1] > 0 ? 1 : 0;
    }
    CHECK(begun == 2 && ended == 2);
    /* A line that begins above the middle: both halves of the right half, one fold. */
    const Found part = projected(ball(), line_along_x(0.5, 2, y, 3), down, 1e-9);
    CHECK(part.complete == 1 && count_of(&part, NURBS_NODE_FOLD) == 2);
    CHECK_INT(count_of(&part, NURBS_NODE_BORDER), 2);
}

/* A circle above the ball is two closed curves, of which each has all of its parameters. */
static void closed(void) {
    nurbs *circle = NULL;
    const double center[] = {0.1, 0.2, 5};
    CHECK_OK(nurbs_curve_circle(3, center, VALUES(0, 0, 1), NULL, 0.5, NURBS_ARC_QUARTERS, &circle));
    const Found f = projected(ball(), circle, VALUES(0, 0, 1), 1e-7);
    CHECK_INT(f.complete, 1);
    CHECK_INT(count_of(&f, NURBS_NODE_SEAM), f.nodes);
    double length = 0;
    for (int64_t i = 0; i < f.branches; ++i) {
        length += f.t[2 * i + 1] - f.t[2 * i];
        CHECK(f.h[2 * i] < -4);
    }
    CHECK(fabs(length - 2) < 1e-9);
}

/* Nothing below, and what lines touch all along. */
static void beside_and_along(void) {
    const Found beside = projected(ball(), line_along_x(-2, 2, 1.5, 3), down, 1e-7);
    CHECK(beside.branches == 0 && beside.nodes == 0 && beside.complete == 1);
    const Found along = projected(ball(), line_along_x(-2, 2, 0.28, 3), VALUES(1, 0, 0), 1e-7);
    CHECK(along.branches == 0 && along.complete == 1); /* a line along itself, above the ball */
    const Found in_plane = projected(plane(), line_along_x(-1, 5, 1, 0), VALUES(0, 1, 0), 1e-7);
    CHECK(in_plane.complete == 0 && in_plane.nodes >= 1); /* lines in the plane */
}

/* The face has a hole: 0.25 to 0.5 of both parameters, and ends at 0.125 and 0.875. */
static void onto_a_face(void) {
    nurbs_face *face = frame_face();
    nurbs *curve = line_along_x(-1, 5, 1, 4);
    nurbs_meet *meet = NULL;
    CHECK_OK(nurbs_face_project_curve(face, curve, down, 1e-9, &meet));
    const Found f = found_in(meet);
    CHECK(f.branches == 2 && f.nodes == 4 && f.complete == 1);
    CHECK_INT(count_of(&f, NURBS_NODE_BORDER), 4);
    CHECK_NEAR(f.t, VALUES(0.25, 0.5, 1, 1.75), 4, 1e-9);
    for (int i = 0; i < 4; ++i) {
        CHECK(fabs(f.second[2 * f.ends[i]] - f.t[i]) < 1e-12 &&
              fabs(f.second[2 * f.ends[i] + 1] - 4) < 1e-12);
    }
    nurbs_destroy(curve);
    nurbs_face_destroy(face);
}

static int32_t stop(double done, void *user) {
    (void)done;
    ++*(int *)user;
    return 1;
}

static void watched(void) {
    nurbs *g = ball(), *curve = line_along_x(-2, 2, 0.28, 3), *around = NULL;
    CHECK_OK(nurbs_curve_circle(3, VALUES(0, 0, 3), VALUES(0, 0, 1), NULL, 1, NURBS_ARC_QUARTERS, &around));
    nurbs_face *face = frame_face();
    nurbs_meet *meet = NULL;
    nurbs_call_options call;
    int32_t complete = -1;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.work = 1;
    CHECK_OK(nurbs_surface_project_curve_with(g, curve, down, 1e-9, &call, &meet));
    CHECK_OK(nurbs_meet_counts(meet, NULL, NULL, &complete));
    CHECK_INT(complete, 0);
    nurbs_meet_destroy(meet);
    CHECK_OK(nurbs_face_project_curve_with(face, curve, down, 1e-9, &call, &meet));
    CHECK_OK(nurbs_meet_counts(meet, NULL, NULL, &complete));
    CHECK_INT(complete, 0);
    nurbs_meet_destroy(meet);
    int asked = 0;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.progress = stop;
    call.user = &asked;
    CHECK_FAILS(nurbs_surface_project_curve_with(g, around, down, 1e-12, &call, &meet), NURBS_ERROR_CANCELLED,
                "");
    CHECK(asked == 1 && meet == NULL);
    call.struct_size = 1;
    CHECK_FAILS(nurbs_surface_project_curve_with(g, curve, down, 1e-9, &call, &meet), NURBS_ERROR_OPTIONS,
                "struct_size");
    CHECK_FAILS(nurbs_face_project_curve_with(face, curve, down, 1e-9, &call, &meet), NURBS_ERROR_OPTIONS,
                "struct_size");
    nurbs_face_destroy(face);
    nurbs_destroy(around);
    nurbs_destroy(curve);
    nurbs_destroy(g);
}

/* Feet: one on a plane, two on a ball, none of their own kind beside a hole; limits of work. */
static void normally(void) {
    const Found f = projected(plane(), line_along_x(-1, 5, 1, 4), NULL, 1e-9);
    CHECK(f.branches == 1 && f.nodes == 2 && f.complete == 1);
    CHECK_INT(count_of(&f, NURBS_NODE_BORDER), 2);
    CHECK_NEAR(f.t, VALUES(0, 2), 2, 1e-9);
    CHECK(fabs(fabs(f.h[0]) - 4) < 1e-9 && fabs(f.h[0] - f.h[1]) < 1e-9);
    const Found both = projected(ball(), line_along_x(-2, 2, 0.28, 3), NULL, 1e-9);
    CHECK_INT(both.complete, 1);
    double length = 0;
    for (int64_t i = 0; i < both.branches; ++i) {
        const double x = both.t[2 * i], far = sqrt(x * x + 0.28 * 0.28 + 9), h = fabs(both.h[2 * i]);
        CHECK(fabs(h - far - 1) < 1e-8 || fabs(h - far + 1) < 1e-8);
        length += both.t[2 * i + 1] - both.t[2 * i];
    }
    CHECK(fabs(length - 8) < 1e-8);
    nurbs_face *face = frame_face();
    nurbs *curve = line_along_x(-1, 5, 1, 4), *g = ball();
    nurbs_meet *meet = NULL;
    CHECK_OK(nurbs_face_project_curve(face, curve, NULL, 1e-9, &meet));
    const Found inside = found_in(meet);
    CHECK(inside.branches == 2 && inside.nodes == 4 && inside.complete == 1);
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.work = 10;
    int32_t complete = -1;
    CHECK_OK(nurbs_surface_project_curve_with(g, curve, NULL, 1e-9, &call, &meet));
    CHECK_OK(nurbs_meet_counts(meet, NULL, NULL, &complete));
    CHECK_INT(complete, 0);
    nurbs_meet_destroy(meet);
    CHECK_OK(nurbs_face_project_curve_with(face, curve, NULL, 1e-9, NULL, &meet));
    nurbs_meet_destroy(meet);
    nurbs_destroy(g);
    nurbs_destroy(curve);
    nurbs_face_destroy(face);
}

#define CHECK_NO_MEET(call, status, words)                                                                   \
    do {                                                                                                     \
        nurbs_meet *none = (nurbs_meet *)(void *)check_poison();                                             \
        CHECK_FAILS(call, status, words);                                                                    \
        CHECK(none == NULL);                                                                                 \
    } while (0)

static void refused(void) {
    nurbs *g = ball(), *curve = line_along_x(-2, 2, 0.28, 3), *flat = segment(0, 0, 1, 1), *level = NULL;
    nurbs_face *face = frame_face();
    const double drop[] = {1, 0, 0, 0, 1, 0};
    CHECK_OK(nurbs_transform(g, 2, drop, NULL, &level));
    nurbs_face *level_face = face_of(level, 0, NULL);
    CHECK_NO_MEET(nurbs_surface_project_curve(NULL, curve, down, 1e-6, &none), NURBS_ERROR_NULL, "g");
    CHECK_NO_MEET(nurbs_surface_project_curve(g, NULL, down, 1e-6, &none), NURBS_ERROR_NULL, "curve");
    CHECK_FAILS(nurbs_surface_project_curve(g, curve, down, 1e-6, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_MEET(nurbs_surface_project_curve(curve, curve, down, 1e-6, &none), NURBS_ERROR_AXES, "g");
    CHECK_NO_MEET(nurbs_surface_project_curve(g, g, down, 1e-6, &none), NURBS_ERROR_AXES, "curve");
    CHECK_NO_MEET(nurbs_surface_project_curve(level, curve, down, 1e-6, &none), NURBS_ERROR_DIMENSION, "2");
    CHECK_NO_MEET(nurbs_surface_project_curve(g, flat, down, 1e-6, &none), NURBS_ERROR_DIMENSION, "2");
    nurbs *steep = NULL;
    CHECK_OK(nurbs_elevate(g, 0, 19, &steep)); /* rational, of degree 21 */
    CHECK_NO_MEET(nurbs_surface_project_curve(steep, curve, NULL, 1e-6, &none), NURBS_ERROR_DEGREE, "21");
    nurbs_destroy(steep);
    CHECK_NO_MEET(nurbs_surface_project_curve(g, curve, VALUES(0, 0, 0), 1e-6, &none), NURBS_ERROR_DIRECTION,
                  "direction");
    CHECK_NO_MEET(nurbs_surface_project_curve(g, curve, VALUES(0, NAN, 1), 1e-6, &none),
                  NURBS_ERROR_DIRECTION, "direction");
    CHECK_NO_MEET(nurbs_face_project_curve(NULL, curve, down, 1e-6, &none), NURBS_ERROR_NULL, "face");
    CHECK_NO_MEET(nurbs_face_project_curve(face, NULL, down, 1e-6, &none), NURBS_ERROR_NULL, "curve");
    CHECK_NO_MEET(nurbs_face_project_curve(face, flat, down, 1e-6, &none), NURBS_ERROR_DIMENSION, "2");
    CHECK_NO_MEET(nurbs_face_project_curve(level_face, curve, down, 1e-6, &none), NURBS_ERROR_DIMENSION, "2");
    CHECK_FAILS(nurbs_face_project_curve(face, curve, down, 1e-6, NULL), NURBS_ERROR_NULL, "out");
    const double bad[] = {0, -1, NAN};
    for (int i = 0; i < 3; ++i) {
        CHECK_NO_MEET(nurbs_surface_project_curve(g, curve, down, bad[i], &none), NURBS_ERROR_TOLERANCE,
                      "tolerance");
        CHECK_NO_MEET(nurbs_face_project_curve(face, curve, down, bad[i], &none), NURBS_ERROR_TOLERANCE,
                      "tolerance");
        CHECK_NO_MEET(nurbs_surface_project_curve(g, curve, NULL, bad[i], &none), NURBS_ERROR_TOLERANCE,
                      "tolerance");
    }
    nurbs_face_destroy(level_face);
    nurbs_face_destroy(face);
    nurbs_destroy(level);
    nurbs_destroy(flat);
    nurbs_destroy(curve);
    nurbs_destroy(g);
}

int main(void) {
    onto_a_plane();
    over_a_fold();
    closed();
    beside_and_along();
    onto_a_face();
    normally();
    watched();
    refused();
    return check_summary("project_curve");
}
