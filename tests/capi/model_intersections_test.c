/* SPDX-License-Identifier: MIT */
/* Where models meet: a slab through a box, the faces of both that meets tell, limits of work, bad input. */
#include "models.h"

#include <math.h>

enum { most = 32 };

/* A face around the box [0, 1] x [0, 2] x [0, 3]. */
static nurbs_model *slab_at(double height, double lower, double upper) {
    const double origin[] = {lower, lower, height}, u[] = {upper - lower, 0, 0}, v[] = {0, upper - lower, 0};
    nurbs *g = NULL;
    nurbs_face *face = NULL;
    nurbs_model *model = NULL;
    CHECK_OK(nurbs_surface_plane(3, origin, u, v, &g));
    CHECK_OK(nurbs_face_create(g, 0, NULL, NULL, NULL, NULL, 1e-9, 0, NULL, &face));
    const nurbs_face *faces[] = {face};
    CHECK_OK(nurbs_model_create(1, faces, 1, &model));
    nurbs_face_destroy(face);
    nurbs_destroy(g);
    return model;
}

static nurbs_model *slab(double lower, double upper) {
    return slab_at(1.5, lower, upper);
}

static nurbs_meet *met(nurbs_model *a, nurbs_model *b) {
    nurbs_meet *meet = NULL;
    CHECK_OK(nurbs_model_intersections(a, b, 1e-9, &meet));
    nurbs_model_destroy(a);
    nurbs_model_destroy(b);
    return meet;
}

/* Around four sides of the box; both ways round the same. */
static void around_a_box(void) {
    for (int exchanged = 0; exchanged < 2; ++exchanged) {
        nurbs_meet *meet = exchanged ? met(slab(-1, 4), box()) : met(box(), slab(-1, 4));
        int64_t branches = 0, nodes = 0, count = 0, sizes[most], first[most], second[most], instances[most],
                of_first[most], of_second[most], next[most], ends[2 * most];
        int32_t complete = 0, closes[most], kinds[most];
        CHECK_OK(nurbs_meet_counts(meet, &branches, &nodes, &complete));
        CHECK(branches == 4 && nodes == 8 && complete == 1);
        CHECK_OK(nurbs_meet_ways(meet, most, NULL, NULL, sizes, closes, NULL, &count));
        CHECK(count == 1 && sizes[0] == 4 && closes[0] == 1);
        CHECK_OK(nurbs_meet_faces(meet, most, first, NULL, NULL));
        CHECK_OK(nurbs_meet_faces_second(meet, most, second, instances, &count));
        CHECK_INT(count, 4);
        CHECK_OK(nurbs_meet_joints(meet, most, next, NULL, of_first, NULL, NULL));
        CHECK_OK(nurbs_meet_joints_second(meet, most, of_second, NULL, &count));
        CHECK_INT(count, 8);
        CHECK_OK(nurbs_meet_branches(meet, most, NULL, ends, NULL, NULL, NULL));
        CHECK_OK(nurbs_meet_nodes(meet, most, NULL, kinds, NULL, NULL, NULL));
        int seen = 0;
        for (int i = 0; i < 4; ++i) {
            const int64_t of_box = exchanged ? second[i] : first[i],
                          of_slab = exchanged ? first[i] : second[i];
            CHECK(of_box >= 0 && of_box < 6 && of_slab == 0 && instances[i] == 0);
            seen |= 1 << of_box;
            for (int k = 0; k < 2; ++k) {
                const int64_t node = ends[2 * i + k];
                CHECK_INT(kinds[node], NURBS_NODE_EDGE);
                CHECK(of_first[node] == first[i] && of_second[node] == second[i] && next[next[node]] == node);
            }
        }
        int sides = 0;
        for (int k = 0; k < 6; ++k) {
            sides += seen >> k & 1;
        }
        CHECK_INT(sides, 4);
        nurbs_meet_destroy(meet);
    }
}

/* A slab that ends inside: the way is open, at its border. */
static void ends_inside(void) {
    nurbs_meet *meet = met(box(), slab(-1, 0.5));
    int64_t count = 0, nodes = 0, borders = 0;
    int32_t complete = 0, closes[most], kinds[most];
    CHECK_OK(nurbs_meet_counts(meet, NULL, &nodes, &complete));
    CHECK_OK(nurbs_meet_ways(meet, most, NULL, NULL, NULL, closes, NULL, &count));
    CHECK(count == 1 && closes[0] == 0 && complete == 1);
    CHECK_OK(nurbs_meet_nodes(meet, most, NULL, kinds, NULL, NULL, NULL));
    for (int64_t i = 0; i < nodes; ++i) {
        borders += kinds[i] == NURBS_NODE_BORDER;
    }
    CHECK(nodes == 4 && borders == 2);
    nurbs_meet_destroy(meet);
}

/* On the top: a region of one of its faces, and no curves of the sides beside it. */
static void on_top(void) {
    for (int exchanged = 0; exchanged < 2; ++exchanged) {
        nurbs_meet *meet = exchanged ? met(slab_at(3, -1, 4), box()) : met(box(), slab_at(3, -1, 4));
        int64_t branches = 0, nodes = 0, levels[most], first[most], second[most], of_first[most], ways = 0;
        int32_t complete = 0, kinds[most], node_kinds[most], regions = 0, closes[most];
        CHECK_OK(nurbs_meet_counts(meet, &branches, &nodes, &complete));
        CHECK(branches == 4 && nodes == 5 && complete == 1);
        CHECK_OK(nurbs_meet_kinds(meet, most, kinds, NULL));
        CHECK_OK(nurbs_meet_branches(meet, most, levels, NULL, NULL, NULL, NULL));
        CHECK_OK(nurbs_meet_faces(meet, most, first, NULL, NULL));
        CHECK_OK(nurbs_meet_faces_second(meet, most, second, NULL, NULL));
        CHECK_OK(nurbs_meet_joints(meet, most, NULL, NULL, of_first, NULL, NULL));
        CHECK_OK(nurbs_meet_nodes(meet, most, NULL, node_kinds, NULL, NULL, NULL));
        CHECK_OK(nurbs_meet_ways(meet, most, NULL, NULL, NULL, closes, NULL, &ways));
        CHECK(ways == 1 && closes[0] == 1);
        for (int i = 0; i < 4; ++i) {
            CHECK(kinds[i] == NURBS_BRANCH_OVERLAP && levels[i] == 1);
            CHECK(first[i] == first[0] && second[i] == second[0] && (exchanged ? first : second)[i] == 0);
        }
        for (int i = 0; i < 5; ++i) {
            regions += node_kinds[i] == NURBS_NODE_OVERLAP;
            CHECK_INT(of_first[i], first[0]);
        }
        CHECK_INT(regions, 1);
        nurbs_meet_destroy(meet);
    }
}

static void apart(void) {
    nurbs_meet *meet = met(box(), slab(5, 6));
    int64_t branches = -1, nodes = -1;
    int32_t complete = 0;
    CHECK_OK(nurbs_meet_counts(meet, &branches, &nodes, &complete));
    CHECK(branches == 0 && nodes == 0 && complete == 1);
    nurbs_meet_destroy(meet);
}

/* A ball, which takes long to be met with itself. */
static nurbs_model *ball(void) {
    nurbs *g = NULL;
    nurbs_face *face = NULL;
    nurbs_model *model = NULL;
    CHECK_OK(nurbs_surface_sphere(NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &g));
    CHECK_OK(nurbs_face_create(g, 0, NULL, NULL, NULL, NULL, 1e-9, 0, NULL, &face));
    const nurbs_face *faces[] = {face};
    CHECK_OK(nurbs_model_create(1, faces, 1, &model));
    nurbs_face_destroy(face);
    nurbs_destroy(g);
    return model;
}

static int32_t stop(double done, void *user) {
    (void)done;
    ++*(int *)user;
    return 1;
}

static void watched(void) {
    nurbs_model *a = box(), *b = slab(-1, 4), *round = ball();
    nurbs_meet *meet = NULL;
    nurbs_call_options call;
    int32_t complete = 1;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    for (call.work = 1; call.work <= 100; call.work *= 10) {
        CHECK_OK(nurbs_model_intersections_with(a, b, 1e-9, &call, &meet));
        CHECK_OK(nurbs_meet_counts(meet, NULL, NULL, &complete));
        CHECK_INT(complete, 0);
        nurbs_meet_destroy(meet);
    }
    CHECK_OK(nurbs_model_intersections_with(a, b, 1e-9, NULL, &meet));
    nurbs_meet_destroy(meet);
    int asked = 0;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.progress = stop;
    call.user = &asked;
    CHECK_FAILS(nurbs_model_intersections_with(round, round, 1e-9, &call, &meet), NURBS_ERROR_CANCELLED, "");
    CHECK(asked == 1 && meet == NULL);
    call.struct_size = 1;
    CHECK_FAILS(nurbs_model_intersections_with(a, b, 1e-9, &call, &meet), NURBS_ERROR_OPTIONS, "struct_size");
    nurbs_model_destroy(round);
    nurbs_model_destroy(a);
    nurbs_model_destroy(b);
}

#define REFUSED(a, b, tolerance, status, text)                                                               \
    do {                                                                                                     \
        nurbs_meet *none = (nurbs_meet *)(void *)check_poison();                                             \
        CHECK_FAILS(nurbs_model_intersections(a, b, tolerance, &none), status, text);                        \
        CHECK(none == NULL);                                                                                 \
    } while (0)

static void refused(void) {
    nurbs_model *a = box(), *b = slab(-1, 4);
    REFUSED(NULL, b, 1e-3, NURBS_ERROR_NULL, "a is NULL");
    REFUSED(a, NULL, 1e-3, NURBS_ERROR_NULL, "b is NULL");
    REFUSED(a, b, 0, NURBS_ERROR_TOLERANCE, "tolerance");
    REFUSED(a, b, -1, NURBS_ERROR_TOLERANCE, "tolerance");
    REFUSED(a, b, NAN, NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_model_intersections(a, b, 1e-3, NULL), NURBS_ERROR_NULL, "out");
    nurbs_model_destroy(a);
    nurbs_model_destroy(b);
}

static void refused_by_meets(void) {
    nurbs_meet *meet = met(box(), slab(-1, 4)), *none = NULL;
    int64_t faces[most], instances[most], count = 0;
    FILL(faces);
    FILL(instances);
    CHECK_FAILS(nurbs_meet_faces_second(NULL, most, faces, instances, &count), NURBS_ERROR_NULL, "meet");
    CHECK_FAILS(nurbs_meet_faces_second(meet, -1, faces, instances, &count), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_meet_faces_second(meet, 3, faces, instances, &count), NURBS_ERROR_SIZE, "cap = 3");
    CHECK_FAILS(nurbs_meet_faces_second(meet, most, faces, faces, &count), NURBS_ERROR_OVERLAP,
                "own_instances|own_faces");
    CHECK_FAILS(nurbs_meet_joints_second(NULL, most, faces, instances, &count), NURBS_ERROR_NULL, "meet");
    CHECK_FAILS(nurbs_meet_joints_second(meet, -1, faces, instances, &count), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_meet_joints_second(meet, 7, faces, instances, &count), NURBS_ERROR_SIZE, "cap = 7");
    CHECK_FAILS(nurbs_meet_joints_second(meet, most, faces, faces, &count), NURBS_ERROR_OVERLAP,
                "own_instances|own_faces");
    CHECK_UNTOUCHED(faces);
    CHECK_UNTOUCHED(instances);
    nurbs_face *sides[6];
    box_faces(sides);
    CHECK_FAILS(nurbs_meet_trim(meet, sides[0], &none), NURBS_ERROR_INCOMPATIBLE, "model");
    CHECK_FAILS(nurbs_meet_trim_second(meet, sides[0], &none), NURBS_ERROR_INCOMPATIBLE, "model");
    for (int i = 0; i < 6; ++i) {
        nurbs_face_destroy(sides[i]);
    }
    nurbs_meet_destroy(meet);
    nurbs *g = plane();
    const double up[] = {0, 0, 1}, height = 0.5;
    CHECK_OK(nurbs_surface_sections(g, up, 1, &height, 1e-6, &meet));
    CHECK_OK(nurbs_meet_faces_second(meet, most, NULL, NULL, &count));
    CHECK_INT(count, 0);
    nurbs_meet_destroy(meet);
    nurbs_destroy(g);
}

int main(void) {
    around_a_box();
    ends_inside();
    on_top();
    apart();
    watched();
    refused();
    refused_by_meets();
    return check_summary("model_intersections");
}
