/* SPDX-License-Identifier: MIT */
/* Sections of a model: ways around a box, the faces and joints that meets tell, bad input. */
#include "models.h"

enum { most = 16 };

/* z = 1, and x + y = 0.5 with a longer normal; of a box [0, 1] x [0, 2] x [0, 3]. */
static const double normals[] = {0, 0, 1, 2, 2, 0}, offsets[] = {1, 1};

static nurbs_meet *sections(void) {
    nurbs_model *model = box();
    nurbs_meet *meet = NULL;
    CHECK_OK(nurbs_model_sections(model, 2, normals, offsets, 1e-9, &meet));
    nurbs_model_destroy(model);
    return meet;
}

static void ways(void) {
    nurbs_meet *meet = sections();
    int64_t branches = 0, nodes = 0, count = 0, levels[most], firsts[most], sizes[most];
    int32_t complete = 0, closed[most];
    double gaps[most];
    CHECK_OK(nurbs_meet_counts(meet, &branches, &nodes, &complete));
    CHECK(branches == 8 && nodes == 16 && complete == 1);
    CHECK_OK(nurbs_meet_ways(meet, most, levels, firsts, sizes, closed, gaps, &count));
    CHECK_INT(count, 2);
    for (int i = 0; i < 2; ++i) {
        CHECK(levels[i] == i && firsts[i] == 4 * i && sizes[i] == 4 && closed[i] == 1 && gaps[i] < 1e-12);
    }
    CHECK_OK(nurbs_meet_ways(meet, 0, NULL, NULL, NULL, NULL, NULL, &count));
    CHECK_INT(count, 2);
    CHECK_OK(nurbs_meet_ways(meet, 2, NULL, NULL, NULL, NULL, NULL, NULL));
    nurbs_meet_destroy(meet);
}

/* Each branch ends in a node of its face, and goes on in the node of another one. */
static void faces_and_joints(void) {
    nurbs_meet *meet = sections();
    int64_t faces[most], instances[most], next[most], of_nodes[most], in[most], ends[2 * most], loops[most],
        count = 0;
    double gaps[most];
    int32_t kinds[most];
    CHECK_OK(nurbs_meet_branches(meet, most, NULL, ends, loops, NULL, NULL));
    CHECK_OK(nurbs_meet_faces(meet, most, faces, instances, &count));
    CHECK_INT(count, 8);
    CHECK_OK(nurbs_meet_joints(meet, most, next, gaps, of_nodes, in, &count));
    CHECK_INT(count, 16);
    CHECK_OK(nurbs_meet_nodes(meet, most, NULL, kinds, NULL, NULL, NULL));
    for (int i = 0; i < 8; ++i) {
        CHECK(faces[i] >= 0 && faces[i] < 6 && instances[i] == 0 && loops[i] == i / 4);
        const int64_t end = ends[2 * i + 1];
        const int after = i % 4 == 3 ? i - 3 : i + 1;
        CHECK(of_nodes[end] == faces[i] && in[end] == 0 && gaps[end] < 1e-12);
        CHECK(next[end] == ends[2 * after] && next[next[end]] == end);
        CHECK_INT(kinds[end], NURBS_NODE_EDGE);
    }
    CHECK_OK(nurbs_meet_faces(meet, 0, NULL, NULL, &count));
    CHECK_OK(nurbs_meet_faces(meet, 8, NULL, NULL, NULL));
    CHECK_OK(nurbs_meet_joints(meet, 0, NULL, NULL, NULL, NULL, &count));
    CHECK_OK(nurbs_meet_joints(meet, 16, NULL, NULL, NULL, NULL, NULL));
    nurbs_meet_destroy(meet);
}

/* Ways of one surface: over its seam, which is not periodic. */
static void of_one_surface(void) {
    nurbs *g = NULL;
    nurbs_meet *meet = NULL;
    const double across[] = {1, 0, 0}, along[] = {0, 0, 1}, at[] = {0.5};
    int64_t count = 0, firsts[most], sizes[most], faces[most], next[most];
    int32_t closed[most];
    CHECK_OK(nurbs_surface_cylinder(NULL, NULL, NULL, 1, 2, 0, 6.283185307179586, NURBS_ARC_QUARTERS, &g));
    CHECK_OK(nurbs_surface_sections(g, along, 1, at, 1e-6, &meet));
    CHECK_OK(nurbs_meet_ways(meet, most, NULL, firsts, sizes, closed, NULL, &count));
    CHECK(count == 1 && firsts[0] == 0 && closed[0] == 1);
    CHECK_OK(nurbs_meet_faces(meet, most, faces, NULL, NULL));
    CHECK_INT(faces[0], -1);
    nurbs_meet_destroy(meet);
    CHECK_OK(nurbs_surface_sections(g, across, 1, at, 1e-6, &meet));
    CHECK_OK(nurbs_meet_ways(meet, most, NULL, firsts, sizes, closed, NULL, &count));
    CHECK(count == 2 && sizes[0] == 1 && closed[0] == 0 && closed[1] == 0);
    CHECK_OK(nurbs_meet_joints(meet, most, next, NULL, NULL, NULL, NULL));
    CHECK_INT(next[0], -1);
    nurbs_meet_destroy(meet);
    nurbs_destroy(g);
}

static int32_t stop(double done, void *user) {
    (void)done;
    ++*(int *)user;
    return 1;
}

static void watched(void) {
    nurbs_model *model = box();
    nurbs_meet *meet = NULL;
    nurbs_call_options call;
    int32_t complete = 1;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    CHECK_OK(nurbs_model_sections_with(model, 2, normals, offsets, 1e-9, &call, &meet));
    CHECK_OK(nurbs_meet_counts(meet, NULL, NULL, &complete));
    CHECK_INT(complete, 1);
    nurbs_meet_destroy(meet);
    CHECK_OK(nurbs_model_sections_with(model, 2, normals, offsets, 1e-9, NULL, &meet));
    nurbs_meet_destroy(meet);
    for (call.work = 1; call.work <= 100; call.work *= 10) {
        CHECK_OK(nurbs_model_sections_with(model, 2, normals, offsets, 1e-9, &call, &meet));
        CHECK_OK(nurbs_meet_counts(meet, NULL, NULL, &complete));
        CHECK_INT(complete, 0);
        nurbs_meet_destroy(meet);
    }
    static double many[3 * 4000], at[4000];
    for (int i = 0; i < 4000; ++i) {
        many[3 * i] = 1;
        many[3 * i + 1] = i;
        at[i] = 0.5 + i;
    }
    int asked = 0;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.progress = stop;
    call.user = &asked;
    CHECK_FAILS(nurbs_model_sections_with(model, 4000, many, at, 1e-9, &call, &meet), NURBS_ERROR_CANCELLED,
                "");
    CHECK(asked == 1 && meet == NULL);
    call.struct_size = 1;
    CHECK_FAILS(nurbs_model_sections_with(model, 2, normals, offsets, 1e-9, &call, &meet),
                NURBS_ERROR_OPTIONS, "struct_size");
    nurbs_model_destroy(model);
}

#define REFUSED(model, n, normals, offsets, tolerance, status, text)                                         \
    do {                                                                                                     \
        nurbs_meet *none = (nurbs_meet *)(void *)check_poison();                                             \
        CHECK_FAILS(nurbs_model_sections(model, n, normals, offsets, tolerance, &none), status, text);       \
        CHECK(none == NULL);                                                                                 \
    } while (0)

static void refused(void) {
    nurbs_model *model = box();
    nurbs_meet *meet = NULL;
    const double no_direction[] = {0, 0, 1, 0, 0, 0}, unknown[] = {0, NAN, 1, 0, 0, 1}, bad[] = {1, INFINITY};
    REFUSED(NULL, 2, normals, offsets, 1e-3, NURBS_ERROR_NULL, "model is NULL");
    REFUSED(model, -1, normals, offsets, 1e-3, NURBS_ERROR_COUNT, "n = -1");
    REFUSED(model, INT64_MAX, normals, offsets, 1e-3, NURBS_ERROR_OVERFLOW, "normals");
    REFUSED(model, 2, NULL, offsets, 1e-3, NURBS_ERROR_NULL, "normals");
    REFUSED(model, 2, normals, NULL, 1e-3, NURBS_ERROR_NULL, "offsets");
    REFUSED(model, 2, no_direction, offsets, 1e-3, NURBS_ERROR_DIRECTION, "normals[1]");
    REFUSED(model, 2, unknown, offsets, 1e-3, NURBS_ERROR_DIRECTION, "normals[0]");
    REFUSED(model, 2, normals, bad, 1e-3, NURBS_ERROR_POINT_NOT_FINITE, "offsets[1]");
    REFUSED(model, 2, normals, offsets, 0, NURBS_ERROR_TOLERANCE, "tolerance");
    REFUSED(model, 2, normals, offsets, NAN, NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_model_sections(model, 2, normals, offsets, 1e-3, NULL), NURBS_ERROR_NULL, "out");
    CHECK_OK(nurbs_model_sections(model, 0, NULL, NULL, 1e-3, &meet));
    int64_t count = -1;
    CHECK_OK(nurbs_meet_ways(meet, 0, NULL, NULL, NULL, NULL, NULL, &count));
    CHECK_INT(count, 0);
    nurbs_meet_destroy(meet);
    nurbs_model_destroy(model);
}

static void refused_by_meets(void) {
    nurbs_meet *meet = sections(), *none = NULL;
    int64_t levels[most], sizes[most], count = 0;
    int32_t closed[most];
    double gaps[most];
    FILL(levels);
    FILL(sizes);
    FILL(closed);
    FILL(gaps);
    CHECK_FAILS(nurbs_meet_ways(NULL, most, levels, NULL, sizes, closed, gaps, &count), NURBS_ERROR_NULL,
                "meet");
    CHECK_FAILS(nurbs_meet_ways(meet, -1, levels, NULL, sizes, closed, gaps, &count), NURBS_ERROR_COUNT,
                "cap = -1");
    CHECK_FAILS(nurbs_meet_ways(meet, 1, levels, NULL, sizes, closed, gaps, &count), NURBS_ERROR_SIZE,
                "cap = 1");
    CHECK_FAILS(nurbs_meet_ways(meet, most, levels, levels, sizes, closed, gaps, &count), NURBS_ERROR_OVERLAP,
                "firsts|levels");
    CHECK_FAILS(nurbs_meet_faces(NULL, most, levels, sizes, &count), NURBS_ERROR_NULL, "meet");
    CHECK_FAILS(nurbs_meet_faces(meet, -1, levels, sizes, &count), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_meet_faces(meet, 7, levels, sizes, &count), NURBS_ERROR_SIZE, "cap = 7");
    CHECK_FAILS(nurbs_meet_faces(meet, most, levels, levels, &count), NURBS_ERROR_OVERLAP,
                "own_instances|own_faces");
    CHECK_FAILS(nurbs_meet_joints(NULL, most, levels, gaps, sizes, NULL, &count), NURBS_ERROR_NULL, "meet");
    CHECK_FAILS(nurbs_meet_joints(meet, -1, levels, gaps, sizes, NULL, &count), NURBS_ERROR_COUNT,
                "cap = -1");
    CHECK_FAILS(nurbs_meet_joints(meet, 15, levels, gaps, sizes, NULL, &count), NURBS_ERROR_SIZE, "cap = 15");
    CHECK_FAILS(nurbs_meet_joints(meet, most, levels, gaps, levels, NULL, &count), NURBS_ERROR_OVERLAP,
                "own_faces|next_nodes");
    CHECK_UNTOUCHED(levels);
    CHECK_UNTOUCHED(sizes);
    CHECK_UNTOUCHED(closed);
    CHECK_UNTOUCHED(gaps);
    nurbs_face *faces[6];
    box_faces(faces);
    CHECK_FAILS(nurbs_meet_trim(meet, faces[0], &none), NURBS_ERROR_INCOMPATIBLE, "model");
    CHECK(none == NULL);
    for (int i = 0; i < 6; ++i) {
        nurbs_face_destroy(faces[i]);
    }
    nurbs_meet_destroy(meet);
}

int main(void) {
    ways();
    faces_and_joints();
    of_one_surface();
    watched();
    refused();
    refused_by_meets();
    return check_summary("model_sections");
}
