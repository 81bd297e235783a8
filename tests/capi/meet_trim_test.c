/* SPDX-License-Identifier: MIT */
/* Meets trimmed to a face with a hole, and bad input. */
#include "faces.h"

#include <math.h>

static const double across[] = {1, 0, 0};

static nurbs_meet *lines(void) {
    nurbs *g = plane();
    nurbs_meet *meet = NULL;
    const double at[] = {0.1, 0.4, 0.75}; /* x = 2 u */
    CHECK_OK(nurbs_surface_sections(g, across, 3, at, 1e-9, &meet));
    nurbs_destroy(g);
    return meet;
}

/* u = 0.05 is outside, u = 0.2 beside the hole, u = 0.375 on both sides of it. */
static void beside_a_hole(void) {
    nurbs_meet *whole = lines(), *meet = NULL;
    nurbs_face *face = frame_face();
    int64_t branches = 0, nodes = 0, levels[8];
    int32_t complete = 0, kinds[8];
    CHECK_OK(nurbs_meet_trim(whole, face, &meet));
    CHECK_OK(nurbs_meet_counts(meet, &branches, &nodes, &complete));
    CHECK(branches == 3 && nodes == 6 && complete == 1);
    CHECK_OK(nurbs_meet_branches(meet, 8, levels, NULL, NULL, NULL, NULL));
    CHECK(levels[0] == 1 && levels[1] == 2 && levels[2] == 2);
    CHECK_OK(nurbs_meet_nodes(meet, 8, NULL, kinds, NULL, NULL, NULL));
    double length = 0;
    for (int i = 0; i < 3; ++i) {
        nurbs *space = NULL, *on = NULL;
        double domain[2];
        CHECK_OK(nurbs_meet_branch(meet, i, &space, &on));
        CHECK_OK(nurbs_domain(space, 0, domain));
        length += domain[1] - domain[0];
        nurbs_destroy(on);
        nurbs_destroy(space);
        CHECK_INT(kinds[2 * i], NURBS_NODE_BORDER);
    }
    CHECK(fabs(length - 3 * (0.75 + 0.5)) < 1e-9);
    nurbs_meet_destroy(meet);
    CHECK_OK(nurbs_meet_trim_with(whole, face, NULL, &meet));
    nurbs_meet_destroy(meet);
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.struct_size = 1;
    CHECK_FAILS(nurbs_meet_trim_with(whole, face, &call, &meet), NURBS_ERROR_OPTIONS, "struct_size");
    nurbs_face_destroy(face);
    nurbs_meet_destroy(whole);
}

static void refused(void) {
    nurbs_meet *whole = lines(), *none = (nurbs_meet *)(void *)check_poison();
    nurbs_face *face = frame_face();
    CHECK_FAILS(nurbs_meet_trim(NULL, face, &none), NURBS_ERROR_NULL, "meet is NULL");
    CHECK(none == NULL);
    none = (nurbs_meet *)(void *)check_poison();
    CHECK_FAILS(nurbs_meet_trim(whole, NULL, &none), NURBS_ERROR_NULL, "face is NULL");
    CHECK(none == NULL);
    CHECK_FAILS(nurbs_meet_trim(whole, face, NULL), NURBS_ERROR_NULL, "out");
    nurbs_face_destroy(face);
    nurbs_meet_destroy(whole);
}

int main(void) {
    beside_a_hole();
    refused();
    return check_summary("meet_trim");
}
