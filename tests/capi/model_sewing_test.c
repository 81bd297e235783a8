/* SPDX-License-Identifier: MIT */
/* Faces that are sewn: which edges become common, what edges tell of their faces, and what is refused. */
#include "models.h"

static nurbs_face *faces_[6];
static nurbs_model *out_;

static const nurbs_face *const *given(void) {
    return (const nurbs_face *const *)faces_;
}

static nurbs_face *whole(const nurbs *surface, double tolerance) {
    nurbs_face *face = NULL;
    CHECK_OK(nurbs_face_create(surface, 0, NULL, NULL, NULL, NULL, tolerance, 0, NULL, &face));
    return face;
}

static nurbs_face *plane_face(double x, double y, double z, double width, double height) {
    nurbs *surface = NULL;
    CHECK_OK(nurbs_surface_plane(3, VALUES(x, y, z), VALUES(width, 0, 0), VALUES(0, height, 0), &surface));
    nurbs_face *face = whole(surface, 0);
    nurbs_destroy(surface);
    return face;
}

static nurbs_model *sewn(int64_t count, nurbs_face **faces, double tolerance) {
    nurbs_model *model = NULL;
    CHECK_OK(nurbs_model_sew(count, (const nurbs_face *const *)faces, tolerance, 0, &model));
    for (int64_t i = 0; i < count; ++i) {
        nurbs_face_destroy(faces[i]);
    }
    return model;
}

static void check_counts(const nurbs_model *model, int64_t faces, int64_t edges, int64_t vertices,
                         int64_t common) {
    int64_t n[5] = {-1, -1, -1, -1, -1}, uses[32], count = -1, found = 0;
    CHECK_OK(nurbs_model_counts(model, &n[0], &n[1], &n[2], &n[3], &n[4]));
    CHECK_INT(n[0], 1);
    CHECK_INT(n[1], 1);
    CHECK_INT(n[2], faces);
    CHECK_INT(n[3], edges);
    CHECK_INT(n[4], vertices);
    CHECK_OK(nurbs_model_edge_gaps(model, 32, uses, NULL, NULL, &count));
    CHECK_INT(count, edges);
    for (int64_t i = 0; i < count; ++i) {
        found += uses[i] > 1 ? 1 : 0;
    }
    CHECK_INT(found, common);
}

/* Of faces whose keys and edges nobody asks for. */
static void a_box(void) {
    nurbs_model *model = NULL;
    nurbs_list *list = NULL;
    double volume = 0, metres = 0, gaps[12];
    int32_t proven[12];
    CHECK_OK(nurbs_model_sew(6, given(), 1e-6, 0.001, &model));
    check_counts(model, 6, 12, 8, 12);
    CHECK_OK(nurbs_model_volume(model, 0, &volume, NULL, NULL, NULL, NULL));
    CHECK_NEAR(&volume, VALUES(6), 1, 1e-13);
    CHECK_OK(nurbs_model_edge_gaps(model, 12, NULL, gaps, proven, NULL));
    for (int i = 0; i < 12; ++i) {
    }
    CHECK_OK(nurbs_model_splines(model, &list));
    CHECK_OK(nurbs_list_unit(list, &metres));
    CHECK_DOUBLE(metres, 0.001);
    nurbs_list_destroy(list);
    nurbs_model_destroy(model);
}

/* A long side at two short ones; the distance of the upper plane is just within the tolerance, or not. */
static void one_side_at_two(void) {
    double gaps[32];
    int64_t uses[32];
    nurbs_face *three[] = {plane_face(0, 0, 0, 2, 1), plane_face(0, 1, 0.01, 0.5, 1),
                           plane_face(0.5, 1, 0.01, 1.5, 1)};
    nurbs_face *again[] = {plane_face(0, 0, 0, 2, 1), plane_face(0, 1, 0.01, 0.5, 1),
                           plane_face(0.5, 1, 0.01, 1.5, 1)};
    nurbs_model *model = sewn(3, three, 0.0101);
    check_counts(model, 3, 10, 8, 3);
    CHECK_OK(nurbs_model_edge_gaps(model, 32, uses, gaps, NULL, NULL));
    for (int i = 0; i < 10; ++i) {
        CHECK(gaps[i] < 1e-13 || (uses[i] == 2 && fabs(gaps[i] - 0.01) < 1e-12));
    }
    nurbs_model_destroy(model);
    model = sewn(3, again, 0.0099);
    check_counts(model, 3, 11, 10, 1);
    nurbs_model_destroy(model);
}

/* Nothing of a sphere is open; half of one ends at its equator, where a disk meets it. */
static void without_edges(void) {
    nurbs *surface = NULL;
    nurbs_face *faces[2];
    CHECK_OK(nurbs_surface_sphere(NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &surface));
    faces[0] = whole(surface, 0);
    nurbs_model *model = sewn(1, faces, 1e-9);
    check_counts(model, 1, 0, 0, 0);
    nurbs_model_destroy(model);
    nurbs_destroy(surface);
    CHECK_OK(nurbs_surface_spherical_patch(NULL, NULL, NULL, 1, 0, 6.283185307179586, 0, 1.5707963267948966,
                                           NURBS_ARC_QUARTERS, &surface));
    faces[0] = whole(surface, 0);
    nurbs_destroy(surface);
    CHECK_OK(nurbs_surface_plane(3, VALUES(-2, -2, 0), VALUES(4, 0, 0), VALUES(0, 4, 0), &surface));
    nurbs *circle = circle_in_domain(0.5, 0.5, 0.25);
    faces[1] = face_of(surface, 1, CURVES(circle));
    nurbs_destroy(circle);
    nurbs_destroy(surface);
    model = sewn(2, faces, 1e-9);
    check_counts(model, 2, 1, 1, 1);
    nurbs_model_destroy(model);
}

static int32_t go_on(double done, void *user) {
    (void)done;
    (void)user;
    return 0;
}

static void watched(void) {
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, (int64_t)sizeof call));
    call.progress = go_on;
    CHECK_OK(nurbs_model_sew_with(6, given(), 1e-6, 1, &call, &out_));
    check_counts(out_, 6, 12, 8, 12);
    nurbs_model_destroy(out_);
    CHECK_OK(nurbs_model_sew_with(6, given(), 1e-6, 1, NULL, &out_));
    nurbs_model_destroy(out_);
    call.work = 1;
    CHECK_NO_MODEL(out_, nurbs_model_sew_with(6, given(), 1e-6, 1, &call, &out_), NURBS_ERROR_WORK, "");
    call.work = -1;
    CHECK_NO_MODEL(out_, nurbs_model_sew_with(6, given(), 1e-6, 1, &call, &out_), NURBS_ERROR_OPTIONS,
                   "work");
}

static void refused(void) {
    CHECK_FAILS(nurbs_model_sew(6, given(), 1, 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_model_sew_with(6, given(), 1, 0, NULL, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_MODEL(out_, nurbs_model_sew(6, NULL, 1, 0, &out_), NURBS_ERROR_NULL, "faces");
    CHECK_NO_MODEL(out_, nurbs_model_sew(0, given(), 1, 0, &out_), NURBS_ERROR_COUNT, "count = 0");
    CHECK_NO_MODEL(out_, nurbs_model_sew(-1, given(), 1, 0, &out_), NURBS_ERROR_COUNT, "count = -1");
    CHECK_NO_MODEL(out_, nurbs_model_sew(INT64_MAX, given(), 1, 0, &out_), NURBS_ERROR_OVERFLOW, "faces");
    const double tolerances[] = {0, -1e-6, NAN, INFINITY};
    for (int i = 0; i < 4; ++i) {
        CHECK_NO_MODEL(out_, nurbs_model_sew(6, given(), tolerances[i], 0, &out_), NURBS_ERROR_TOLERANCE,
                       "tolerance = |expected");
    }
    const double metres[] = {-1, NAN, INFINITY};
    for (int i = 0; i < 3; ++i) {
        CHECK_NO_MODEL(out_, nurbs_model_sew(6, given(), 1e-6, metres[i], &out_), NURBS_ERROR_FACTOR,
                       "metres");
    }
    const nurbs_face *missing[] = {faces_[0], NULL};
    CHECK_NO_MODEL(out_, nurbs_model_sew(2, missing, 1e-6, 0, &out_), NURBS_ERROR_NULL, "faces[1] is NULL");
    nurbs *flat = NULL;
    CHECK_OK(nurbs_surface_plane(2, VALUES(0, 0), VALUES(1, 0), VALUES(0, 1), &flat));
    nurbs_face *plane = whole(flat, 0);
    const nurbs_face *wrong[] = {faces_[0], faces_[1], plane};
    CHECK_NO_MODEL(out_, nurbs_model_sew(3, wrong, 1e-6, 0, &out_), NURBS_ERROR_DIMENSION, "faces[2]");
    nurbs_face_destroy(plane);
    nurbs_destroy(flat);
}

/* One handle, and two of equal faces. */
static void given_twice(void) {
    const nurbs_face *twice[] = {faces_[3], faces_[1], faces_[3]};
    CHECK_NO_MODEL(out_, nurbs_model_sew(3, twice, 1e-6, 0, &out_), NURBS_ERROR_SAME, "faces[2]|faces[0]");
    nurbs_face *equal[] = {plane_face(0, 0, 0, 1, 1), plane_face(0, 0, 0, 1, 1)};
    CHECK_NO_MODEL(out_, nurbs_model_sew(2, (const nurbs_face *const *)equal, 1e-6, 0, &out_),
                   NURBS_ERROR_SAME, "faces[1]|faces[0]");
    nurbs_face_destroy(equal[0]);
    nurbs_face_destroy(equal[1]);
}

static void gaps_refused(void) {
    nurbs_model *model = box();
    int64_t uses[12], count = -1;
    double gaps[12];
    int32_t proven[12];
    FILL(uses);
    FILL(gaps);
    FILL(proven);
    CHECK_FAILS(nurbs_model_edge_gaps(NULL, 0, NULL, NULL, NULL, NULL), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_edge_gaps(model, -1, uses, gaps, proven, &count), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_model_edge_gaps(model, 11, uses, gaps, proven, &count), NURBS_ERROR_SIZE,
                "cap = 11|12");
    CHECK_FAILS(nurbs_model_edge_gaps(model, 12, uses, gaps, proven, uses), NURBS_ERROR_OVERLAP,
                "uses|count");
    CHECK_INT(count, -1);
    CHECK_UNTOUCHED(uses);
    CHECK_UNTOUCHED(gaps);
    CHECK_UNTOUCHED(proven);
    CHECK_OK(nurbs_model_edge_gaps(model, 0, NULL, NULL, NULL, &count));
    CHECK_INT(count, 12);
    CHECK_OK(nurbs_model_edge_gaps(model, 12, uses, gaps, proven, NULL));
    for (int i = 0; i < 12; ++i) {
        CHECK(uses[i] == 2 && gaps[i] < 1e-13 && proven[i] == 1);
    }
    nurbs_model_destroy(model);
}

int main(void) {
    box_faces(faces_);
    a_box();
    one_side_at_two();
    without_edges();
    watched();
    refused();
    given_twice();
    gaps_refused();
    for (int i = 0; i < 6; ++i) {
        nurbs_face_destroy(faces_[i]);
    }
    return check_summary("model_sewing");
}
