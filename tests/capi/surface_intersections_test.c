/* SPDX-License-Identifier: MIT */
/* Where surfaces meet: known shapes, both domains, limits of work, surfaces that are one, bad input. */
#include "shapes.h"

#include <math.h>
#include <string.h>

enum { most = 8 };

static const double turn = 6.283185307179586;

/* A ruled surface over the unit square: z = u. */
static nurbs *ramp(void) {
    const int32_t degrees[] = {1, 1};
    const int64_t counts[] = {2, 2};
    const double knots[] = {0, 0, 1, 1, 0, 0, 1, 1}, points[] = {0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1, 1};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 8, 3, points, 0, 0, NULL, 0, 0, &g));
    return g;
}

static nurbs *level(double z) {
    const int32_t degrees[] = {1, 1};
    const int64_t counts[] = {2, 2};
    const double knots[] = {0, 0, 1, 1, 0, 0, 1, 1}, points[] = {-1, -1, z, -1, 2, z, 2, -1, z, 2, 2, z};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 8, 3, points, 0, 0, NULL, 0, 0, &g));
    return g;
}

static nurbs_meet *met(nurbs *a, nurbs *b, double tolerance) {
    nurbs_meet *meet = NULL;
    CHECK_OK(nurbs_surface_intersections(a, b, tolerance, &meet));
    nurbs_destroy(a);
    nurbs_destroy(b);
    return meet;
}

/* The line z = 1/2 on the ramp, along N_b x N_a: upwards is on its left in the domain of the ramp. */
static void a_ramp(void) {
    nurbs_meet *meet = met(ramp(), level(0.5), 1e-9);
    int64_t branches = 0, nodes = 0, levels[most], ends[2 * most], loops[most], count = 0;
    int32_t complete = 0, kinds[most];
    double deviations[most], params[2 * most], ranges[4 * most], second[2 * most], second_ranges[4 * most];
    CHECK_OK(nurbs_meet_counts(meet, &branches, &nodes, &complete));
    CHECK(branches == 1 && nodes == 2 && complete == 1);
    CHECK_OK(nurbs_meet_branches(meet, most, levels, ends, loops, deviations, &count));
    CHECK(count == 1 && levels[0] == 0 && loops[0] == -1 && deviations[0] > 0 && deviations[0] < 1e-9);
    CHECK_OK(nurbs_meet_kinds(meet, most, kinds, &count));
    CHECK(count == 1 && kinds[0] == NURBS_BRANCH_CROSSING);
    CHECK_OK(nurbs_meet_nodes(meet, most, NULL, kinds, params, ranges, NULL));
    CHECK_OK(nurbs_meet_nodes_second(meet, most, second, second_ranges, &count));
    CHECK_INT(count, 2);
    for (int i = 0; i < 2; ++i) {
        CHECK_INT(kinds[i], NURBS_NODE_BORDER);
        CHECK(second_ranges[4 * i] == second[2 * i] && second_ranges[4 * i + 1] == second[2 * i]);
        CHECK(fabs(second[2 * i] - 0.5) < 1e-12 &&
              fabs(second[2 * i + 1] - (1 + params[2 * i + 1]) / 3) < 1e-12);
    }
    nurbs *space = NULL, *on = NULL, *on_second = NULL;
    CHECK_OK(nurbs_meet_branch(meet, 0, &space, &on));
    CHECK_OK(nurbs_meet_branch_second(meet, 0, &on_second));
    double domain[2], x[3], uv[2], st[2];
    CHECK_OK(nurbs_domain(on_second, 0, domain));
    CHECK_OK(nurbs_eval(space, 1, domain, 0, 0, x, 0, 0, 0));
    CHECK_OK(nurbs_eval(on, 1, domain, 0, 0, uv, 0, 0, 0));
    CHECK_OK(nurbs_eval(on_second, 1, domain, 0, 0, st, 0, 0, 0));
    const double *from = params + 2 * ends[0], *to = params + 2 * ends[1];
    CHECK(uv[0] == from[0] && uv[1] == from[1] && st[1] == second[2 * ends[0] + 1]);
    CHECK(fabs(x[0] - 0.5) < 1e-12 && fabs(x[2] - 0.5) < 1e-12 && fabs(domain[1] - domain[0] - 1) < 1e-12);
    CHECK(from[1] == 1 && to[1] == 0);
    nurbs_destroy(space);
    nurbs_destroy(on);
    nurbs_destroy(on_second);
    nurbs_meet_destroy(meet);
}

static nurbs_face *whole_face(const nurbs *g) {
    nurbs_face *face = NULL;
    CHECK_OK(nurbs_face_create(g, 0, NULL, NULL, NULL, NULL, 1e-9, 0, NULL, &face));
    return face;
}

/* The square face of lower <= u, v <= upper. */
static nurbs_face *square_face(const nurbs *g, double lower, double upper) {
    const int32_t degree = 1;
    const int64_t count = 5, one = 1;
    const double knots[] = {0, 0, 1, 2, 3, 4, 4},
                 points[] = {lower, lower, upper, lower, upper, upper, lower, upper, lower, lower};
    nurbs *loop = NULL;
    nurbs_face *face = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 7, 2, points, 0, 0, NULL, 0, 0, &loop));
    const nurbs *curves[] = {loop};
    CHECK_OK(nurbs_face_create(g, 1, &one, curves, NULL, NULL, 1e-9, 0, NULL, &face));
    nurbs_destroy(loop);
    return face;
}

/* Of the line z = 1/2 on the ramp, 0 <= y <= 1, what is in a face of the ramp, in one of the level, where (x, y) = (3 u - 1,
 * 3 v - 1), and in both. */
static void in_faces(void) {
    nurbs *a = ramp(), *b = level(0.5);
    nurbs_face *first = square_face(a, 0.25, 0.75), *second = square_face(b, 0.45, 0.9);
    nurbs_meet *meet = NULL, *parts[4] = {NULL};
    CHECK_OK(nurbs_surface_intersections(a, b, 1e-9, &meet));
    CHECK_OK(nurbs_meet_trim(meet, first, &parts[0]));
    CHECK_OK(nurbs_meet_trim_second(meet, second, &parts[1]));
    CHECK_OK(nurbs_meet_trim_second_with(parts[0], second, NULL, &parts[2]));
    CHECK_OK(nurbs_meet_trim(parts[1], first, &parts[3]));
    const double lower[] = {0.25, 0.35, 0.35, 0.35}, upper[] = {0.75, 1, 0.75, 0.75};
    for (int i = 0; i < 4; ++i) {
        int64_t branches = 0, ends[2] = {-1, -1};
        int32_t complete = 0, kinds[most];
        double params[2 * most], second_params[2 * most], deviation = 1;
        CHECK_OK(nurbs_meet_counts(parts[i], &branches, NULL, &complete));
        CHECK(branches == 1 && complete == 1);
        CHECK_OK(nurbs_meet_branches(parts[i], 1, NULL, ends, NULL, &deviation, NULL));
        CHECK(deviation <= 1e-9);
        CHECK_OK(nurbs_meet_nodes(parts[i], most, NULL, kinds, params, NULL, NULL));
        CHECK_OK(nurbs_meet_nodes_second(parts[i], most, second_params, NULL, NULL));
        for (int k = 0; k < 2; ++k) {
            const double y = k == 0 ? upper[i] : lower[i];
            CHECK_INT(kinds[ends[k]], NURBS_NODE_BORDER);
            CHECK(fabs(params[2 * ends[k] + 1] - y) < 1e-9);
            CHECK(fabs(second_params[2 * ends[k] + 1] - (1 + y) / 3) < 1e-9);
        }
        nurbs_meet_destroy(parts[i]);
    }
    nurbs_face_destroy(first);
    nurbs_face_destroy(second);
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_meet_destroy(meet);
}

static nurbs *tube(double radius, const double *axis) {
    nurbs *g = NULL;
    const double center[] = {-3 * axis[0], -3 * axis[1], -3 * axis[2]};
    CHECK_OK(nurbs_surface_cylinder(center, axis, NULL, radius, 6, 0, turn, NURBS_ARC_QUARTERS, &g));
    return g;
}

/* A thin tube goes in and out of a thick one. */
static void tubes(void) {
    const double z[] = {0, 0, 1}, x[] = {1, 0, 0};
    nurbs_meet *meet = met(tube(1, z), tube(0.5, x), 1e-6);
    int64_t count = 0;
    int32_t complete = 0, closes[most];
    CHECK_OK(nurbs_meet_counts(meet, NULL, NULL, &complete));
    CHECK_OK(nurbs_meet_ways(meet, most, NULL, NULL, NULL, closes, NULL, &count));
    CHECK(complete == 1 && count == 2 && closes[0] == 1 && closes[1] == 1);
    nurbs_meet_destroy(meet);
}

/* Surfaces apart have nothing in common, and one surface too much to tell. */
static void apart(void) {
    int64_t branches = -1, nodes = -1;
    int32_t complete = -1;
    nurbs_meet *meet = met(ramp(), level(3), 1e-6);
    CHECK_OK(nurbs_meet_counts(meet, &branches, &nodes, &complete));
    CHECK(branches == 0 && nodes == 0 && complete == 1);
    nurbs_meet_destroy(meet);
}

static nurbs *square(double x, double y, double size) {
    const double origin[] = {x, y, 0}, u[] = {size, 0, 0}, v[] = {0, size, 0};
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_plane(3, origin, u, v, &g));
    return g;
}

/* [0, 2]^2 and [1, 3]^2: four branches around [1/2, 1]^2 in the domain of the first one, on the level of the region. */
static void overlap(void) {
    nurbs *a = square(0, 0, 2), *b = square(1, 1, 2);
    nurbs_meet *meet = NULL, *part = NULL;
    CHECK_OK(nurbs_surface_intersections(a, b, 1e-9, &meet));
    int64_t branches = 0, nodes = 0, levels[most], ends[2 * most], loops[most], next[most], closed = 0;
    int32_t complete = 0, kinds[most], closes[most];
    double params[2 * most], ranges[4 * most], second[2 * most], second_ranges[4 * most];
    CHECK_OK(nurbs_meet_counts(meet, &branches, &nodes, &complete));
    CHECK(branches == 4 && nodes == 5 && complete == 1);
    CHECK_OK(nurbs_meet_branches(meet, most, levels, ends, loops, NULL, NULL));
    CHECK_OK(nurbs_meet_kinds(meet, most, kinds, NULL));
    for (int i = 0; i < 4; ++i) {
        CHECK(levels[i] == 1 && loops[i] == 0 && kinds[i] == NURBS_BRANCH_OVERLAP);
        CHECK_INT(ends[2 * i + 1], ends[2 * ((i + 1) % 4)]);
    }
    CHECK_OK(nurbs_meet_ways(meet, most, levels, NULL, NULL, closes, NULL, &closed));
    CHECK(closed == 1 && closes[0] == 1 && levels[0] == 1);
    CHECK_OK(nurbs_meet_nodes(meet, most, levels, kinds, params, ranges, NULL));
    CHECK_OK(nurbs_meet_nodes_second(meet, most, second, second_ranges, NULL));
    CHECK_OK(nurbs_meet_joints(meet, most, next, NULL, NULL, NULL, NULL));
    int regions = 0;
    for (int i = 0; i < 5; ++i) {
        CHECK_INT(levels[i], 1);
        if (kinds[i] != NURBS_NODE_OVERLAP) {
            CHECK(kinds[i] == NURBS_NODE_BORDER && next[i] == i);
            continue;
        }
        ++regions;
        for (int k = 0; k < 2; ++k) {
            const double *on_a = ranges + 4 * i + 2 * k, *on_b = second_ranges + 4 * i + 2 * k;
            CHECK(fabs(on_a[0] - 0.5) < 1e-12 && on_a[1] == 1 && on_b[0] == 0 && fabs(on_b[1] - 0.5) < 1e-12);
            CHECK(params[2 * i + k] > 0.5 && params[2 * i + k] < 1);
            CHECK(fabs(2 * params[2 * i + k] - 1 - 2 * second[2 * i + k]) < 1e-9);
        }
    }
    CHECK_INT(regions, 1);
    /* What a face has of it is left open. */
    nurbs_face *face = whole_face(a);
    CHECK_OK(nurbs_meet_trim(meet, face, &part));
    CHECK_OK(nurbs_meet_counts(part, &branches, &nodes, &complete));
    CHECK(branches == 0 && nodes == 1 && complete == 0);
    CHECK_OK(nurbs_meet_nodes(part, most, levels, kinds, NULL, NULL, NULL));
    CHECK(levels[0] == 0 && kinds[0] == NURBS_NODE_UNDECIDED);
    nurbs_face_destroy(face);
    nurbs_meet_destroy(part);
    nurbs_meet_destroy(meet);
    nurbs_destroy(a);
    nurbs_destroy(b);
}

static int32_t stop(double done, void *user) {
    (void)done;
    ++*(int *)user;
    return 1;
}

/* A limit of work leaves open what was not looked at; progress ends the call. */
static void watched(void) {
    const double z[] = {0, 0, 1}, x[] = {1, 0, 0};
    nurbs *a = tube(1, z), *b = tube(1, x); /* which touch in two places */
    nurbs_meet *meet = NULL;
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    int32_t complete = -1;
    for (call.work = 1; call.work <= 10000000; call.work *= 10) {
        CHECK_OK(nurbs_surface_intersections_with(a, b, 1e-6, &call, &meet));
        CHECK_OK(nurbs_meet_counts(meet, NULL, NULL, &complete));
        CHECK_INT(complete, 0);
        nurbs_meet_destroy(meet);
    }
    int asked = 0;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.progress = stop;
    call.user = &asked;
    CHECK_FAILS(nurbs_surface_intersections_with(a, a, 1e-9, &call, &meet), NURBS_ERROR_CANCELLED, "");
    CHECK(asked == 1 && meet == NULL);
    call.struct_size = 1;
    CHECK_FAILS(nurbs_surface_intersections_with(a, b, 1e-9, &call, &meet), NURBS_ERROR_OPTIONS,
                "struct_size");
    nurbs_destroy(a);
    nurbs_destroy(b);
}

#define CHECK_NO_MEET(call, status, words)                                                                   \
    do {                                                                                                     \
        nurbs_meet *none = (nurbs_meet *)(void *)check_poison();                                             \
        CHECK_FAILS(call, status, words);                                                                    \
        CHECK(none == NULL);                                                                                 \
    } while (0)

static void refused(void) {
    nurbs *g = ramp(), *other = level(0.5), *curve = NULL, *plane = NULL;
    CHECK_OK(nurbs_iso(g, 0, 0.5, 0, &curve));
    const double drop[] = {1, 0, 0, 0, 1, 0};
    CHECK_OK(nurbs_transform(g, 2, drop, NULL, &plane));
    CHECK_NO_MEET(nurbs_surface_intersections(NULL, g, 1e-6, &none), NURBS_ERROR_NULL, "a");
    CHECK_NO_MEET(nurbs_surface_intersections(g, NULL, 1e-6, &none), NURBS_ERROR_NULL, "b");
    CHECK_FAILS(nurbs_surface_intersections(g, other, 1e-6, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_MEET(nurbs_surface_intersections(curve, g, 1e-6, &none), NURBS_ERROR_AXES, "a");
    CHECK_NO_MEET(nurbs_surface_intersections(g, curve, 1e-6, &none), NURBS_ERROR_AXES, "b");
    CHECK_NO_MEET(nurbs_surface_intersections(plane, g, 1e-6, &none), NURBS_ERROR_DIMENSION, "");
    CHECK_NO_MEET(nurbs_surface_intersections(g, plane, 1e-6, &none), NURBS_ERROR_DIMENSION, "");
    const double bad[] = {0, -1, NAN};
    for (int i = 0; i < 3; ++i) {
        CHECK_NO_MEET(nurbs_surface_intersections(g, other, bad[i], &none), NURBS_ERROR_TOLERANCE,
                      "tolerance");
    }
    nurbs_destroy(plane);
    nurbs_destroy(curve);
    nurbs_destroy(other);
    nurbs_destroy(g);
}

static void refused_by_meets(void) {
    nurbs_meet *meet = met(ramp(), level(0.5), 1e-6), *section = NULL,
               *trimmed = (nurbs_meet *)(void *)check_poison();
    double params[2 * most], ranges[4 * most];
    int64_t count = 0;
    memset(params, 0x5a, sizeof params);
    memset(ranges, 0x5a, sizeof ranges);
    nurbs *on = check_poison();
    CHECK_FAILS(nurbs_meet_branch_second(NULL, 0, &on), NURBS_ERROR_NULL, "meet");
    CHECK(on == NULL);
    CHECK_FAILS(nurbs_meet_branch_second(meet, 0, NULL), NURBS_ERROR_NULL, "on_second");
    for (int64_t index = -1; index <= 1; index += 2) {
        on = check_poison();
        CHECK_FAILS(nurbs_meet_branch_second(meet, index, &on), NURBS_ERROR_INDEX, "index");
        CHECK(on == NULL);
    }
    int32_t kinds[most];
    memset(kinds, 0x5a, sizeof kinds);
    CHECK_FAILS(nurbs_meet_kinds(NULL, most, kinds, &count), NURBS_ERROR_NULL, "meet");
    CHECK_FAILS(nurbs_meet_kinds(meet, -1, kinds, &count), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_meet_kinds(meet, most, kinds, (int64_t *)(void *)kinds), NURBS_ERROR_OVERLAP, "kinds");
    CHECK_UNTOUCHED(kinds);
    CHECK_OK(nurbs_meet_kinds(meet, 0, NULL, &count));
    CHECK_INT(count, 1);
    CHECK_OK(nurbs_meet_kinds(meet, 0, NULL, NULL));
    CHECK_FAILS(nurbs_meet_nodes_second(NULL, most, params, ranges, &count), NURBS_ERROR_NULL, "meet");
    CHECK_FAILS(nurbs_meet_nodes_second(meet, -1, params, ranges, &count), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_meet_nodes_second(meet, 1, params, ranges, &count), NURBS_ERROR_SIZE, "cap = 1");
    CHECK_FAILS(nurbs_meet_nodes_second(meet, most, params, params, &count), NURBS_ERROR_OVERLAP, "params");
    CHECK_UNTOUCHED(params);
    CHECK_UNTOUCHED(ranges);
    CHECK_OK(nurbs_meet_nodes_second(meet, 0, NULL, NULL, &count));
    CHECK_INT(count, 2);
    nurbs *g = ramp();
    const double up[] = {0, 0, 1}, height = 0.5;
    CHECK_OK(nurbs_surface_sections(g, up, 1, &height, 1e-6, &section));
    CHECK_FAILS(nurbs_meet_branch_second(section, 0, &on), NURBS_ERROR_INCOMPATIBLE, "one surface");
    CHECK_FAILS(nurbs_meet_nodes_second(section, 0, NULL, NULL, &count), NURBS_ERROR_INCOMPATIBLE,
                "one surface");
    nurbs_face *face = whole_face(g);
    CHECK_FAILS(nurbs_meet_trim_second(section, face, &trimmed), NURBS_ERROR_INCOMPATIBLE, "one surface");
    CHECK(trimmed == NULL);
    trimmed = (nurbs_meet *)(void *)check_poison();
    CHECK_FAILS(nurbs_meet_trim_second(NULL, face, &trimmed), NURBS_ERROR_NULL, "meet is NULL");
    CHECK(trimmed == NULL);
    trimmed = (nurbs_meet *)(void *)check_poison();
    CHECK_FAILS(nurbs_meet_trim_second(meet, NULL, &trimmed), NURBS_ERROR_NULL, "face is NULL");
    CHECK(trimmed == NULL);
    CHECK_FAILS(nurbs_meet_trim_second(meet, face, NULL), NURBS_ERROR_NULL, "out");
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.struct_size = 1;
    CHECK_FAILS(nurbs_meet_trim_second_with(meet, face, &call, &trimmed), NURBS_ERROR_OPTIONS, "struct_size");
    nurbs_face_destroy(face);
    nurbs_destroy(g);
    nurbs_meet_destroy(section);
    nurbs_meet_destroy(meet);
}

int main(void) {
    a_ramp();
    in_faces();
    tubes();
    apart();
    overlap();
    watched();
    refused();
    refused_by_meets();
    return check_summary("surface_intersections");
}
