/* SPDX-License-Identifier: MIT */
/* Rays on faces and models, nearest points of faces, and sides of models. */
#include "models.h"

enum { most = 8 };

static const int32_t sure_hit = NURBS_RAY_HIT | NURBS_RAY_CERTIFIED;

/* The bottom of the box: [0, 1] x [0, 2] at z = 0, its normal down. */
static nurbs_face *bottom(void) {
    nurbs_face *faces[6];
    box_faces(faces);
    for (int i = 1; i < 6; ++i) {
        nurbs_face_destroy(faces[i]);
    }
    return faces[0];
}

static void a_face(void) {
    nurbs_face *face = bottom();
    const double from[] = {0.25, 1.5, 3, 0.25, 1.5, -3, 2, 2, 2, 1, 1, 1};
    const double along[] = {0, 0, -2, 0, 0, 2, 0, 0, -1, 0, 0, -1};
    double uv[8], t[4];
    int32_t status[4];
    CHECK_OK(nurbs_face_rays(face, 4, from, 0, 0, along, 0, 0, uv, t, status));
    CHECK(t[0] == 1.5 && t[1] == 1.5);
    CHECK_INT(status[0], sure_hit | NURBS_RAY_BACK);
    CHECK_INT(status[1], sure_hit);
    CHECK_INT(status[2], NURBS_RAY_CERTIFIED);
    CHECK(isnan(t[2]) && isnan(uv[4]));
    CHECK_INT(status[3], NURBS_RAY_TOUCH); /* on the edge */
    CHECK_OK(nurbs_face_rays(face, 0, NULL, 0, 0, NULL, 0, 0, NULL, NULL, NULL));
    CHECK_OK(nurbs_face_rays(face, 2, from, 0, 0, along, 0, 0, NULL, t, NULL));
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.work = 1;
    CHECK_OK(nurbs_face_rays_with(face, 4, from, 0, 0, along, 0, 0, uv, t, status, &call));
    CHECK(status[3] == 0 && isnan(t[3]));
    CHECK_OK(nurbs_face_rays_with(face, 1, from, 0, 0, along, 0, 0, uv, t, status, NULL));
    CHECK_INT(status[0], sure_hit | NURBS_RAY_BACK);
    nurbs_face_destroy(face);
}

/* Over it, beside an edge, beside a corner. */
static void nearest(void) {
    nurbs_face *face = bottom();
    const double from[] = {0.25, 1.5, 3, 0.5, 4, 0, 4, 6, 12};
    double uv[6], feet[9], distances[3];
    int32_t status[3];
    CHECK_OK(nurbs_face_closest_points(face, 3, from, 0, 0, 1e-9, uv, feet, distances, status));
    CHECK_NEAR(distances, VALUES(3, 2, 13), 3, 2e-9);
    CHECK_NEAR(feet, VALUES(0.25, 1.5, 0, 0.5, 2, 0, 1, 2, 0), 9, 1e-8);
    CHECK_INT(status[0], NURBS_CLOSEST_CERTIFIED);
    CHECK_INT(status[1], NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_BOUNDARY);
    CHECK_INT(status[2], NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_BOUNDARY);
    CHECK_OK(nurbs_face_closest_points(face, 1, from, 0, 0, 0, NULL, NULL, distances, NULL));
    CHECK_NEAR(distances, VALUES(3), 1, 1e-14);
    CHECK_OK(nurbs_face_closest_points(face, 0, NULL, 0, 0, 0, NULL, NULL, NULL, NULL));
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    CHECK_OK(nurbs_face_closest_points_with(face, 3, from, 0, 0, 1e-9, uv, feet, distances, status, &call));
    CHECK_INT(status[0], NURBS_CLOSEST_CERTIFIED);
    call.work = 1;
    CHECK_OK(nurbs_face_closest_points_with(face, 3, from, 0, 0, 1e-9, uv, feet, distances, status, &call));
    nurbs_face_destroy(face);
}

static void refused_nearest(void) {
    nurbs_face *face = bottom();
    double from[] = {0.5, 0.25, 3, 1, 1, NAN}, uv[4], feet[6], t[2];
    int32_t status[2];
    FILL(uv);
    FILL(feet);
    FILL(t);
    FILL(status);
    CHECK_FAILS(nurbs_face_closest_points(NULL, 1, from, 0, 0, 0, uv, feet, t, status), NURBS_ERROR_NULL,
                "face is NULL");
    CHECK_FAILS(nurbs_face_closest_points(face, -1, from, 0, 0, 0, uv, feet, t, status), NURBS_ERROR_COUNT,
                "n = -1");
    CHECK_FAILS(nurbs_face_closest_points(face, 1, NULL, 0, 0, 0, uv, feet, t, status), NURBS_ERROR_NULL,
                "points");
    CHECK_FAILS(nurbs_face_closest_points(face, 1, from, -1, 0, 0, uv, feet, t, status), NURBS_ERROR_STRIDE,
                "point");
    CHECK_FAILS(nurbs_face_closest_points(face, 1, from, 0, 0, -1, uv, feet, t, status),
                NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_face_closest_points(face, 2, from, 0, 0, 0, uv, feet, t, status),
                NURBS_ERROR_POINT_NOT_FINITE, "points[1][2]");
    CHECK_FAILS(nurbs_face_closest_points(face, 1, from, 0, 0, 0, uv, feet, feet + 1, status),
                NURBS_ERROR_OVERLAP, "distances|feet");
    CHECK_UNTOUCHED(uv);
    CHECK_UNTOUCHED(feet);
    CHECK_UNTOUCHED(t);
    CHECK_UNTOUCHED(status);
    nurbs_face_destroy(face);
}

static void instances(void) {
    nurbs_model *model = box();
    int64_t count = -1, parents[1] = {7}, uses[1] = {7}, parts[1] = {7};
    double placements[12];
    CHECK_OK(nurbs_model_instances(model, 0, NULL, NULL, NULL, NULL, &count));
    CHECK_INT(count, 1);
    CHECK_OK(nurbs_model_instances(model, 1, parents, uses, parts, placements, NULL));
    CHECK(parents[0] == -1 && uses[0] == 0 && parts[0] == 0);
    CHECK_DOUBLES(placements, VALUES(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0), 12);
    nurbs_model_destroy(model);
}

static void a_box(void) {
    nurbs_model *model = box();
    const double from[] = {0.5, 1.2, 9, 0.5, 1.2, 1.5, 9, 9, 9, -1, -1, 0.5},
                 along[] = {0, 0, -1, 1, 0, 0, 1, 0, 0, 1, 1, 0};
    double uv[8], t[4];
    int32_t status[4];
    int64_t places[8];
    CHECK_OK(nurbs_model_rays(model, 4, from, along, uv, t, status, places));
    CHECK(t[0] == 6 && status[0] == sure_hit && places[0] == 1 && places[1] == 0);
    CHECK(t[1] == 0.5 && status[1] == (sure_hit | NURBS_RAY_BACK) && places[2] == 5);
    CHECK(isnan(t[2]) && status[2] == NURBS_RAY_CERTIFIED && places[4] == -1 && places[5] == -1);
    CHECK_INT(status[3], NURBS_RAY_TOUCH); /* an edge */
    CHECK(fabs(t[3] - 1) < 1e-7 && places[7] == 0);
    CHECK_OK(nurbs_model_rays(model, 0, NULL, NULL, NULL, NULL, NULL, NULL));
    int64_t count = -1;
    int32_t kinds[most], complete = -1;
    CHECK_OK(nurbs_model_ray_hits(model, from, along, NULL, most, NULL, t, kinds, places, &count, &complete));
    CHECK(count == 2 && complete == 1 && t[0] == 6 && t[1] == 9 && places[0] == 1 && places[2] == 0);
    CHECK(kinds[0] == NURBS_RAY_HIT && kinds[1] == (NURBS_RAY_HIT | NURBS_RAY_BACK));
    CHECK_OK(
        nurbs_model_ray_hits(model, from, along, VALUES(7, 100), 0, NULL, NULL, NULL, NULL, &count, NULL));
    CHECK_INT(count, 1);
    CHECK_OK(
        nurbs_model_ray_hits(model, from + 9, along + 9, NULL, 0, NULL, NULL, NULL, NULL, &count, &complete));
    CHECK(count >= 2 && complete == 0); /* the edge, of both faces */
    nurbs_model_destroy(model);
}

static void sides(void) {
    nurbs_model *model = box();
    const double at[] = {0.5, 1, 1.5, 2, 1, 1.5, 0.5, 1, 1e-4, 0.5, 1, -1e-4, 0.5, 1, 0};
    int32_t found[5];
    CHECK_OK(nurbs_model_classify(model, 5, at, 0, 0, 0, found));
    CHECK(found[0] == NURBS_SIDE_INSIDE && found[1] == NURBS_SIDE_OUTSIDE && found[2] == NURBS_SIDE_INSIDE);
    CHECK(found[3] == NURBS_SIDE_OUTSIDE && found[4] == NURBS_SIDE_UNDECIDED);
    CHECK_OK(nurbs_model_classify(model, 5, at, 0, 0, 1e-3, found));
    CHECK(found[0] == NURBS_SIDE_INSIDE && found[1] == NURBS_SIDE_OUTSIDE);
    CHECK(found[2] == NURBS_SIDE_ON && found[3] == NURBS_SIDE_ON && found[4] == NURBS_SIDE_ON);
    const double apart[] = {0.5, 9, 1, 9, 1.5, 9}; /* x, y, z of two places */
    CHECK_OK(nurbs_model_classify(model, 2, apart, 1, 2, 0, found));
    CHECK(found[0] == NURBS_SIDE_INSIDE && found[1] == NURBS_SIDE_OUTSIDE);
    CHECK_OK(nurbs_model_classify(model, 0, NULL, 0, 0, 0, NULL));
    nurbs_model_destroy(model);
}

static void watched(void) {
    nurbs_model *model = box();
    const double from[] = {0.5, 1.2, 9, 0.5, 1.2, 9}, along[] = {0, 0, -1, 0, 0, -1};
    double t[2];
    int32_t status[2], complete = -1;
    int64_t count = -1;
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    CHECK_OK(nurbs_model_rays_with(model, 2, from, along, NULL, t, status, NULL, &call));
    CHECK(t[1] == 6 && status[1] == sure_hit);
    call.work = 1;
    CHECK_OK(nurbs_model_rays_with(model, 2, from, along, NULL, t, status, NULL, &call));
    CHECK(isnan(t[1]) && status[1] == 0);
    CHECK_OK(nurbs_model_ray_hits_with(model, from, along, NULL, 0, NULL, NULL, NULL, NULL, &count, &complete,
                                       &call));
    CHECK_INT(complete, 0);
    CHECK_OK(nurbs_model_classify_with(model, 2, from, 0, 0, 0, status, &call));
    CHECK_INT(status[1], NURBS_SIDE_UNDECIDED);
    call.struct_size = 1;
    CHECK_FAILS(nurbs_model_rays_with(model, 2, from, along, NULL, t, status, NULL, &call),
                NURBS_ERROR_OPTIONS, "struct_size");
    nurbs_model_destroy(model);
}

static void refused_rays(void) {
    nurbs_face *face = bottom();
    nurbs_model *model = box();
    double from[] = {0.5, 0.25, 3, 1, 1, NAN}, down[] = {0, 0, -1, 0, 0, 0}, uv[2 * most], t[most];
    int32_t status[most], complete = 0;
    int64_t count = 0, places[2 * most];
    FILL(uv);
    FILL(t);
    FILL(status);
    CHECK_FAILS(nurbs_face_rays(NULL, 1, from, 0, 0, down, 0, 0, uv, t, status), NURBS_ERROR_NULL,
                "face is NULL");
    CHECK_FAILS(nurbs_face_rays(face, -1, from, 0, 0, down, 0, 0, uv, t, status), NURBS_ERROR_COUNT,
                "n = -1");
    CHECK_FAILS(nurbs_face_rays(face, 2, from, 0, 0, down, 0, 0, uv, t, status), NURBS_ERROR_POINT_NOT_FINITE,
                "origins[1][2]");
    CHECK_FAILS(nurbs_model_rays(NULL, 1, from, down, uv, t, status, places), NURBS_ERROR_NULL,
                "model is NULL");
    CHECK_FAILS(nurbs_model_rays(model, -1, from, down, uv, t, status, places), NURBS_ERROR_COUNT, "n = -1");
    CHECK_FAILS(nurbs_model_rays(model, 1, NULL, down, uv, t, status, places), NURBS_ERROR_NULL, "origins");
    CHECK_FAILS(nurbs_model_rays(model, 1, from, NULL, uv, t, status, places), NURBS_ERROR_NULL,
                "directions");
    CHECK_FAILS(nurbs_model_rays(model, INT64_MAX, from, down, uv, t, status, places), NURBS_ERROR_OVERFLOW,
                "origins");
    CHECK_FAILS(nurbs_model_rays(model, 2, from, down, uv, t, status, places), NURBS_ERROR_POINT_NOT_FINITE,
                "origins[1][2]");
    from[5] = 1;
    CHECK_FAILS(nurbs_face_rays(face, 2, from, 0, 0, down, 0, 0, uv, t, status), NURBS_ERROR_DIRECTION,
                "directions[1]");
    CHECK_FAILS(nurbs_model_rays(model, 2, from, down, uv, t, status, places), NURBS_ERROR_DIRECTION,
                "directions[1]");
    CHECK_FAILS(nurbs_model_rays(model, 1, from, down, uv, uv + 1, status, places), NURBS_ERROR_OVERLAP,
                "distances|params");
    CHECK_FAILS(nurbs_model_ray_hits(model, NULL, down, NULL, most, uv, t, status, places, &count, &complete),
                NURBS_ERROR_NULL, "origin");
    CHECK_FAILS(
        nurbs_model_ray_hits(model, from, down + 3, NULL, most, uv, t, status, places, &count, &complete),
        NURBS_ERROR_DIRECTION, "direction is 0");
    CHECK_FAILS(
        nurbs_model_ray_hits(model, from, down, VALUES(1, 0), most, uv, t, status, places, &count, &complete),
        NURBS_ERROR_EMPTY_DOMAIN, "range");
    CHECK_FAILS(nurbs_model_ray_hits(model, from, down, NULL, -1, uv, t, status, places, &count, &complete),
                NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_model_ray_hits(model, from, down, NULL, 1, uv, t, status, places, &count, &complete),
                NURBS_ERROR_SIZE, "cap = 1");
    CHECK_UNTOUCHED(uv);
    CHECK_UNTOUCHED(t);
    CHECK_UNTOUCHED(status);
    nurbs_model_destroy(model);
    nurbs_face_destroy(face);
}

static void refused_sides(void) {
    nurbs_face *faces[6];
    box_faces(faces);
    nurbs_model *model = box(), *open = NULL;
    CHECK_OK(nurbs_model_create(5, (const nurbs_face *const *)faces, 1, &open));
    const double at[] = {0, 0, 0, 0, 0, NAN};
    int32_t found[2];
    int64_t n[2];
    FILL(found);
    CHECK_FAILS(nurbs_model_classify(NULL, 1, at, 0, 0, 0, found), NURBS_ERROR_NULL, "model is NULL");
    CHECK_FAILS(nurbs_model_classify(model, -1, at, 0, 0, 0, found), NURBS_ERROR_COUNT, "n = -1");
    CHECK_FAILS(nurbs_model_classify(model, 1, NULL, 0, 0, 0, found), NURBS_ERROR_NULL, "points");
    CHECK_FAILS(nurbs_model_classify(model, 1, at, 0, 0, 0, NULL), NURBS_ERROR_NULL, "sides");
    CHECK_FAILS(nurbs_model_classify(model, 2, at, -1, 0, 0, found), NURBS_ERROR_STRIDE, "point");
    CHECK_FAILS(nurbs_model_classify(model, 1, at, 0, 0, -1, found), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_model_classify(model, 2, at, 0, 0, 0, found), NURBS_ERROR_POINT_NOT_FINITE,
                "points[1][2]");
    CHECK_FAILS(nurbs_model_classify(open, 1, at, 0, 0, 0, found), NURBS_ERROR_GAP, "is used 1 times");
    CHECK_UNTOUCHED(found);
    CHECK_FAILS(nurbs_model_instances(NULL, 0, NULL, NULL, NULL, NULL, NULL), NURBS_ERROR_NULL,
                "model is NULL");
    CHECK_FAILS(nurbs_model_instances(model, -1, n, NULL, NULL, NULL, NULL), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_model_instances(model, 1, n, n, NULL, NULL, NULL), NURBS_ERROR_OVERLAP,
                "last_uses|parents");
    nurbs_model_destroy(open);
    nurbs_model_destroy(model);
    for (int i = 0; i < 6; ++i) {
        nurbs_face_destroy(faces[i]);
    }
}

int main(void) {
    a_face();
    nearest();
    instances();
    a_box();
    sides();
    watched();
    refused_rays();
    refused_nearest();
    refused_sides();
    return check_summary("model_rays");
}
